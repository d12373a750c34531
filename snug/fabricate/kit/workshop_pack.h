#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/finding.h"
#include "snug/drawing/drawing.h"
#include "snug/fabricate/kit/item_labels.h"
#include "snug/foam/block_map.h"
#include "snug/foam/foams.h"
#include "snug/formats/mesh_files.h"
#include "snug/space/design_space.h"
#include "snug/words/words.h"

// What a maker takes to the workshop. Each way of working (sponge, sheets, print, ...) has one function from
// a FoamDesign and its own options to a WorkshopPack.

namespace snug {

/// The foams as a maker's drawings need them. References live as long as the packing that they belong to.
struct FoamDesign {
    const DesignSpace& space;
    std::span<const BlockMap> layers;  ///< what each layer of items cuts, the lowest first
    const Foams& foams;
    const Grid<Run>& available;              ///< blocks that exist
    std::string object_name;                 ///< as people know it; UTF-8
    Language language = Language::english;   ///< of pages and pictures
    std::span<const ItemLabel> labels = {};  ///< to be written beside items

    /// A piece as it is worked from the side that is looked at first.
    [[nodiscard]] SeenPiece seen(Piece piece) const { return seen_piece(foams, piece, space.blocks.x); }
};

/// A file to be written, by its name within the output folder ("sheets/lower-01.svg").
struct PackFile {
    std::string name;
    FileBytes bytes;
};

[[nodiscard]] PackFile text_file(std::string name, std::string_view text);

/// A zip file in the making: 3MF. The writer around the library packs it.
struct PackContainer {
    std::string name;
    std::vector<PackFile> members;  ///< in the order in which they must stand
};

/// A line of what is shown before anything is written: "Blocks to pluck" "1,204".
struct PackFigure {
    Message label;
    Message value;
};

/// The ways that make foams of several layers, for a sentence that refuses another.
[[nodiscard]] std::vector<Message> ways_for_layers();

/// "1.25 litres"
[[nodiscard]] Message litres_text(double litres);

/// A pack and its material in numbers, all copies together. A pack fills in what it knows better than the
/// foams alone do.
struct PackMaterial {
    std::optional<long long> pieces;  ///< handled one by one: blocks plucked, sheets, printed parts
    std::optional<double> litres;     ///< to buy or use up; none: the foams' own volume
    std::optional<double> foam_kg;    ///< of what is left of one copy; from the density, see processes.h
    std::optional<double> cost;       ///< from the price of a litre
    int copies = 1;                   ///< of the foams
};

struct WorkshopPack {
    std::vector<PackFile> files;
    std::vector<DrawingDocument> documents;  ///< become PDF
    std::vector<PackContainer> containers;
    std::vector<PackFigure> figures;
    std::vector<Finding> findings;
    PackMaterial material;
};

}  // namespace snug
