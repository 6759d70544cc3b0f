// SPDX-License-Identifier: MIT
#include "broad/bounds_trees.hpp"

#include "base/assert.hpp"

#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

} // namespace

std::uint32_t BoundsTrees::newNode(Rest rest, std::uint8_t level) {
    std::uint32_t node = free_;
    if (node == kNone) {
        node = static_cast<std::uint32_t>(nodes_.size());
        if (nodes_.size() == nodes_.capacity()) { // grows by less than twice
            nodes_.reserve(nodes_.size() + nodes_.size() / 16 + kWidth);
        }
        nodes_.emplace_back();
    } else {
        free_ = nodes_[node].parent;
        nodes_[node] = {};
    }
    nodes_[node].rest = rest;
    nodes_[node].level = level;
    return node;
}

void BoundsTrees::freeNode(std::uint32_t node) {
    nodes_[node].parent = std::exchange(free_, node);
}

/// Marks a place and all above it.
void BoundsTrees::mark(std::uint32_t place) {
    for (; place != kNone && !isMarked(place); place = nodes_[place / kWidth].parent) {
        nodes_[place / kWidth].marks |= static_cast<std::uint8_t>(1u << place % kWidth);
    }
}

/// Sets a place, which its child gets to know.
void BoundsTrees::put(std::uint32_t place, const Child& child) {
    BoundsNode& node = nodes_[place / kWidth];
    setBox(place, child.box);
    node.child[place % kWidth] = child.number;
    (node.level == 0 ? places_[child.number] : nodes_[child.number].parent) = place;
    node.marks &= static_cast<std::uint8_t>(~(1u << place % kWidth));
    if (child.marked) {
        mark(place);
    }
}

void BoundsTrees::set(std::uint32_t leaf, Rest rest, const Aabb& box) {
    if (has(leaf)) {
        const std::uint32_t place = places_[leaf];
        const BoundsNode& node = nodes_[place / kWidth];
        const bool near = node.parent == kNone || overlap(boxAt(node.parent), box);
        if (near && node.rest == rest) {
            setBox(place, box);
            mark(place);
            grow(place / kWidth, box);
            return;
        }
        remove(leaf);
    }
    insert(rest, leaf, box);
}

/// Descends to the boxes that grow least.
void BoundsTrees::insert(Rest rest, std::uint32_t leaf, const Aabb& box) {
    if (leaf >= places_.size()) {
        places_.resize(leaf + std::size_t{1}, kNone);
    }
    Tree& tree = trees_[index(rest)];
    if (tree.root == kNone) {
        tree.root = newNode(rest, 0);
    }
    ++tree.size;
    std::uint32_t at = tree.root;
    while (nodes_[at].level > 0) {
        std::uint32_t best = 0;
        std::pair least{kInfinity, kInfinity};
        for (std::uint32_t i = 0; i < nodes_[at].count; ++i) {
            const Aabb own = boxAt(at * kWidth + i);
            const Real before = halfPerimeter(own);
            const std::pair growth{halfPerimeter(unite(own, box)) - before, before};
            if (growth < least) {
                least = growth;
                best = i;
            }
        }
        at = nodes_[at].child[best];
    }
    append(at, {box, leaf, true});
}

/// Adds a child to a node, which is split if it is full.
void BoundsTrees::append(std::uint32_t node, const Child& child) {
    if (nodes_[node].count == kWidth) {
        split(node, child);
        return;
    }
    put(node * kWidth + nodes_[node].count++, child);
    grow(node, child.box);
}

/// Grows the boxes around a node for one of its children.
void BoundsTrees::grow(std::uint32_t node, const Aabb& box) {
    for (std::uint32_t place = nodes_[node].parent; place != kNone;) {
        const Aabb before = boxAt(place);
        if (before.contains(box)) {
            return;
        }
        setBox(place, unite(before, box));
        place = nodes_[place / kWidth].parent;
    }
}

