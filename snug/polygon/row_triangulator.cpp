#include "snug/polygon/row_triangulator.h"

#include <cassert>
#include <utility>

namespace snug {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

}  // namespace

/// Finds the runs of one row that lie to both sides of ascending positions.
class RowTriangulator::Cursor {
  public:
    explicit Cursor(std::vector<ActiveRun>& runs) : runs_(runs) {}

    void move_to(int position) {
        while (at_ < runs_.size() && runs_[at_].cells.end < position) ++at_;
        left = right = nullptr;
        if (at_ == runs_.size()) return;
        if (runs_[at_].cells.begin < position) left = &runs_[at_];
        const std::size_t after = at_ + (runs_[at_].cells.end == position ? 1 : 0);
        if (after < runs_.size() && runs_[after].cells.begin <= position) right = &runs_[after];
    }

    ActiveRun* left = nullptr;
    ActiveRun* right = nullptr;

  private:
    std::vector<ActiveRun>& runs_;
    std::size_t at_ = 0;
};

void RowTriangulator::step(int line, std::span<const LineCorner> corners, std::span<const FaceRun> next) {
    // A run that begins straight below another has no corner there to hand its chain on.
    next_.clear();
    std::size_t at = 0;
    for (const FaceRun& cells : next) {
        while (at < previous_.size() && previous_[at].cells.begin < cells.begin) ++at;
        const bool straight = at < previous_.size() && previous_[at].cells.begin == cells.begin &&
                              previous_[at].cells.face == cells.face;
        next_.push_back({cells, straight ? previous_[at].chain : kNone});
    }
    Cursor previous_cursor(previous_);
    Cursor next_cursor(next_);
    for (const LineCorner& corner : corners) {
        previous_cursor.move_to(corner.position);
        next_cursor.move_to(corner.position);
        pass(line, corner, previous_cursor, next_cursor);
    }
    std::swap(previous_, next_);
}

/// The sweep line leans a little, so that of two corners on one line the left one comes first: left of the
/// corner it has reached the next row, right of it it is still in the previous one. So `next.left` and
/// `previous.right` are the runs that it crosses here.
void RowTriangulator::pass(int line, const LineCorner& corner, Cursor& previous, Cursor& next) {
    const auto same = [](const ActiveRun* a, const ActiveRun* b) {
        return a != nullptr && b != nullptr && a->cells.face == b->cells.face;
    };
    const auto node = [&](std::uint32_t vertex) { return Node{vertex, line, corner.position, kNone, kNone}; };
    const bool joined = same(next.left, previous.right);

    if (previous.left != nullptr && !same(previous.left, previous.right) && !same(previous.left, next.left))
        end(previous.left->chain, node(corner.previous_left));

    if (joined) {
        const bool before = same(previous.left, previous.right);
        const bool after = same(next.right, previous.right);
        if (before && !after) {
            previous.right->chain = split(next.left->chain, node(corner.previous_right));
        } else if (after && !before) {
            merge(next.left->chain, previous.right->chain, node(corner.previous_right));
            previous.right->chain = next.left->chain;
        } else if (!before && !after) {
            bend_right(next.left->chain, node(corner.next_left));
            bend_left(previous.right->chain, node(corner.previous_right));
        }
    } else {
        if (next.left != nullptr && corner.next_left != kNoVertex)
            bend_right(next.left->chain, node(corner.next_left));
        if (previous.right != nullptr && corner.previous_right != kNoVertex)
            bend_left(previous.right->chain, node(corner.previous_right));
        if (same(next.right, previous.right)) next.right->chain = previous.right->chain;
    }

    if (next.right != nullptr && !same(next.right, previous.right) && !same(next.right, next.left))
        start(*next.right, node(corner.next_right));
}

void RowTriangulator::start(ActiveRun& run, Node corner) {
    const Id node = new_node(corner);
    run.chain = new_chain({node, node, node, run.cells.face});
}

void RowTriangulator::bend_left(Id id, Node corner) {
    Chain& chain = chains_[id];
    while (chain.first != chain.last &&
           cut_off(corner, nodes_[chain.first], nodes_[nodes_[chain.first].right], chain.face)) {
        free_nodes_.push_back(chain.first);
        chain.first = nodes_[chain.first].right;
    }
    corner.right = chain.first;
    const Id added = new_node(corner);
    nodes_[chain.first].left = added;
    chain.first = chain.latest = added;
}

void RowTriangulator::bend_right(Id id, Node corner) {
    Chain& chain = chains_[id];
    while (chain.last != chain.first &&
           cut_off(nodes_[nodes_[chain.last].left], nodes_[chain.last], corner, chain.face)) {
        free_nodes_.push_back(chain.last);
        chain.last = nodes_[chain.last].left;
    }
    corner.left = chain.last;
    const Id added = new_node(corner);
    nodes_[chain.last].right = added;
    chain.last = chain.latest = added;
}

void RowTriangulator::end(Id id, Node corner) {
    bend_left(id, corner);
    assert(nodes_[chains_[id].first].right == chains_[id].last);
    free_nodes_.push_back(chains_[id].first);
    free_nodes_.push_back(chains_[id].last);
    free_chains_.push_back(id);
}

/// The left chain goes on as both.
void RowTriangulator::merge(Id left, Id right, Node corner) {
    bend_right(left, corner);
    bend_left(right, corner);
    Chain& whole = chains_[left];
    const Chain& rest = chains_[right];
    const Id follower = nodes_[rest.first].right;
    nodes_[whole.last].right = follower;
    nodes_[follower].left = whole.last;
    free_nodes_.push_back(rest.first);
    whole.last = rest.last;
    free_chains_.push_back(right);
}

/// The chain keeps what lies left of the corner; returns the one to its right. Both have the newest node.
RowTriangulator::Id RowTriangulator::split(Id id, Node corner) {
    const Chain whole = chains_[id];
    const Node latest = nodes_[whole.latest];
    const Id first = new_node(latest);
    const bool is_last = whole.latest == whole.last;
    if (!is_last) nodes_[latest.right].left = first;
    const Id right = new_chain({first, is_last ? first : whole.last, first, whole.face});
    chains_[id].last = whole.latest;
    bend_right(id, corner);
    bend_left(right, corner);
    return right;
}

/// Emits the triangle of three successive nodes if it lies in the part to come.
bool RowTriangulator::cut_off(const Node& left, const Node& middle, const Node& right, int face) {
    const auto turn = std::int64_t{middle.row - left.row} * (right.position - left.position) -
                      std::int64_t{middle.position - left.position} * (right.row - left.row);
    if (turn >= 0) return false;
    if (face > 0)
        triangles_.push_back({left.vertex, right.vertex, middle.vertex});
    else
        triangles_.push_back({left.vertex, middle.vertex, right.vertex});
    return true;
}

RowTriangulator::Id RowTriangulator::new_node(Node node) {
    assert(node.vertex != kNoVertex);
    if (free_nodes_.empty()) {
        nodes_.push_back(node);
        return static_cast<Id>(nodes_.size() - 1);
    }
    const Id id = free_nodes_.back();
    free_nodes_.pop_back();
    nodes_[id] = node;
    return id;
}

RowTriangulator::Id RowTriangulator::new_chain(Chain chain) {
    if (free_chains_.empty()) {
        chains_.push_back(chain);
        return static_cast<Id>(chains_.size() - 1);
    }
    const Id id = free_chains_.back();
    free_chains_.pop_back();
    chains_[id] = chain;
    return id;
}

}  // namespace snug
