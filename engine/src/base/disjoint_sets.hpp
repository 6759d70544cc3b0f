// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kodo {

/// Disjoint sets of indices (union-find with path halving). The root of a set is its least index,
/// independent of the order of joins.
class DisjointSets {
public:
    void reserve(std::size_t count) { parent_.reserve(count); }
    /// New indices are in no set.
    void resize(std::size_t count) { parent_.resize(count, kNone); }
    /// Makes a set of one index.
    void makeSet(std::uint32_t index) { parent_[index] = index; }
    /// Removes an index from its set. All other members must be removed as well.
    void drop(std::uint32_t index) { parent_[index] = kNone; }
    bool contains(std::uint32_t index) const { return parent_[index] != kNone; }

    /// Precondition: the index is in a set.
    std::uint32_t rootOf(std::uint32_t index) {
        while (parent_[index] != index) {
            parent_[index] = parent_[parent_[index]];
            index = parent_[index];
        }
        return index;
    }

    /// Roots before a join: `root` becomes that of the joined set. They are equal if the set was
    /// the same.
    struct Roots {
        std::uint32_t root;
        std::uint32_t other;
    };
    Roots join(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t rootA = rootOf(a);
        const std::uint32_t rootB = rootOf(b);
        const Roots roots{std::min(rootA, rootB), std::max(rootA, rootB)};
        parent_[roots.other] = roots.root;
        return roots;
    }

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    std::vector<std::uint32_t> parent_; // a root is its own parent
};

} // namespace kodo
