// SPDX-License-Identifier: MIT
#pragma once

#include "contacts/hiding_step.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// True for normals of one flat surface.
inline bool isSameWay(Vec2 a, Vec2 b) {
    return dot(a, b) > Real(0.99999);
}

/// Suppresses ghost collisions with the internal edges of ground that consists of several pieces.
///
/// A body that slides over two flush immovable pieces, or lands on them, meets the side or a corner
/// of the second. A contact keeps the body above the surface of the first for the whole step, also
/// before it touches; a corner does not, as the body may turn on it. So if the whole second piece
/// lies below that surface, its contact is hidden for the step; without a point, once the body
/// touches the first. If the piece rises from the surface that the body touches, even by less than
/// a slop, a contact at its lowest vertex becomes one with the face that rises. A real step or wall
/// keeps its contact. Only contacts of the same part are compared: another part, such as a fork
/// around a wall, may be below the surface. A blow may turn the far end of a body into a hidden
/// piece within the step: ContinuousCollision stops a pair that meets along the surface.
class GhostCollisions {
public:
    /// Sizes the array by body.
    void makeRoom(const Bodies& bodies) { resizeByBody(first_, bodies, kEnd); }
    /// Must be called after contacts were added, removed or moved, or a body became immovable or
    /// movable. `onGround`: slots of the contacts between an immovable and a movable body, in
    /// order, without sensors.
    void link(const Bodies& bodies, std::span<const ContactSummary> summaries,
              std::span<const std::uint32_t> onGround);
    /// Hides or replaces the ghost collisions of this step.
    void hide(const HidingStep& step) const;

private:
    static constexpr std::uint32_t kEnd = ~std::uint32_t{};

    std::vector<std::uint32_t> first_;    // by body: its first contact with an immovable body
    std::vector<std::uint32_t> linked_;   // bodies with such a contact
    std::vector<std::uint32_t> next_;     // by contact: the next one of the same body
    std::vector<std::uint32_t> onPieces_; // bodies with two or more such contacts
};

} // namespace KODO_PRECISION
} // namespace kodo
