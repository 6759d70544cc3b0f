// SPDX-License-Identifier: MIT
// BoundsTrees: sorting of leaves, and pairs.
#include "broad/bounds_trees.hpp"

#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Twice the centre.
Vec2 middle(const Aabb& box) {
    return box.lower + box.upper;
}

} // namespace

/// Puts those children before `cut` which are there along the axis on which their centres spread
/// farther.
void BoundsTrees::cutAt(std::span<Child> children, std::size_t cut) {
    Aabb middles{middle(children[0].box), middle(children[0].box)};
    for (const Child& child : children) {
        middles = unite(middles, {middle(child.box), middle(child.box)});
    }
    const Vec2 spread = middles.extent();
    const auto sort = [&](Real Vec2::*axis) {
        // total order: numbers are unique
        std::nth_element(children.begin(), children.begin() + static_cast<std::ptrdiff_t>(cut),
                         children.end(), [&](const Child& a, const Child& b) {
                             const Real first = middle(a.box).*axis;
                             const Real second = middle(b.box).*axis;
                             return first != second ? first < second : a.number < b.number;
                         });
    };
    sort(spread.x > spread.y ? &Vec2::x : &Vec2::y);
}

void BoundsTrees::add(Rest rest, std::span<const Leaf> leaves) {
    if (leaves.size() <= trees_[index(rest)].size) {
        for (const Leaf& leaf : leaves) {
            insert(rest, leaf.number, leaf.box);
        }
        return;
    }
    leaves_.clear();
    for (const Leaf& leaf : leaves) {
        places_.resize(std::max(places_.size(), leaf.number + std::size_t{1}), kNone);
        leaves_.push_back({leaf.box, leaf.number, true});
    }
    sort(rest);
}

/// Sorts the leaves of a tree together with those in leaves_.
void BoundsTrees::sort(Rest rest) {
    Tree& tree = trees_[index(rest)];
    if (tree.root != kNone) {
        collect(tree.root);
    }
    std::uint8_t level = 0;
    for (std::size_t most = kWidth; most < leaves_.size(); most *= kWidth) {
        ++level;
    }
    const std::uint32_t root = build(rest, level, leaves_);
    tree = {root, leaves_.size(), 0, spreadOf(root)};
}

/// Half the perimeter of all nodes of level 0 below a node (m), to which the number of those that
/// a search finds is proportional.
Real BoundsTrees::spreadOf(std::uint32_t node) const {
    Real sum = 0;
    for (std::uint32_t i = 0; i < nodes_[node].count; ++i) {
        sum += nodes_[node].level > 1 ? spreadOf(nodes_[node].child[i])
                                      : halfPerimeter(nodes_[node].boxOf(i));
    }
    return sum;
}

/// Looks at the spread when as many leaves have moved as there are.
void BoundsTrees::sortIfSpread(Rest rest) {
    constexpr Real kMost = Real(1.25); // times the spread after sorting
    Tree& tree = trees_[index(rest)];
    if (tree.root == kNone || tree.moved < tree.size) {
        return;
    }
    tree.moved = 0;
    if (spreadOf(tree.root) > kMost * tree.spread) {
        leaves_.clear();
        sort(rest);
    }
}

/// Frees a node and all below, and lists its leaves.
void BoundsTrees::collect(std::uint32_t node) {
    for (std::uint32_t i = 0; i < nodes_[node].count; ++i) {
        if (nodes_[node].level == 0) {
            leaves_.push_back(childAt(node * kWidth + i));
        } else {
            collect(nodes_[node].child[i]);
        }
    }
    freeNode(node);
}

/// Returns a node with all the leaves.
std::uint32_t BoundsTrees::build(Rest rest, std::uint8_t level, std::span<Child> leaves) {
    const std::uint32_t node = newNode(rest, level);
    if (level == 0) {
        for (const Child& leaf : leaves) {
            put(node * kWidth + nodes_[node].count++, leaf);
        }
        return node;
    }
    std::size_t below = 1; // leaves of a full child
    for (std::uint8_t i = 0; i < level; ++i) {
        below *= kWidth;
    }
    divide(node, leaves, (leaves.size() + below - 1) / below);
    return node;
}

