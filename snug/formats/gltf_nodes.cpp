#include "snug/formats/gltf_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace snug::gltf {
namespace {

using Quaternion = std::array<double, 4>;  // x, y, z, w

Affine affine_of(Vec3d translation, Quaternion q, Vec3d scale) {
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (length > 0)
        for (double& each : q) each /= length;
    else
        q = {0, 0, 0, 1};
    const auto [x, y, z, w] = q;
    const std::array<Vec3d, 3> turn = {
        Vec3d{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
        Vec3d{2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
        Vec3d{2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    Affine result;
    for (std::size_t i = 0; i < 3; ++i)
        result.row[i] = {turn[i].x * scale.x, turn[i].y * scale.y, turn[i].z * scale.z};
    result.shift = translation;
    return result;
}

Result<Affine> local(const Json& node) {
    if (!field(node, "matrix").is_null()) {
        std::array<double, 16> m{};
        if (const auto read = numbers(node, "matrix", m); !read) return tl::unexpected(read.error());
        return Affine{{Vec3d{m[0], m[4], m[8]}, Vec3d{m[1], m[5], m[9]}, Vec3d{m[2], m[6], m[10]}},
                      {m[12], m[13], m[14]}};
    }
    std::array<double, 3> translation{}, scale{1, 1, 1};
    Quaternion rotation{0, 0, 0, 1};
    if (const auto read = numbers(node, "translation", translation); !read)
        return tl::unexpected(read.error());
    if (const auto read = numbers(node, "rotation", rotation); !read) return tl::unexpected(read.error());
    if (const auto read = numbers(node, "scale", scale); !read) return tl::unexpected(read.error());
    return affine_of({translation[0], translation[1], translation[2]}, rotation,
                     {scale[0], scale[1], scale[2]});
}

bool is_hidden(const Json& node) {
    const Json& visible = field(extension(node, "KHR_node_visibility"), "visible");
    return visible.is_boolean() && !visible.get<bool>();
}

Error missing_node(std::uint64_t node) {
    return {ErrorKind::input, say("gltf.no_node", {{"node", node}})};
}

}  // namespace

Nodes::Nodes(const Json& scene) : scene_(&scene), nodes_(&field(scene, "nodes")) {
    const auto count = static_cast<std::size_t>(count_of(*nodes_));
    parent_.assign(count, count);
    state_.assign(count, State::unknown);
    world_.resize(count);
}

Result<Nodes> Nodes::open(const Json& scene) {
    Nodes nodes(scene);
    if (const auto linked = nodes.link(); !linked) return tl::unexpected(linked.error());
    return nodes;
}

Result<void> Nodes::link() {
    for (std::size_t node = 0; node < parent_.size(); ++node) {
        const Json& children = field(json(node), "children");
        for (std::uint64_t i = 0; i < count_of(children); ++i) {
            const auto child = whole_value(item(children, i), "children");
            if (!child) return tl::unexpected(child.error());
            if (*child >= parent_.size()) return tl::unexpected(missing_node(*child));
            const auto of = static_cast<std::size_t>(*child);
            std::size_t& parent = parent_[of];
            if (parent == parent_.size())
                parent = node;
            else if (parent != node)
                further_parents_[of].push_back(node);
        }
    }
    return {};
}

Result<Affine> Nodes::first_world(std::size_t node) {
    std::vector<std::size_t> path;
    for (std::size_t at = node; at != parent_.size() && state_[at] != State::known; at = parent_[at]) {
        if (state_[at] == State::on_the_way) return refuse(say("gltf.node_in_itself", {{"node", at}}));
        state_[at] = State::on_the_way;
        path.push_back(at);
    }
    for (; !path.empty(); path.pop_back()) {
        const std::size_t at = path.back(), parent = parent_[at];
        const auto own = local(json(at));
        if (!own) return own;
        world_[at] = parent == parent_.size() ? *own : world_[parent] * *own;
        state_[at] = State::known;
    }
    return world_[node];
}

Result<Affine> Nodes::world(std::uint64_t number) {
    if (number >= parent_.size()) return tl::unexpected(missing_node(number));
    const auto node = static_cast<std::size_t>(number);
    auto place = first_world(node);
    if (!place) return place;
    const auto further = further_parents_.find(node);
    if (further == further_parents_.end()) return place;
    const auto first = first_world(parent_[node]);
    if (!first) return first;
    for (const std::size_t parent : further->second) {
        const auto other = first_world(parent);
        if (!other) return other;
        if (!(*other == *first))
            return refuse(
                say("gltf.node_in_two", {{"node", node}, {"first", parent_[node]}, {"second", parent}}));
    }
    further_parents_.erase(further);
    return place;
}

Result<std::vector<std::size_t>> Nodes::roots() {
    std::vector<std::size_t> roots;
    const Json& scenes = field(*scene_, "scenes");
    if (count_of(scenes) == 0) {
        for (std::size_t node = 0; node < parent_.size(); ++node)
            if (parent_[node] == parent_.size()) roots.push_back(node);
        return roots;
    }
    const auto which = whole(*scene_, "scene", 0);
    if (!which) return tl::unexpected(which.error());
    if (*which >= count_of(scenes)) return refuse(say("gltf.no_first_scene", {{"scene", *which}}));
    const Json& nodes = field(item(scenes, *which), "nodes");
    for (std::uint64_t i = 0; i < count_of(nodes); ++i) {
        const auto number = whole_value(item(nodes, i), "nodes");
        if (!number) return tl::unexpected(number.error());
        if (*number >= parent_.size()) return tl::unexpected(missing_node(*number));
        const auto node = static_cast<std::size_t>(*number);
        if (const std::size_t parent = parent_[node]; parent != parent_.size()) {
            const auto within = world(parent);
            if (!within) return tl::unexpected(within.error());
            if (!(*within == Affine{}))
                return refuse(say("gltf.node_moved_too", {{"node", node}, {"parent", parent}}));
        }
        roots.push_back(node);
    }
    return roots;
}

Result<std::vector<std::size_t>> Nodes::shown() {
    auto waiting = roots();
    if (!waiting) return waiting;
    std::reverse(waiting->begin(), waiting->end());
    std::vector<std::size_t> shown;
    std::vector<std::uint8_t> seen(parent_.size(), 0);
    while (!waiting->empty()) {
        const std::size_t node = waiting->back();
        waiting->pop_back();
        if (seen[node] != 0) continue;
        seen[node] = 1;
        if (is_hidden(json(node))) continue;
        shown.push_back(node);
        const Json& children = field(json(node), "children");
        for (std::uint64_t i = count_of(children); i-- > 0;)
            waiting->push_back(static_cast<std::size_t>(*whole_value(item(children, i), "children")));
    }
    return shown;
}

Result<Instances> Instances::open(const Json& scene, Buffers& buffers, const Json& node) {
    Instances instances;
    const Json& attributes = field(extension(node, "EXT_mesh_gpu_instancing"), "attributes");
    bool first = true;
    const auto read = [&](const char* name, const char* type, Accessor& into) -> Result<void> {
        if (field(attributes, name).is_null()) return {};
        const auto index = whole(attributes, name, 0);
        if (!index) return tl::unexpected(index.error());
        auto accessor = Accessor::open(scene, buffers, *index, type);
        if (!accessor) return tl::unexpected(accessor.error());
        if (!first && accessor->count() != instances.count_)
            return refuse(
                say("gltf.instances", {{"places", instances.count_}, {"turns", accessor->count()}}));
        instances.count_ = accessor->count();
        first = false;
        into = std::move(*accessor);
        return {};
    };
    if (const auto done = read("TRANSLATION", "VEC3", instances.translation_); !done)
        return tl::unexpected(done.error());
    if (const auto done = read("ROTATION", "VEC4", instances.rotation_); !done)
        return tl::unexpected(done.error());
    if (const auto done = read("SCALE", "VEC3", instances.scale_); !done) return tl::unexpected(done.error());
    return instances;
}

Affine Instances::at(std::uint64_t i) const {
    Quaternion rotation{0, 0, 0, 1};
    if (rotation_.count() > 0)
        for (int c = 0; c < 4; ++c) rotation[static_cast<std::size_t>(c)] = rotation_.at(i, c);
    return affine_of(translation_.count() > 0 ? translation_.vec3(i) : Vec3d{}, rotation,
                     scale_.count() > 0 ? scale_.vec3(i) : Vec3d{1, 1, 1});
}

}  // namespace snug::gltf
