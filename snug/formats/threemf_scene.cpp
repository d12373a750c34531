#include "snug/formats/threemf_scene.h"

#include <algorithm>
#include <set>
#include <utility>

#include "snug/base/text.h"

namespace snug {
namespace {

constexpr int kMostComponentDepth = 64;  // of components within components
constexpr std::uint64_t kMostUses = ThreeMfTotals::kMostUses;
constexpr std::uint64_t kMostRepeated = 10'000'000;  // triangles, where the file itself has fewer
constexpr std::uint64_t kMore = 1'000'000'000'000;   // counting ends here

std::size_t index_of(ThreeMfRole role) {
    return role == ThreeMfRole::thing ? 0 : 1;
}

void add_to(ThreeMfCount& sum, const ThreeMfCount& more) {
    sum.triangles = std::min(kMore, sum.triangles + more.triangles);
    sum.left_out = std::min(kMore, sum.left_out + more.left_out);
    sum.meshes = std::min(kMore, sum.meshes + more.meshes);
}

tl::unexpected<Error> too_many(const char* code, std::uint64_t most) {
    return fail(ErrorKind::input, too_many_in_3mf(code, most));
}

Message called(std::int64_t object, const std::string& part) {
    return say("threemf.object_of", {{"object", std::to_string(object)}, {"part", quoted(part, 80)}});
}

}  // namespace

ThreeMfScene::ThreeMfScene(ThreeMfPackage package, std::string root)
    : package_(std::move(package)), root_(std::move(root)) {}

Result<const ThreeMfModel*> ThreeMfScene::model(const std::string& part) {
    if (const auto known = models_.find(part); known != models_.end()) return &known->second;
    const auto bytes = package_.read(part);
    if (!bytes) return tl::unexpected(bytes.error());
    constexpr std::string_view kSecret = "%3McF";
    if (std::string_view(reinterpret_cast<const char*>(bytes->data()), bytes->size()).substr(0, 5) == kSecret)
        return fail(ErrorKind::input, say("threemf.encrypted", {{"part", quoted(part, 80)}}));
    auto read = read_3mf_model(*bytes, totals_);
    if (!read)
        return fail(ErrorKind::input,
                    say("at_part", {{"part", quoted(part, 80)}, {"problem", read.error().message}}));
    for (const auto& [id, object] : read->objects) triangles_ += object.mesh.triangles.size();
    return &models_.emplace(part, std::move(*read)).first->second;
}

/// The root's build; where that is empty, the one object that there is.
Result<std::vector<ThreeMfUse>> ThreeMfScene::build() {
    const auto root = model(root_);
    if (!root) return tl::unexpected(root.error());
    if (!(*root)->build.empty()) return (*root)->build;
    std::set<std::int64_t> alone;
    for (const auto& [id, object] : (*root)->objects) alone.insert(id);
    for (const auto& [id, object] : (*root)->objects)
        for (const ThreeMfUse& use : object.components)
            if (use.part.empty()) alone.erase(use.object);
    if (alone.size() == 1) return std::vector<ThreeMfUse>{{{}, *alone.begin(), {}}};
    return fail(ErrorKind::input, say("threemf.empty_build", {{"objects", (*root)->objects.size()}}));
}

Result<void> ThreeMfScene::load() {
    const auto items = build();
    if (!items) return tl::unexpected(items.error());
    for (const ThreeMfUse& item : *items) {
        const auto node = add(item, root_, ThreeMfRole::thing, 0);
        if (!node) return tl::unexpected(node.error());
        build_.push_back({*node, item.place});
    }
    return check_limits();
}

Result<std::size_t> ThreeMfScene::add(const ThreeMfUse& use, const std::string& from, ThreeMfRole role,
                                      int depth) {
    const std::string& part = use.part.empty() ? from : use.part;
    const auto [place, is_new] = numbers_.try_emplace({part, use.object, role}, nodes_.size());
    const std::size_t number = place->second;
    if (!is_new) {
        if (!nodes_[number].open) return number;
        return fail(ErrorKind::input, say("threemf.in_itself", {{"part", called(use.object, part)}}));
    }
    const auto found = model(part);
    if (!found) return tl::unexpected(found.error());
    const auto object = (*found)->objects.find(use.object);
    if (object == (*found)->objects.end())
        return fail(ErrorKind::input, say("threemf.not_there", {{"part", called(use.object, part)}}));
    nodes_.push_back({&object->second, std::max(role, object->second.role), {}, {}, 0, true});
    if (nodes_[number].role != ThreeMfRole::other) {
        if (!object->second.unread.empty())
            return fail(ErrorKind::input, say("threemf.unread", {{"part", called(use.object, part)},
                                                                 {"shape", say(object->second.unread)}}));
        if (auto done = add_children(number, part, depth); !done) return tl::unexpected(done.error());
    }
    nodes_[number].open = false;
    return number;
}

Result<void> ThreeMfScene::add_children(std::size_t number, const std::string& part, int depth) {
    const ThreeMfObject& object = *nodes_[number].object;
    const ThreeMfRole role = nodes_[number].role;
    std::array<ThreeMfCount, 2> count;
    const std::uint64_t own = object.mesh.triangles.size();
    count[index_of(role)] = {own, object.left_out, own + object.left_out > 0 ? 1u : 0u};
    std::vector<Child> children;
    int height = 0;
    for (const ThreeMfUse& use : object.components) {
        if (depth == kMostComponentDepth) break;  // too high, as the height says
        const auto child = add(use, part, role, depth + 1);
        if (!child) return tl::unexpected(child.error());
        children.push_back({*child, use.place});
        for (std::size_t i = 0; i < count.size(); ++i) add_to(count[i], nodes_[*child].count[i]);
        height = std::max(height, nodes_[*child].height + 1);
    }
    if (height > kMostComponentDepth || (depth == kMostComponentDepth && !object.components.empty()))
        return fail(ErrorKind::input, say("threemf.deep", {{"most", std::to_string(kMostComponentDepth)}}));
    Node& node = nodes_[number];
    node.count = count;
    node.children = std::move(children);
    node.height = height;
    return {};
}

ThreeMfCount ThreeMfScene::count(ThreeMfRole role) const {
    ThreeMfCount sum;
    for (const Child& item : build_) add_to(sum, nodes_[item.node].count[index_of(role)]);
    return sum;
}

Result<void> ThreeMfScene::check_limits() const {
    const std::uint64_t most = std::max(kMostRepeated, triangles_);
    for (const ThreeMfRole role : {ThreeMfRole::thing, ThreeMfRole::support}) {
        const ThreeMfCount sum = count(role);
        if (sum.triangles > most) return too_many("threemf.too_many_triangles", most);
        if (sum.meshes > kMostUses) return too_many("threemf.too_many_uses", kMostUses);
    }
    return {};
}

RawMesh ThreeMfScene::placed(ThreeMfRole role) const {
    RawMesh mesh;
    mesh.triangles.reserve(static_cast<std::size_t>(count(role).triangles));
    for (const Child& item : build_) place(nodes_[item.node], item.place, role, mesh);
    return mesh;
}

void ThreeMfScene::place(const Node& node, const Affine& at, ThreeMfRole role, RawMesh& mesh) const {
    if (node.count[index_of(role)].triangles == 0) return;
    if (node.role == role) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const Vec3d& v : node.object->mesh.vertices) mesh.vertices.push_back(at(v));
        const bool mirrors = at.mirrors();
        for (const Triangle& t : node.object->mesh.triangles)
            mesh.triangles.push_back(mirrors ? Triangle{first + t[0], first + t[2], first + t[1]}
                                             : Triangle{first + t[0], first + t[1], first + t[2]});
    }
    for (const Child& child : node.children) place(nodes_[child.node], at * child.place, role, mesh);
}

}  // namespace snug
