// SPDX-License-Identifier: MIT
#pragma once

#include "broad/bounds_node.hpp"

#include <limits>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Trees of bounding boxes [Ericson05, 6.2], one for each kind of rest. Their leaves are numbers of
/// the owner, each in at most one tree. A node holds up to eight boxes, which a search compares at
/// once; all leaves of a tree are equally deep, as in an R-tree [Guttman84].
///
/// A leaf that is set is marked until clearMarks(). findNodePairs() and forPairs() find each pair
/// of overlapping leaves once if one of them is marked.
///
/// The order in which a search finds leaves depends on the history of the tree.
class BoundsTrees {
public:
    /// Returned by the `entry` of a search for a box that it does not reach.
    static constexpr Real kMissed = std::numeric_limits<Real>::infinity();

    struct Leaf {
        Aabb box;
        std::uint32_t number;
    };

    /// Puts a leaf into a tree, or moves it there. A leaf that stays near keeps its node.
    void set(std::uint32_t leaf, Rest rest, const Aabb& box);
    /// The same for leaves that are in no tree. Many are sorted together with those of the tree.
    void add(Rest rest, std::span<const Leaf> leaves);
    /// Ignored if the leaf is in no tree.
    void remove(std::uint32_t leaf);
    void clear() { *this = {}; }

    bool has(std::uint32_t leaf) const { return leaf < places_.size() && places_[leaf] != kNone; }
    /// Precondition: has(leaf).
    Rest restOf(std::uint32_t leaf) const { return nodes_[places_[leaf] / kWidth].rest; }
    Aabb boxOf(std::uint32_t leaf) const { return boxAt(places_[leaf]); }
    std::size_t size(Rest rest) const { return trees_[index(rest)].size; }
    /// Largest number of nodes between the root and a leaf.
    std::size_t height(Rest rest) const {
        const std::uint32_t root = trees_[index(rest)].root;
        return root == kNone ? 0 : nodes_[root].level + std::size_t{1};
    }

    /// Two nodes of level 0 whose boxes overlap, or one node twice.
    struct NodePair {
        std::uint32_t first;
        std::uint32_t second;
    };
    /// Appends the pairs of nodes with a marked leaf whose leaves may overlap: within the tree
    /// Moving and between it and the others; if `anyRest`, also those with the tree Asleep. Before,
    /// sorts the tree Moving again if its nodes have spread.
    void findNodePairs(bool anyRest, std::vector<NodePair>& pairs);
    /// Calls visit(leaf, other) for each overlapping pair of leaves, edges included, with a mark.
    template <typename Visit>
    void forPairs(const NodePair& pair, Visit visit) const {
        const BoundsNode& a = nodes_[pair.first];
        const BoundsNode& b = nodes_[pair.second];
        forMarkedPairs(pair.first, pair.second, [&](std::uint32_t i, std::uint32_t j) {
            if (a.child[i] != b.child[j]) {
                visit(a.child[i], b.child[j]);
            }
        });
    }
    void clearMarks();

    /// Calls visit(leaf) for the leaves of all trees whose boxes overlap this one, edges included.
    template <typename Visit>
    void overlaps(const Aabb& box, Visit visit) const {
        std::array<std::uint32_t, kStack> open; // nodes
        for (const Tree& tree : trees_) {
            std::size_t size = 0; // of `open` in use
            for (std::uint32_t at = tree.root; at != kNone; at = size > 0 ? open[--size] : kNone) {
                const BoundsNode& node = nodes_[at];
                forEachBit(node.reached(box), [&](std::uint32_t i) {
                    if (node.level == 0) {
                        visit(node.child[i]);
                    } else {
                        open[size++] = node.child[i];
                    }
                });
            }
        }
    }
    /// Calls visit(leaf) for the leaves of all trees with entry(box) < kMissed. Boxes with the
    /// smaller entry come first within a node, so a search for the closest leaf may return kMissed
    /// beyond the best one that it has found.
    template <typename Entry, typename Visit>
    void search(Entry entry, Visit visit) const {
        std::array<std::uint32_t, kStack> open; // places
        for (const Tree& tree : trees_) {
            std::size_t size = tree.root == kNone ? 0 : expand(tree.root, entry, open, 0);
            while (size > 0) {
                const std::uint32_t place = open[--size];
                if (!(entry(boxAt(place)) < kMissed)) {
                    continue; // the limit has come nearer since the place was put there
                }
                const BoundsNode& node = nodes_[place / kWidth];
                const std::uint32_t child = node.child[place % kWidth];
                if (node.level == 0) {
                    visit(child);
                } else {
                    size = expand(child, entry, open, size);
                }
            }
        }
    }

private:
    static constexpr std::uint32_t kNone = BoundsNode::kNone;
    static constexpr std::uint32_t kWidth = BoundsNode::kWidth;
    static constexpr std::uint32_t kAll = BoundsNode::kAll;
    // Nodes of a full level are split into halves of four, so 16 levels hold 2^32 leaves.
    static constexpr std::size_t kStack = 16 * kWidth;

