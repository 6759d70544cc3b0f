// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kodo {

/// Sets of indices that have none in common, to be joined (union-find, with halved paths).
/// The root of a set is its least index, in whatever order it was joined.
class DisjointSets {
public:
    /// New indices are in no set.
    void resize(std::size_t count) { parent_.resize(count, kNone); }
    /// Puts an index into a set of its own.
    void makeSet(std::uint32_t index) { parent_[index] = index; }
    /// Takes an index out of its set, from which all others must be taken as well.
    void drop(std::uint32_t index) { parent_[index] = kNone; }
    bool contains(std::uint32_t index) const { return parent_[index] != kNone; }

    /// Of an index that is in a set.
    std::uint32_t rootOf(std::uint32_t index) {
        while (parent_[index] != index) {
            parent_[index] = parent_[parent_[index]];
            index = parent_[index];
        }
        return index;
    }

    /// The roots before: that of the joined set, and the other, which may be the same.
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

    std::vector<std::uint32_t> parent_; // a root is its own
};

} // namespace kodo
