#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "snug/drawing/drawing.h"
#include "snug/words/words.h"

namespace snug {

constexpr double kMmPerPx = 25.4 / 96;  // of a screen, as SVG counts

/// How a line looks, px.
struct Stroke {
    Color color;
    double px = 1;
    std::vector<double> dashes_px{};
    double opacity = 1;
    bool round_joins = false, round_ends = false;
};

struct Fill {
    Color color;
    double opacity = 1;
};

/// How letters look, px.
struct Lettering {
    Color color;
    bool bold = false;
    double spacing_px = 0;
    double opacity = 1;
    std::optional<Stroke> halo{};
    TextAnchor anchor = TextAnchor::start;
};

/// Draws a picture for the screen into a display list. Everything is said in px, x to the right, y downward.
class Canvas {
  public:
    Canvas(std::string title, Language language);

    /// Later items belong to this layer. `step_px` above 0: for many small shapes, see DrawingLayer.
    void layer(const std::string& name, double step_px = 0);

    void line(Vec2d from, Vec2d to, const Stroke& stroke);
    /// Loops that fill together, by the even-odd rule.
    void loops(std::vector<std::vector<Vec2d>> loops, const std::optional<Fill>& fill,
               const std::optional<Stroke>& stroke = {});
    void rectangle(Vec2d corner, Vec2d size, const std::optional<Fill>& fill,
                   const std::optional<Stroke>& stroke = {}, double corner_radius = 0);
    void circle(Vec2d centre, double radius, const Fill& fill, const Stroke& stroke);
    /// Baseline at `at`.
    void text(Vec2d at, double size, const Lettering& look, std::string words, std::string lead = {});
    /// Text in a plane of the picture, centred on `centre`.
    void text_in_plane(Vec2d centre, const TextPlane& plane, double size, Lettering look, std::string words);

    /// A filled polygon among many: its edge in the same colour closes the seams between neighbours. Those of
    /// one colour that follow each other are one path, so they must all run the same way round.
    void facet(Color color, const std::vector<Vec2d>& corners, double edge_px);
    /// A line among many facets.
    void facet_line(Color color, Vec2d from, Vec2d to, double px);

    [[nodiscard]] Drawing finish(Vec2d size_px);

  private:
    void add(PathItem path);
    /// The last item, if it is a path of this layer that goes on with this colour.
    [[nodiscard]] PathItem* going_on(bool closed, Color color);

    Drawing drawing_;
    int layer_ = 0;
};

}  // namespace snug
