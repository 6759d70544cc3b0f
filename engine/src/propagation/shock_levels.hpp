// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Body `upper` rests on body `lower`: the normal of a contact opposes their acceleration.
struct SupportEdge {
    std::uint32_t lower;
    std::uint32_t upper;
};

/// Levels of bodies above the ground, in contacts. A level is 0 for immovable bodies, else one more
/// than that of the highest body that supports it. Bodies without immovable support stay unreached.
///
/// Shock propagation solves level by level and freezes the finished levels, so that a tall stack is
/// stable after few passes [Guendelman03, section 7]. The thesis sorts all contacts by height
/// instead, which is slow for many stacks (4.2.2.2). This class takes time linear in bodies and
/// edges, for any number of stacks.
///
/// Bodies that support each other in a cycle get their levels in breadth-first order from the
/// ground. Equal inputs give equal levels on every machine.
class ShockLevels {
public:
    static constexpr std::uint32_t kUnreached = ~std::uint32_t{};

    /// By body, for 0 to bodyCount - 1; valid until the next call. The object keeps only memory
    /// between calls.
    std::span<const std::uint32_t> find(std::uint32_t bodyCount,
                                        std::span<const std::uint32_t> immovable,
                                        std::span<const SupportEdge> edges);

private:
    void groupByLower(std::uint32_t bodyCount, std::span<const SupportEdge> edges);
    void reach(std::span<const std::uint32_t> immovable);
    void assignLevels();

    std::vector<std::uint32_t> levels_;
    std::vector<std::uint32_t> first_;   // by body: its first entry in uppers_
    std::vector<std::uint32_t> uppers_;  // grouped by lower body
    std::vector<std::uint32_t> order_;   // breadth-first from the ground
    std::vector<std::uint32_t> waiting_; // by body: supports without a level yet
    std::vector<std::uint32_t> queue_;
};

} // namespace KODO_PRECISION
} // namespace kodo
