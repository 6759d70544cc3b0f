// SPDX-License-Identifier: MIT
#include "broad/bounds_tree.hpp"

#include <algorithm>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Half the perimeter (m): proportional to the share of random searches that reach the box.
Real cost(const Aabb& box) {
    const Vec2 extent = box.extent();
    return extent.x + extent.y;
}

} // namespace

std::uint32_t BoundsTree::newNode() {
    if (free_ == kNone) {
        nodes_.emplace_back();
        return static_cast<std::uint32_t>(nodes_.size() - 1);
    }
    const std::uint32_t node = free_;
    free_ = nodes_[node].parent;
    nodes_[node] = {};
    return node;
}

void BoundsTree::freeNode(std::uint32_t node) {
    nodes_[node].parent = free_;
    free_ = node;
}

void BoundsTree::clear() {
    nodes_.clear();
    root_ = kNone;
    free_ = kNone;
}

/// Descends to the node whose union with the box adds least perimeter to the tree.
std::uint32_t BoundsTree::siblingFor(const Aabb& box) const {
    std::uint32_t at = root_;
    while (!nodes_[at].isLeaf()) {
        const Node& node = nodes_[at];
        const Real here = cost(unite(node.box, box));
        const Real growth = here - cost(node.box); // of the ancestors, if the box goes below
        const auto below = [&](std::uint32_t child) {
            const Node& next = nodes_[child];
            const Real both = cost(unite(next.box, box));
            return growth + (next.isLeaf() ? both : both - cost(next.box));
        };
        const Real first = below(node.first);
        const Real second = below(node.second);
        if (here < first && here < second) {
            return at;
        }
        at = second < first ? node.second : node.first;
    }
    return at;
}

void BoundsTree::replaceChild(std::uint32_t parent, std::uint32_t child, std::uint32_t by) {
    nodes_[by].parent = parent;
    if (parent == kNone) {
        root_ = by;
    } else if (nodes_[parent].first == child) {
        nodes_[parent].first = by;
    } else {
        nodes_[parent].second = by;
    }
}

std::uint32_t BoundsTree::insert(const Leaf& leaf) {
    const std::uint32_t node = newNode();
    nodes_[node] = {leaf.box, kNone, leaf.body, leaf.part, true};
    attach(node);
    return node;
}

void BoundsTree::remove(std::uint32_t node) {
    detach(node);
    freeNode(node);
}

void BoundsTree::attach(std::uint32_t leaf) {
    if (root_ == kNone) {
        root_ = leaf;
        return;
    }
    const std::uint32_t sibling = siblingFor(nodes_[leaf].box);
    const std::uint32_t parent = newNode();
    replaceChild(nodes_[sibling].parent, sibling, parent);
    nodes_[parent].first = sibling;
    nodes_[parent].second = leaf;
    nodes_[sibling].parent = parent;
    nodes_[leaf].parent = parent;
    refit(parent);
}

void BoundsTree::detach(std::uint32_t leaf) {
    const std::uint32_t parent = std::exchange(nodes_[leaf].parent, kNone);
    if (parent == kNone) {
        root_ = kNone;
        return;
    }
    const Node& gone = nodes_[parent];
    const std::uint32_t sibling = gone.first == leaf ? gone.second : gone.first;
    const std::uint32_t above = gone.parent;
    replaceChild(above, parent, sibling);
    freeNode(parent);
    refit(above);
}

void BoundsTree::move(std::uint32_t leaf, const Aabb& box) {
    constexpr int kNear = 3; // levels up to the box in which a leaf may move
    std::uint32_t around = nodes_[leaf].parent;
    for (int i = 1; i < kNear && around != kNone && !nodes_[around].box.contains(box); ++i) {
        around = nodes_[around].parent;
    }
    if (around != kNone && nodes_[around].box.contains(box)) {
        nodes_[leaf].box = box;
        refit(nodes_[leaf].parent);
        return;
    }
    detach(leaf);
    nodes_[leaf].box = box;
    attach(leaf);
}

