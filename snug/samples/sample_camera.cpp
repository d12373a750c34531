#include "snug/samples/sample_solids.h"

namespace snug {
namespace {

// In the words of someone who looks at the front of the camera: right, up, to the front. It is packed lying
// on its back, the lens upward (+x) and the viewfinder towards the back of the case (-y).
constexpr Vec3d kToTheRight{0, 0, 1};
constexpr Vec3d kUp{0, -1, 0};
constexpr Vec3d kTowardsFront{1, 0, 0};

constexpr double kLensRight = 9, kLensUp = -6;

Vec3d at(double right, double up, double front) {
    return kToTheRight * right + kUp * up + kTowardsFront * front;
}

Frame facing_front(double right, double up) {
    return {at(right, up, 0), kToTheRight, kUp, kTowardsFront};
}
Frame facing_up(double right, double front) {
    return {at(right, 0, front), kTowardsFront, kToTheRight, kUp};
}

void add_body(Mesh& mesh) {
    add_block(mesh, facing_front(0, -5), {126, 62, 13, -14, 14, 3.5});
    add_block(mesh, facing_front(0, -9), {127.4, 38, 4, -14.5, 14.5, 0.7});  // leather
    add_block(mesh, facing_front(-47, -7), {29, 55, 13, -8, 27, 10});        // grip
    add_block(mesh, facing_front(-50, 8), {20, 24, 8, -18, -6, 4});          // thumb rest
    add_block(mesh, facing_front(-2, -8), {72, 46, 3, -16, -10, 1});         // screen
    add_turned(mesh, facing_front(49, -13), {{{-16.5, 7.5}, {-16, 8.5}, {-10, 8.5}}},
               32);                                                    // dial on the back
    add_turned(mesh, {at(0, 0, 0), kToTheRight, kTowardsFront, -kUp},  // thread for a tripod
               {{{30, 10}, {37, 10}, {37.5, 9.5}}}, 32);
}

/// The hump over the prism: narrower with every step upward.
void add_viewfinder(Mesh& mesh) {
    struct Step {
        double up, width, depth, front;
    };
    static constexpr Step kHumpSteps[] = {{16, 52, 27, 0},   {25, 51, 27.4, 0},  {28, 49, 28, 0.5},
                                          {36, 38, 27, 0.5}, {42, 29, 24, -0.5}, {44.5, 26, 21, -1},
                                          {45.3, 23, 18, -1}};
    std::vector<std::vector<Vec3d>> rings;
    for (const Step& step : kHumpSteps) {
        std::vector<Vec3d> ring;
        for (const Point2& p : rounded_rectangle(step.depth, step.width, 5))
            ring.push_back(facing_up(kLensRight, step.front)(p, step.up));
        rings.push_back(std::move(ring));
    }
    add_loft(mesh, rings);
    add_block(mesh, facing_front(kLensRight, 33), {27, 18, 5, -20, -8, 2});  // eyepiece
    add_block(mesh, facing_front(kLensRight, 33), {17, 10, 2, -21, -16, 0.8});
    add_block(mesh, facing_up(kLensRight, -1), {16, 19, 1.5, 44, 46.6, 0.5});  // hot shoe and its rails
    for (const double side : {-1.0, 1.0}) {
        add_block(mesh, facing_up(kLensRight + side * 8.6, -1), {16, 1.8, 0.8, 45, 49.4, 0.4});
        add_block(mesh, facing_up(kLensRight + side * 7.6, -1), {16, 3.6, 0.8, 48.2, 49.6, 0.4});
    }
}

void add_lens(Mesh& mesh) {
    const Frame lens = facing_front(kLensRight, kLensUp);
    add_turned(mesh, lens, {{{8, 31}, {15.5, 31}, {17, 29.5}, {17, 28}}}, 72);  // mount
    add_turned(mesh, lens, {{{10, 27}, {24, 27}, {25, 27.8}, {26, 27.8}, {27, 26}, {46.2, 26}}},
               72);         // barrel
    add_turned(mesh, lens,  // zoom ring
               {{{19, 27}, {19.6, 29}, {20.4, 29.6, true}, {27.6, 29.6, true}, {28.4, 29}, {29, 27}}}, 144,
               {36, 1.1});
    add_turned(mesh, lens,  // focus ring
               {{{31.5, 27}, {32, 29.6}, {32.8, 30.4, true}, {42.2, 30.4, true}, {43, 29.6}, {43.5, 27}}},
               180, {45, 1.0});
    add_turned(mesh, lens,  // front: rim and the funnel down to the glass
               {{{44.5, 26},
                 {45.5, 30},
                 {47, 31.5},
                 {54, 31.5},
                 {55, 30.8},
                 {55, 29.4},
                 {53.5, 28.6},
                 {52, 26},
                 {50, 22.5},
                 {48, 20},
                 {47, 19}}},
               72);
    add_turned(mesh, lens,  // glass
               {{{45, 20}, {47, 20}, {48.6, 18}, {50.2, 15}, {51.4, 11}, {52.1, 6.5}, {52.4, 2}}}, 48);
    add_turned(mesh, facing_front(-24, 15), {{{10, 3.2}, {15.3, 3.2}, {16, 2.4}}}, 24);  // lamp
    add_turned(mesh, facing_front(-21, -20), {{{10, 4}, {17, 4}, {18, 3.2}}}, 24);       // lens release
}

void add_knobs(Mesh& mesh) {
    add_turned(mesh, facing_up(-48, 11), {{{15, 10.5}, {21, 10.5}, {23.5, 9}, {23.5, 8}}},
               40);  // shutter's collar
    add_turned(mesh, facing_up(-48, 11), {{{20, 6.2}, {25.4, 6.2}, {26.6, 5.4}, {27.2, 3.5}, {27.4, 1}}}, 32);
    add_turned(mesh, facing_up(46, -2), {{{20, 9}, {28, 9}}}, 40);  // mode dial on its neck
    add_turned(mesh, facing_up(46, -2),
               {{{27.2, 10.5}, {27.8, 11.5, true}, {34.2, 11.5, true}, {35, 10.6}, {35.2, 9.6}}}, 96,
               {24, 0.8});
    add_turned(mesh, facing_up(-27, -3),  // exposure dial
               {{{20, 8.6}, {26.8, 8.8}, {27.2, 9.4, true}, {31.4, 9.4, true}, {32, 8.6}}}, 80, {20, 0.7});
    for (const double side : {-1.0, 1.0}) {
        add_turned(mesh, {at(side * 60, 18, 0), kUp, kTowardsFront * side, kToTheRight * side},  // strap lugs
                   {{{0, 4}, {3.6, 4}, {4.4, 3.2}}}, 24);
        add_ring(mesh, {at(side * 66, 17, 0), kToTheRight, kUp, kTowardsFront}, 4.4, 1.1, 32, 10);
    }
}

}  // namespace

Mesh camera_sample() {
    Mesh mesh;
    add_body(mesh);
    add_viewfinder(mesh);
    add_lens(mesh);
    add_knobs(mesh);
    centre(mesh);
    return mesh;
}

}  // namespace snug
