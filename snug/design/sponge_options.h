#pragma once

#include <string_view>

#include "snug/base/names.h"
#include "snug/design/option.h"

namespace snug {

/// On what maps at true size are drawn: on the paper, to be joined; each on a sheet of its own size; nowhere.
enum class MapSheets { tiles, plotter, none };
template <>
struct Names<MapSheets> {
    static constexpr std::string_view list[] = {"tiles", "plotter", "none"};
};

struct SpongeOptions {
    MapSheets maps = MapSheets::tiles;
    friend bool operator==(const SpongeOptions&, const SpongeOptions&) = default;
};

template <class Visit>
void visit_options(Visit& visit, SpongeOptions& sponge) {
    visit.option(
        sponge.maps,
        {.json = "maps",
         .flag = "--maps",
         .label = {"the sheets of the maps", "原寸図の用紙"},
         .help = {"Sponge: maps at true size as tiles of the paper, each on one sheet for a plotter, or none",
                  "スポンジ：原寸図を用紙に分けて `tiles`、プロッター用の 1 枚に `plotter`、または作らない "
                  "`none`"}});
}

}  // namespace snug
