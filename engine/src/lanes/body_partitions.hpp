// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "lanes/contact.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Ranges of body indices, one for each thread of a pass.
class BodyPartitions {
public:
    /// Finds the first body of each partition, so that all partitions have about as many contacts
    /// with a row.
    void find(const Bodies& bodies, std::span<const ContactSummary> summaries,
              std::uint32_t partitions);
    std::uint32_t count() const { return static_cast<std::uint32_t>(first_.size()); }
    std::uint8_t of(std::uint32_t body) const {
        return static_cast<std::uint8_t>(std::upper_bound(first_.begin(), first_.end(), body) -
                                         first_.begin() - 1);
    }

private:
    std::vector<std::uint32_t> first_ = {0}; // by partition: its first body
};

} // namespace KODO_PRECISION
} // namespace kodo
