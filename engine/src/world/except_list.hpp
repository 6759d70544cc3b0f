// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// The bodies that a query leaves out. A short list is searched as it is. A long one is sorted
/// once as many searches have been made as would cost the same.
class ExceptList {
public:
    ExceptList(const Bodies& bodies, std::span<const BodyId> ids) : bodies_(bodies), ids_(ids) {}

    bool contains(std::uint32_t body) {
        if (ids_.size() > kShort && (std::size_t{1} << searches_++) > ids_.size()) {
            sort();
        }
        const auto isOfBody = [&](BodyId id) {
            ++visits_;
            return id.index == body && bodies_.alive(id);
        };
        return std::any_of(ids_.begin(), ids_.end(), isOfBody) ||
               std::binary_search(sorted_.begin(), sorted_.end(), body, Before{visits_});
    }
    /// Ids visited by all searches and by sorting.
    std::uint64_t visits() const { return visits_; }

private:
    static constexpr std::size_t kShort = 16; // searched without an allocation

    struct Before {
        std::uint64_t& visits;
        bool operator()(std::uint32_t a, std::uint32_t b) const {
            ++visits;
            return a < b;
        }
    };
    void sort() {
        for (const BodyId id : std::exchange(ids_, {})) {
            if (bodies_.alive(id)) {
                sorted_.push_back(id.index);
            }
        }
        // total order: equal indices are identical
        std::sort(sorted_.begin(), sorted_.end(), Before{visits_});
    }

    const Bodies& bodies_;
    std::span<const BodyId> ids_;       // empty once sorted
    std::vector<std::uint32_t> sorted_; // bodies
    int searches_ = 0;
    std::uint64_t visits_ = 0;
};

} // namespace KODO_PRECISION
} // namespace kodo
