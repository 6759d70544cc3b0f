// SPDX-License-Identifier: MIT
#pragma once

#include "broad/bounds_tree.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// A BoundsTree of parts that knows the leaves of each body.
class PartTree {
public:
    const BoundsTree& tree() const { return tree_; }
    bool isEmpty() const { return tree_.capacity() == 0; }
    /// Number of bodies that may have leaves.
    std::size_t bodyCount() const { return firstLeaf_.size(); }
    bool has(std::uint32_t body) const {
        return body < firstLeaf_.size() && firstLeaf_[body] != BoundsTree::kNone;
    }

    void clear() {
        tree_.clear();
        firstLeaf_.clear();
        nextLeaf_.clear();
    }
    /// Replaces all leaves. Leaves of one body must be in the order of parts. Makes room for as
    /// many parts and bodies, so that the next one moves no array.
    void build(std::vector<BoundsTree::Leaf>& leaves, std::size_t parts, std::size_t bodies) {
        clear();
        std::vector<std::uint32_t> nodes;
        tree_.build(leaves, nodes, parts);
        firstLeaf_.reserve(bodies);
        nextLeaf_.reserve(2 * parts);
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            chain(nodes[i], leaves[i].body);
        }
    }
    /// Parts of one body must be inserted in their order.
    void insert(const BoundsTree::Leaf& leaf) { chain(tree_.insert(leaf), leaf.body); }
    /// Removes the leaves of a body.
    void remove(std::uint32_t body) {
        if (!has(body)) {
            return;
        }
        std::uint32_t leaf = std::exchange(firstLeaf_[body], BoundsTree::kNone);
        for (; leaf != BoundsTree::kNone; leaf = nextLeaf_[leaf]) {
            tree_.remove(leaf);
        }
    }

    /// True if the body has as many leaves as `count`, and isInside(leaf, part) for each of them.
    template <typename IsInside>
    bool fits(std::uint32_t body, std::size_t count, IsInside isInside) const {
        std::uint32_t leaf = has(body) ? firstLeaf_[body] : BoundsTree::kNone;
        for (; count > 0 && leaf != BoundsTree::kNone; leaf = nextLeaf_[leaf]) {
            if (!isInside(tree_.box(leaf), --count)) {
                return false;
            }
        }
        return count == 0 && leaf == BoundsTree::kNone;
    }

    /// Gives the leaves of a body other boxes: box(part).
    template <typename BoxOf>
    void move(std::uint32_t body, std::size_t count, BoxOf boxOf) {
        std::uint32_t leaf = has(body) ? firstLeaf_[body] : BoundsTree::kNone;
        for (; count > 0 && leaf != BoundsTree::kNone; leaf = nextLeaf_[leaf]) {
            tree_.move(leaf, boxOf(--count));
        }
    }

private:
    void chain(std::uint32_t leaf, std::uint32_t body) {
        if (body >= firstLeaf_.size()) {
            firstLeaf_.resize(body + std::size_t{1}, BoundsTree::kNone);
        }
        nextLeaf_.resize(std::max(nextLeaf_.size(), tree_.capacity()), BoundsTree::kNone);
        nextLeaf_[leaf] = std::exchange(firstLeaf_[body], leaf);
    }

    BoundsTree tree_;
    std::vector<std::uint32_t> firstLeaf_; // by body: node of its last part, or kNone
    std::vector<std::uint32_t> nextLeaf_;  // by node: that of the part before, or kNone
};

} // namespace KODO_PRECISION
} // namespace kodo