/// Updates the boxes from a node up to where they stay as they are.
void BoundsTree::refit(std::uint32_t node) {
    int unchanged = 0; // nodes in a row
    while (node != kNone && unchanged < 2) {
        Node& at = nodes_[node];
        const Aabb before = at.box;
        at.box = unite(nodes_[at.first].box, nodes_[at.second].box);
        rotate(node);
        unchanged = at.box == before ? unchanged + 1 : 0;
        node = at.parent;
    }
}

/// Swaps a child with a grandchild on the other side if that lowers the perimeter between them.
void BoundsTree::rotate(std::uint32_t node) {
    const Node at = nodes_[node];
    if (!rotateWith(node, at.first, at.second)) {
        rotateWith(node, at.second, at.first);
    }
}

/// `high` is a child of the node; one of its children may change places with `low`.
bool BoundsTree::rotateWith(std::uint32_t node, std::uint32_t high, std::uint32_t low) {
    const Node& from = nodes_[high];
    if (from.isLeaf()) {
        return false;
    }
    const Real now = cost(from.box);
    const Real keepFirst = cost(unite(nodes_[from.first].box, nodes_[low].box));
    const Real keepSecond = cost(unite(nodes_[from.second].box, nodes_[low].box));
    if (now <= std::min(keepFirst, keepSecond)) {
        return false;
    }
    const std::uint32_t up = keepFirst <= keepSecond ? from.second : from.first;
    replaceChild(high, up, low);
    replaceChild(node, low, up);
    nodes_[high].box = unite(nodes_[from.first].box, nodes_[from.second].box);
    return true;
}

void BoundsTree::build(std::vector<Leaf>& leaves, std::vector<std::uint32_t>& places,
                       std::size_t room) {
    clear();
    places.assign(leaves.size(), kNone);
    if (leaves.empty()) {
        return;
    }
    nodes_.reserve(2 * std::max(room, leaves.size()));
    std::vector<std::uint32_t> order(leaves.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    root_ = buildRange(leaves, order, 0, order.size(), places);
}

/// Splits at the median of the centres, along the axis on which they spread farther.
std::uint32_t BoundsTree::buildRange(std::vector<Leaf>& leaves, std::vector<std::uint32_t>& order,
                                     std::size_t first, std::size_t last,
                                     std::vector<std::uint32_t>& places) {
    const std::uint32_t node = newNode();
    if (last - first == 1) {
        const Leaf& leaf = leaves[order[first]];
        nodes_[node] = {leaf.box, kNone, leaf.body, leaf.part, true};
        places[order[first]] = node;
        return node;
    }
    Aabb centers{leaves[order[first]].box.center(), leaves[order[first]].box.center()};
    for (std::size_t i = first; i < last; ++i) {
        const Vec2 center = leaves[order[i]].box.center();
        centers = unite(centers, {center, center});
    }
    const bool wide = centers.extent().x > centers.extent().y;
    const auto key = [&](std::uint32_t i) {
        const Vec2 center = leaves[i].box.center();
        return wide ? center.x : center.y;
    };
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last), // total order: indices are unique
                     [&](std::uint32_t a, std::uint32_t b) {
                         return std::pair(key(a), a) < std::pair(key(b), b);
                     });
    const std::uint32_t left = buildRange(leaves, order, first, middle, places);
    const std::uint32_t right = buildRange(leaves, order, middle, last, places);
    nodes_[node].first = left;
    nodes_[node].second = right;
    nodes_[node].box = unite(nodes_[left].box, nodes_[right].box);
    nodes_[left].parent = node;
    nodes_[right].parent = node;
    return node;
}

std::size_t BoundsTree::height() const {
    std::size_t most = 0;
    std::vector<std::pair<std::uint32_t, std::size_t>> open;
    if (root_ != kNone) {
        open.push_back({root_, 0});
    }
    while (!open.empty()) {
        const auto [at, depth] = open.back();
        open.pop_back();
        most = std::max(most, depth);
        if (!nodes_[at].isLeaf()) {
            open.push_back({nodes_[at].first, depth + 1});
            open.push_back({nodes_[at].second, depth + 1});
        }
    }
    return most;
}

} // namespace KODO_PRECISION
} // namespace kodo
