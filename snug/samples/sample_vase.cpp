#include "snug/samples/sample_solids.h"

namespace snug {

Mesh vase_sample() {
    // Half of the vase as it stands: height and radius, up the outside, over the lip, down the inside.
    static constexpr Point2 kOutside[] = {{0, 34},   {2.5, 36.5}, {7, 37},     {13, 32},    {20, 29.5},
                                          {32, 35},  {60, 55},    {95, 69},    {128, 71},   {160, 60},
                                          {188, 41}, {206, 29},   {222, 23.5}, {240, 22.5}, {256, 26},
                                          {268, 33}, {275, 40}};
    static constexpr Point2 kLip[] = {{275, 40}, {278, 42.5}, {280, 41.5}, {279, 38.5}};
    static constexpr Point2 kInside[] = {{279, 38.5}, {268, 28.5}, {254, 20.5}, {239, 17},   {222, 17.5},
                                         {203, 23},   {184, 35},   {158, 53.5}, {128, 64.5}, {95, 62.5},
                                         {62, 49},    {38, 31},    {27, 20},    {23, 9},     {22, 2}};
    // A shallow hollow under the foot, so that it stands on a rim.
    static constexpr Point2 kUnderneath[] = {{5, 2}, {4.5, 18}, {2, 28}, {0, 31}, {0, 34}};

    std::vector<ProfilePoint> profile;
    const auto add = [&](std::span<const Point2> points, int steps) {
        for (const Point2& p : smooth_curve(points, steps))
            if (profile.empty() || p.a != profile.back().height || p.b != profile.back().radius)
                profile.push_back({p.a, p.b, false});
    };
    add(kUnderneath, 2);
    add(kOutside, 3);
    add(kLip, 2);
    add(kInside, 3);

    Mesh mesh;
    // On its side along z.
    add_turned(mesh, {{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, profile, 64);
    centre(mesh);
    return mesh;
}

}  // namespace snug
