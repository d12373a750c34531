#include "snug/formats/gltf_gather.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "snug/formats/gltf_json.h"
#include "snug/mesh/left_out.h"

namespace snug::gltf {
namespace {

// What a scene may come to: some copies of anything, and in a large file as much as its bytes can say.
constexpr std::uint64_t kAlwaysTriangles = 2'500'000, kTrianglesPerByte = 2, kMostTriangles = 400'000'000;
constexpr std::uint64_t kEffortPerCorner = 8;  // morphs and joints
constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

}  // namespace

Result<void> Gatherer::announce(const Primitive& primitive, std::uint64_t copies, std::uint64_t per_copy,
                                std::uint64_t bytes) {
    const std::uint64_t most =
        std::min(kMostTriangles, std::max(kAlwaysTriangles, kTrianglesPerByte * bytes));
    // Neither can overflow: a count above the limit is cut off there.
    const std::uint64_t corners = std::min(primitive.corners(), 4 * most) * std::min(copies, 4 * most);
    corners_ += corners;
    effort_ += std::min(corners, 4 * most) * primitive.effort() + std::min(copies, 4 * most) * per_copy;
    const bool strips = primitive.topology == Topology::strip || primitive.topology == Topology::fan;
    if (corners_ > (strips ? most : 3 * most))
        return refuse(say("gltf.too_many_triangles", {{"most", most}}));
    if (effort_ > 3 * kEffortPerCorner * most) return refuse(say("gltf.too_many_mixed"));
    return {};
}

Result<void> Gatherer::add(const Primitive& primitive, const Affine& place, const std::vector<Affine>* pose) {
    place_ = place;
    pose_ = primitive.influence ? pose : nullptr;
    if (primitive.topology == Topology::points) return add_points(primitive);
    mirrored_ = place.mirrors() != (pose_ != nullptr && !pose_->empty() && pose_->front().mirrors());
    const auto count = static_cast<std::size_t>(primitive.positions.count());
    if (stamp_.size() < count) {
        stamp_.resize(count, 0);
        number_.resize(count);
    }
    ++now_;
    return add_triangles(primitive);
}

Result<Vec3d> Gatherer::placed(const Primitive& primitive, std::uint64_t point) const {
    const Vec3d own = primitive.point(point);
    if (pose_ == nullptr) return place_(own);
    const auto skinned = primitive.skinned(point, *pose_);
    if (!skinned) return refuse(say("gltf.no_joint"));
    return place_((*skinned)(own));
}

Result<void> Gatherer::add_points(const Primitive& primitive) {
    for (std::uint64_t i = 0; i < primitive.corners(); ++i) {
        const auto point = primitive.corner(i);
        if (!point) continue;
        if (*point >= primitive.positions.count()) return refuse(say("gltf.no_point"));
        const auto place = placed(primitive, *point);
        if (!place) return tl::unexpected(place.error());
        if (usable(*place))
            points_.push_back(*place);
        else
            ++notes_.left_out_points;
    }
    return {};
}

Result<void> Gatherer::add_triangles(const Primitive& primitive) {
    // The last corners: all of them of a triangle, the two before of a strip, the first and the one before of
    // a fan.
    std::uint64_t first = 0, second = 0, run = 0;
    for (std::uint64_t i = 0; i < primitive.corners(); ++i) {
        const auto corner = primitive.corner(i);
        if (!corner) {
            run = 0;
            continue;
        }
        Result<void> done;
        if (run == 0) {
            first = *corner;
        } else if (run == 1) {
            second = *corner;
        } else {
            const bool odd = primitive.topology == Topology::strip && run % 2 == 1;
            done = odd ? add_triangle(primitive, second, first, *corner)
                       : add_triangle(primitive, first, second, *corner);
        }
        if (!done) return done;
        if (run >= 2 && primitive.topology == Topology::strip) first = second;
        if (run >= 2) second = *corner;
        ++run;
        if (primitive.topology == Topology::triangles && run == 3) run = 0;
    }
    return {};
}

Result<void> Gatherer::add_triangle(const Primitive& primitive, std::uint64_t a, std::uint64_t b,
                                    std::uint64_t c) {
    ++notes_.faces;
    Triangle triangle{};
    bool whole = true;
    std::size_t i = 0;
    for (const std::uint64_t point : {a, b, c}) {
        const auto number = vertex(primitive, point);
        if (!number) return tl::unexpected(number.error());
        whole = whole && number->has_value();
        triangle[i++] = number->value_or(0);
    }
    if (!whole) {
        ++notes_.left_out_faces;
        return {};
    }
    // A mirroring node turns every triangle inside out; the other way round they face outward again.
    if (mirrored_) std::swap(triangle[1], triangle[2]);
    raw_.triangles.push_back(triangle);
    return {};
}

Result<std::optional<std::uint32_t>> Gatherer::vertex(const Primitive& primitive, std::uint64_t point) {
    if (point >= primitive.positions.count())
        return refuse(
            say("gltf.triangle_point", {{"point", point}, {"points", primitive.positions.count()}}));
    const auto at = static_cast<std::size_t>(point);
    if (stamp_[at] != now_) {
        const auto place = placed(primitive, point);
        if (!place) return tl::unexpected(place.error());
        if (raw_.vertices.size() >= kNoVertex - 1) return refuse(say("gltf.too_many_points"));
        stamp_[at] = now_;
        number_[at] = usable(*place) ? static_cast<std::uint32_t>(raw_.vertices.size()) : kNoVertex;
        if (number_[at] != kNoVertex) raw_.vertices.push_back(*place);
    }
    if (number_[at] == kNoVertex) return std::optional<std::uint32_t>{};
    return std::optional<std::uint32_t>(number_[at]);
}

Result<Mesh> Gatherer::take() && {
    if (2 * notes_.left_out_faces > notes_.faces)
        return refuse(
            say("gltf.most_left_out", {{"left_out", notes_.left_out_faces}, {"faces", notes_.faces}}));
    const std::size_t points = points_.size();
    if (raw_.triangles.empty() && points > 0 && 2 * notes_.left_out_points <= points + notes_.left_out_points)
        raw_.vertices = std::move(points_);
    else
        notes_.left_out_points = 0;
    const bool cloud = raw_.triangles.empty();
    if (cloud && raw_.vertices.empty()) return refuse(say("gltf.no_triangles"));
    auto mesh = cloud ? finish_cloud(std::move(raw_)) : finish(std::move(raw_));
    if (!mesh) return mesh;
    notes_.in_mm = true;
    mesh->read = notes_;
    return mesh;
}

}  // namespace snug::gltf
