// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include "base/pair_lists.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// The joints of each body, and the pairs of bodies that they exclude from contacts. of() sorts.
class JointLists {
public:
    void clear();
    /// Adds a joint of bodies a and b, which may be the same. `excludes`: it forbids a contact
    /// between the two.
    void add(std::uint32_t joint, std::uint32_t a, std::uint32_t b, bool excludes);
    void remove(std::uint32_t joint);
    std::size_t size() const { return size_; }
    /// True if a joint forbids a contact between the two bodies. Takes as long as the shorter list.
    bool exclude(std::uint32_t a, std::uint32_t b) const;
    bool hasAny(std::uint32_t body) const { return lists_.firstOf(body) != PairLists::kEnd; }

    /// Visits the joints of a body, in no particular order.
    template <typename Visit>
    void forEach(std::uint32_t body, Visit visit) const {
        lists_.forEach(body, visit);
    }
    /// Lists the joints of a body in order.
    void list(std::uint32_t body, std::vector<std::uint32_t>& joints) const;
    /// The joints of a body, in order.
    std::vector<std::uint32_t> of(std::uint32_t body) const;

private:
    /// The bodies of a joint.
    struct Pair {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        bool excludes = false;
    };

    PairLists lists_;         // by body
    std::vector<Pair> pairs_; // by joint
    std::size_t size_ = 0;    // joints
};

} // namespace KODO_PRECISION
} // namespace kodo