void BoundsTrees::split(std::uint32_t node, const Child& child) {
    constexpr std::uint32_t kKept = kWidth / 2 + 1;
    std::array<Child, kWidth + 1> children;
    for (std::uint32_t i = 0; i < kWidth; ++i) {
        children[i] = childAt(node * kWidth + i);
    }
    children[kWidth] = child;
    cutAt(children, kKept);
    const Rest rest = nodes_[node].rest;
    const std::uint8_t level = nodes_[node].level;
    const std::uint32_t parent = nodes_[node].parent;
    const std::uint32_t sibling = newNode(rest, level);
    nodes_[node] = {};
    nodes_[node].rest = rest;
    nodes_[node].level = level;
    nodes_[node].parent = parent;
    for (std::uint32_t i = 0; i <= kWidth; ++i) {
        const std::uint32_t into = i < kKept ? node : sibling;
        put(into * kWidth + nodes_[into].count++, children[i]);
    }
    if (parent == kNone) {
        const std::uint32_t root = newNode(rest, static_cast<std::uint8_t>(level + 1));
        trees_[index(rest)].root = root;
        append(root, asChild(node));
        append(root, asChild(sibling));
        return;
    }
    setBox(parent, nodes_[node].box());
    grow(parent / kWidth, boxAt(parent));
    append(parent / kWidth, asChild(sibling));
}

void BoundsTrees::remove(std::uint32_t leaf) {
    if (!has(leaf)) {
        return;
    }
    const std::uint32_t place = std::exchange(places_[leaf], kNone);
    --trees_[index(nodes_[place / kWidth].rest)].size;
    takeOut(place);
}

/// Empties a place. Nodes with few children are merged with others.
void BoundsTrees::takeOut(std::uint32_t place) {
    const std::uint32_t node = place / kWidth;
    const std::uint32_t last = node * kWidth + --nodes_[node].count;
    if (place != last) {
        put(place, childAt(last));
    }
    nodes_[node].clearBox(last % kWidth);
    nodes_[node].marks &= static_cast<std::uint8_t>(~(1u << last % kWidth));
    const std::uint32_t parent = nodes_[node].parent;
    std::uint32_t& root = trees_[index(nodes_[node].rest)].root;
    if (parent != kNone) {
        if (nodes_[node].count == 0 || merge(node)) {
            freeNode(node);
            takeOut(parent);
        } else {
            setBox(parent, nodes_[node].box());
        }
    } else if (nodes_[node].count == 0) {
        freeNode(node);
        root = kNone;
    } else if (nodes_[node].level > 0 && nodes_[node].count == 1) {
        root = nodes_[node].child[0];
        nodes_[root].parent = kNone;
        freeNode(node);
    }
}

/// Moves the children of a node with few to the sibling that grows least. False if none has room.
bool BoundsTrees::merge(std::uint32_t node) {
    constexpr std::uint32_t kFew = kWidth / 4;
    constexpr std::uint32_t kFull = kWidth - kFew; // after it, so that the next one is no split
    const std::uint32_t count = nodes_[node].count;
    if (count > kFew) {
        return false;
    }
    const Aabb box = nodes_[node].box();
    const std::uint32_t parent = nodes_[node].parent / kWidth;
    std::uint32_t into = kNone;
    Real least = kInfinity;
    for (std::uint32_t i = 0; i < nodes_[parent].count; ++i) {
        const std::uint32_t other = nodes_[parent].child[i];
        const Aabb own = boxAt(parent * kWidth + i);
        const Real growth = halfPerimeter(unite(own, box)) - halfPerimeter(own);
        if (other != node && nodes_[other].count + count <= kFull && growth < least) {
            least = growth;
            into = other;
        }
    }
    if (into == kNone) {
        return false;
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        append(into, childAt(node * kWidth + i));
    }
    return true;
}

} // namespace KODO_PRECISION
} // namespace kodo