/// Appends children for the leaves, divided into as many groups of similar size.
void BoundsTrees::divide(std::uint32_t node, std::span<Child> leaves, std::size_t groups) {
    if (groups > 1) {
        const std::size_t cut = leaves.size() * (groups / 2) / groups;
        cutAt(leaves, cut);
        divide(node, leaves.first(cut), groups / 2);
        divide(node, leaves.subspan(cut), groups - groups / 2);
        return;
    }
    const std::uint32_t place = node * kWidth + nodes_[node].count++;
    const auto below = static_cast<std::uint8_t>(nodes_[node].level - 1);
    const std::uint32_t child = build(nodes_[node].rest, below, leaves);
    put(place, asChild(child));
}

/// Fits the boxes above marked leaves to what they hold. Returns the number of these leaves.
std::size_t BoundsTrees::refitMarked(std::uint32_t node) {
    if (nodes_[node].level == 0) {
        return static_cast<std::size_t>(std::popcount(nodes_[node].marks));
    }
    std::size_t marked = 0;
    forEachBit(nodes_[node].marks, [&](std::uint32_t i) {
        const std::uint32_t child = nodes_[node].child[i];
        marked += refitMarked(child);
        setBox(node * kWidth + i, nodes_[child].box());
    });
    return marked;
}

void BoundsTrees::findNodePairs(bool anyRest, std::vector<NodePair>& pairs) {
    for (Tree& tree : trees_) {
        tree.moved += tree.root == kNone ? 0 : refitMarked(tree.root);
    }
    sortIfSpread(Rest::Moving);
    const auto find = [&](Rest a, Rest b) {
        const std::uint32_t first = trees_[index(a)].root;
        const std::uint32_t second = trees_[index(b)].root;
        if (first != kNone && second != kNone) {
            findNodePairs(first, second, pairs);
        }
    };
    find(Rest::Moving, Rest::Moving);
    find(Rest::Moving, Rest::Static);
    find(Rest::Moving, Rest::Asleep);
    if (anyRest) {
        find(Rest::Asleep, Rest::Static);
        find(Rest::Asleep, Rest::Asleep);
    }
}

/// Descends into pairs of children whose boxes overlap, each once.
void BoundsTrees::findNodePairs(std::uint32_t a, std::uint32_t b,
                                std::vector<NodePair>& pairs) const {
    const BoundsNode& first = nodes_[a];
    const BoundsNode& second = nodes_[b];
    if (first.level < second.level) {
        findNodePairs(b, a, pairs);
        return;
    }
    if ((first.marks | second.marks) == 0) {
        return;
    }
    if (first.level == 0) {
        pairs.push_back({a, b});
        return;
    }
    if (first.level > second.level) {
        Aabb marked = BoundsNode().box(); // reaches nothing
        forEachBit(second.marks, [&](std::uint32_t j) { marked = unite(marked, second.boxOf(j)); });
        forEachBit((first.reached(second.box()) & first.marks) | first.reached(marked),
                   [&](std::uint32_t i) { findNodePairs(first.child[i], b, pairs); });
        return;
    }
    forMarkedPairs(a, b, [&](std::uint32_t i, std::uint32_t j) {
        findNodePairs(first.child[i], second.child[j], pairs);
    });
}

void BoundsTrees::clearMarks() {
    for (const Tree& tree : trees_) {
        if (tree.root != kNone) {
            clearMarks(tree.root);
        }
    }
}

void BoundsTrees::clearMarks(std::uint32_t node) {
    const std::uint32_t marks = std::exchange(nodes_[node].marks, std::uint8_t{0});
    if (nodes_[node].level > 0) {
        forEachBit(marks, [&](std::uint32_t i) { clearMarks(nodes_[node].child[i]); });
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
