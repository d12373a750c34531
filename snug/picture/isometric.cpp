#include "snug/picture/isometric.h"

#include <algorithm>

namespace snug {
namespace {

// Steep enough to look into a cavity as deep as it is wide, and turned so that k still reads as "to the
// right".
constexpr struct {
    double sine, cosine;
} kAzimuth{0.5446390350150271, 0.8386705679454240},      // 33 degrees
    kElevation{0.7193398003386511, 0.6946583704589973};  // 46 degrees
constexpr double kGapShare = 0.09;                       // of the longer horizontal side

}  // namespace

Projected project(Vec3d scene) {
    const double across = scene.x * kAzimuth.cosine - scene.y * kAzimuth.sine;
    const double towards = scene.x * kAzimuth.sine + scene.y * kAzimuth.cosine;
    return {{across, towards * kElevation.sine - scene.z * kElevation.cosine},
            towards * kElevation.cosine + scene.z * kElevation.sine};
}

OpenedPair opened(const DesignSpace& space, int parting_level) {
    const Vec3d size = space.size();
    return {space.face(1, 0), space.face(0, parting_level), 0.5 * kGapShare * std::max(size.y, size.z)};
}

}  // namespace snug
