// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>
#include <kodo/shape.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// A binary tree of bounding boxes [Ericson05, 6.2]. Each leaf is a box with two numbers of its
/// owner; each inner node is the union of its children. A search descends into nodes that it
/// reaches, so its cost grows with the logarithm of the number of leaves.
class BoundsTree {
public:
    static constexpr std::uint32_t kNone = ~std::uint32_t{};
    /// Returned by the `entry` of a search for a box that it does not reach.
    static constexpr Real kMissed = std::numeric_limits<Real>::infinity();

    struct Leaf {
        Aabb box;
        std::uint32_t body;
        std::uint32_t part;
    };

    /// Replaces all leaves. `places` gets the node of each, in the same order. Makes room for as
    /// many leaves as `room`.
    void build(std::vector<Leaf>& leaves, std::vector<std::uint32_t>& places, std::size_t room);
    /// Returns the node of the new leaf.
    std::uint32_t insert(const Leaf& leaf);
    void remove(std::uint32_t node);
    /// Gives a leaf another box. One that stays near keeps its place in the tree.
    void move(std::uint32_t leaf, const Aabb& box);
    void clear();

    const Aabb& box(std::uint32_t leaf) const { return nodes_[leaf].box; }
    /// Number of nodes, used and free.
    std::size_t capacity() const { return nodes_.size(); }
    /// Largest number of nodes between the root and a leaf.
    std::size_t height() const;

    /// Calls visit(body, part) for the leaves with entry(box) < kMissed. Children with the smaller
    /// entry come first, so a search for the closest leaf may return kMissed beyond the best one
    /// that it has found.
    template <typename Entry, typename Visit>
    void search(Entry entry, Visit visit) const {
        if (root_ == kNone || !(entry(nodes_[root_].box) < kMissed)) {
            return;
        }
        SmallVector<std::uint32_t, kStack> open;
        std::size_t size = 0; // of `open` in use
        for (std::uint32_t at = root_;;) {
            const Node& node = nodes_[at];
            if (node.isLeaf()) {
                visit(node.first, node.second);
            } else {
                std::uint32_t near = node.first;
                std::uint32_t far = node.second;
                Real nearEntry = entry(nodes_[near].box);
                Real farEntry = entry(nodes_[far].box);
                if (farEntry < nearEntry) {
                    std::swap(near, far);
                    std::swap(nearEntry, farEntry);
                }
                if (nearEntry < kMissed) {
                    if (farEntry < kMissed) {
                        put(open, size, far);
                    }
                    at = near;
                    continue;
                }
            }
            do { // the limit of the search may have come nearer since the node was put there
                if (size == 0) {
                    return;
                }
                at = open.data()[--size];
            } while (!(entry(nodes_[at].box) < kMissed));
        }
    }

private:
    static constexpr std::size_t kStack = 64;

    struct Node {
        Aabb box;
        std::uint32_t parent = kNone; // of a free node: the next free one
        std::uint32_t first = 0;      // child; of a leaf: the body
        std::uint32_t second = 0;     // child; of a leaf: the part
        bool leaf = false;

        bool isLeaf() const { return leaf; }
    };

    static void put(SmallVector<std::uint32_t, kStack>& open, std::size_t& size,
                    std::uint32_t node) {
        if (size == open.size()) {
            open.push_back(node);
        } else {
            open.data()[size] = node;
        }
        ++size;
    }

    std::uint32_t newNode();
    void freeNode(std::uint32_t node);
    std::uint32_t siblingFor(const Aabb& box) const;
    void attach(std::uint32_t leaf);
    void detach(std::uint32_t leaf);
    void replaceChild(std::uint32_t parent, std::uint32_t child, std::uint32_t by);
    void refit(std::uint32_t node);
    void rotate(std::uint32_t node);
    bool rotateWith(std::uint32_t node, std::uint32_t high, std::uint32_t low);
    std::uint32_t buildRange(std::vector<Leaf>& leaves, std::vector<std::uint32_t>& order,
                             std::size_t first, std::size_t last,
                             std::vector<std::uint32_t>& places);

    std::vector<Node> nodes_;
    std::uint32_t root_ = kNone;
    std::uint32_t free_ = kNone;
};

} // namespace KODO_PRECISION
} // namespace kodo
