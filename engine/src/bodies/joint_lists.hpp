// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// The joints of each body, as doubly linked lists. To add or remove a joint takes constant time.
/// The order within a list depends on the history; of() sorts.
class JointLists {
public:
    void clear();
    /// Adds a joint of bodies a and b, which may be the same. `excludes`: it forbids a contact
    /// between the two.
    void add(std::uint32_t joint, std::uint32_t a, std::uint32_t b, bool excludes);
    void remove(std::uint32_t joint);
    std::size_t size() const { return size_; }
    /// True if each joint forbids the contact of its bodies.
    bool allExclude() const { return excluding_ == size_; }
    /// True if a joint forbids a contact between the two bodies. Takes as long as the shorter list.
    bool exclude(std::uint32_t a, std::uint32_t b) const;
    bool hasAny(std::uint32_t body) const { return body < first_.size() && first_[body] != kNone; }

    /// Visits the joints of a body, in no particular order.
    template <typename Visit>
    void forEach(std::uint32_t body, Visit visit) const {
        for (std::uint32_t end = hasAny(body) ? first_[body] : kNone; end != kNone;
             end = ends_[end].next) {
            visit(end / 2);
        }
    }
    /// Lists the joints of a body in order.
    void list(std::uint32_t body, std::vector<std::uint32_t>& joints) const;
    /// The joints of a body, in order.
    std::vector<std::uint32_t> of(std::uint32_t body) const;

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{};

    /// One end of a joint, in the list of its body.
    struct End {
        std::uint32_t body = kNone;
        std::uint32_t next = kNone; // index of an end
        std::uint32_t before = kNone;
        bool excludes = false;
    };
    void link(std::uint32_t end, std::uint32_t body, bool excludes);
    void unlink(std::uint32_t end);

    std::vector<std::uint32_t> first_; // by body: index of an end
    std::vector<End> ends_;            // two for each joint
    std::size_t size_ = 0;             // joints
    std::size_t excluding_ = 0;        // joints that exclude a contact
};

} // namespace KODO_PRECISION
} // namespace kodo
