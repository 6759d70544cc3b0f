// SPDX-License-Identifier: MIT
#pragma once

#include "contacts/hiding_step.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Decides for a body of several parts as a whole whether it passes a one-sided line.
///
/// A part alone is let through if it comes from behind (letPass). But a part that is already in
/// front would touch the line while another part is still behind it: a jumping figure would hang
/// by its head. So a part begins no contact with a line while another part of its body passes one
/// of the same body, or lies behind the line. A contact that touched in the last step stays. Chains
/// and heightmaps are ground: there the side is determined for each part.
class OneWayBodies {
public:
    /// Must be called after contacts were added, removed or moved. Lists the contacts of one-sided
    /// lines with bodies of several parts.
    void link(const Bodies& bodies, std::span<const Contact> contacts,
              std::span<const ContactSummary> summaries);
    bool empty() const { return slots_.empty(); }
    /// Hides the contacts of this step that must not begin.
    void hide(const HidingStep& step) const;

private:
    std::vector<std::uint32_t> slots_; // by the two bodies and the key
};

} // namespace KODO_PRECISION
} // namespace kodo
