#include "snug/base/symmetric.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace snug {
namespace {

constexpr int kMostSweeps = 12;  // it converges quadratically: four or five do

}  // namespace

PrincipalAxes principal_axes(const Symmetric& matrix) {
    double a[3][3] = {{matrix.xx, matrix.xy, matrix.xz},
                      {matrix.xy, matrix.yy, matrix.yz},
                      {matrix.xz, matrix.yz, matrix.zz}};
    std::array<Vec3d, 3> axis = {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
            if (a[p][q] == 0) continue;
            // The turn in the plane of p and q that makes this entry zero.
            const double half = (a[q][q] - a[p][p]) / (2 * a[p][q]);
            const double tangent = (half < 0 ? -1 : 1) / (std::fabs(half) + std::sqrt(half * half + 1));
            const double c = 1 / std::sqrt(tangent * tangent + 1), s = tangent * c;
            for (int k = 0; k < 3; ++k) {
                const double at_p = a[k][p], at_q = a[k][q];
                a[k][p] = c * at_p - s * at_q;
                a[k][q] = s * at_p + c * at_q;
            }
            for (int k = 0; k < 3; ++k) {
                const double at_p = a[p][k], at_q = a[q][k];
                a[p][k] = c * at_p - s * at_q;
                a[q][k] = s * at_p + c * at_q;
            }
            a[p][q] = a[q][p] = 0;
            Vec3d& first = axis[static_cast<std::size_t>(p)];
            Vec3d& second = axis[static_cast<std::size_t>(q)];
            const Vec3d was = first;
            first = was * c - second * s;
            second = was * s + second * c;
        }
    }
    std::array<std::size_t, 3> order = {0, 1, 2};
    const double value[3] = {a[0][0], a[1][1], a[2][2]};
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return value[i] > value[j]; });
    PrincipalAxes axes;
    for (std::size_t i = 0; i < 3; ++i) {
        axes.value[i] = value[order[i]];
        axes.axis[i] = axis[order[i]];
    }
    return axes;
}

}  // namespace snug