    struct Child {
        Aabb box;
        std::uint32_t number; // node or leaf
        bool marked;
    };
    struct Tree {
        std::uint32_t root = kNone;
        std::size_t size = 0;  // leaves
        std::size_t moved = 0; // marked leaves of all searches since the last look at `spread`
        Real spread = 0;       // m; see spreadOf(), when it was sorted
    };

    static constexpr std::size_t index(Rest rest) { return static_cast<std::size_t>(rest); }

    Aabb boxAt(std::uint32_t place) const { return nodes_[place / kWidth].boxOf(place % kWidth); }
    void setBox(std::uint32_t place, const Aabb& box) {
        nodes_[place / kWidth].setBox(place % kWidth, box);
    }

    /// Appends the places of the boxes of a node that the search reaches, the nearest one last.
    template <typename Entry>
    std::size_t expand(std::uint32_t at, Entry entry, std::array<std::uint32_t, kStack>& open,
                       std::size_t size) const {
        std::array<Real, kWidth> entries;
        const std::size_t first = size;
        for (std::uint32_t i = 0; i < nodes_[at].count; ++i) {
            const std::uint32_t place = at * kWidth + i;
            const Real own = entry(boxAt(place));
            if (!(own < kMissed)) {
                continue;
            }
            std::size_t k = size++;
            for (; k > first && entries[k - first - 1] < own; --k) {
                entries[k - first] = entries[k - first - 1];
                open[k] = open[k - 1];
            }
            entries[k - first] = own;
            open[k] = place;
        }
        return size;
    }

    /// Children of a node that overlap the whole of another one.
    std::uint32_t near(std::uint32_t node, std::uint32_t other) const {
        const std::uint32_t place = nodes_[other].parent;
        return place == kNone ? kAll : nodes_[node].reached(boxAt(place));
    }
    /// Calls visit(i, j) for overlapping children of two nodes, each pair once, if one of both is
    /// marked. Within one node also for i = j.
    template <typename Visit>
    void forMarkedPairs(std::uint32_t a, std::uint32_t b, Visit visit) const {
        const BoundsNode& first = nodes_[a];
        const BoundsNode& second = nodes_[b];
        if (a == b) {
            forEachBit(first.marks, [&](std::uint32_t i) {
                const std::uint32_t done = first.marks & ((1u << i) - 1);
                forEachBit(first.reached(first.boxOf(i)) & ~done,
                           [&](std::uint32_t j) { visit(i, j); });
            });
            return;
        }
        if (first.marks != 0) {
            forEachBit(first.marks & near(a, b), [&](std::uint32_t i) {
                forEachBit(second.reached(first.boxOf(i)), [&](std::uint32_t j) { visit(i, j); });
            });
        }
        const std::uint32_t others = kAll >> (kWidth - first.count) & ~first.marks;
        if (second.marks != 0 && others != 0) {
            forEachBit(second.marks & near(b, a), [&](std::uint32_t j) {
                forEachBit(first.reached(second.boxOf(j)) & others,
                           [&](std::uint32_t i) { visit(i, j); });
            });
        }
    }

    std::uint32_t newNode(Rest rest, std::uint8_t level);
    void freeNode(std::uint32_t node);
    bool isMarked(std::uint32_t place) const {
        return (nodes_[place / kWidth].marks >> place % kWidth & 1) != 0;
    }
    void mark(std::uint32_t place);
    void put(std::uint32_t place, const Child& child);
    void insert(Rest rest, std::uint32_t leaf, const Aabb& box);
    void append(std::uint32_t node, const Child& child);
    void split(std::uint32_t node, const Child& child);
    void grow(std::uint32_t node, const Aabb& box);
    Child childAt(std::uint32_t place) const {
        return {boxAt(place), nodes_[place / kWidth].child[place % kWidth], isMarked(place)};
    }
    Child asChild(std::uint32_t node) const {
        return {nodes_[node].box(), node, nodes_[node].marks != 0};
    }
    std::size_t refitMarked(std::uint32_t node);
    void findNodePairs(std::uint32_t a, std::uint32_t b, std::vector<NodePair>& pairs) const;
    void clearMarks(std::uint32_t node);
    void takeOut(std::uint32_t place);
    static void cutAt(std::span<Child> children, std::size_t cut);
    bool merge(std::uint32_t node);
    void sort(Rest rest);
    void sortIfSpread(Rest rest);
    Real spreadOf(std::uint32_t node) const;
    void collect(std::uint32_t node);
    std::uint32_t build(Rest rest, std::uint8_t level, std::span<Child> leaves);
    void divide(std::uint32_t node, std::span<Child> leaves, std::size_t groups);

    std::vector<BoundsNode> nodes_; // of all trees
    std::uint32_t free_ = kNone;
    std::array<Tree, kRests> trees_;
    std::vector<std::uint32_t> places_; // by leaf; kNone: in no tree
    std::vector<Child> leaves_;         // scratch of sort()
};

} // namespace KODO_PRECISION
} // namespace kodo
