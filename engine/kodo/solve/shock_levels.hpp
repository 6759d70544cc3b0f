// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/real.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Body `upper` rests on body `lower`: a contact whose normal opposes the pull on them.
struct SupportEdge {
    std::uint32_t lower;
    std::uint32_t upper;
};

/// Height of every body above the ground, counted in contacts: 0 for the immovable ones, else one
/// more than the highest body that carries it. What nothing immovable carries stays unreached.
///
/// Shock propagation solves level by level and freezes the levels done, so that a tall stack stands
/// after few passes [Guendelman03, section 7]. The thesis sorts all contacts by height instead,
/// which grows dear with many stacks (4.2.2.2); this takes time linear in bodies and edges, however
/// many stacks they form.
///
/// Bodies that rest on each other in a circle are levelled in the order in which a breadth-first
/// search from the ground meets them. Same input, same levels, on every machine.
class ShockLevels {
public:
    static constexpr std::uint32_t kUnreached = ~std::uint32_t{};

    /// By body, of 0 to bodyCount - 1; valid until the next call. The object holds nothing but
    /// memory for the next call.
    std::span<const std::uint32_t> find(std::uint32_t bodyCount,
                                        std::span<const std::uint32_t> immovable,
                                        std::span<const SupportEdge> edges);

private:
    void groupByLower(std::uint32_t bodyCount, std::span<const SupportEdge> edges);
    void reach(std::span<const std::uint32_t> immovable);
    void assignLevels();

    std::vector<std::uint32_t> levels_;
    std::vector<std::uint32_t> first_;   // by body: where its uppers begin
    std::vector<std::uint32_t> uppers_;  // grouped by lower
    std::vector<std::uint32_t> order_;   // breadth first from the ground
    std::vector<std::uint32_t> waiting_; // by body: carriers without a level yet
    std::vector<std::uint32_t> queue_;
};

} // namespace kodo::inline KODO_PRECISION
