// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/collide/manifold.hpp>
#include <kodo/shapes/convex.hpp>

namespace kodo::inline KODO_PRECISION {

/// One-sided lines, and chains of them: platforms and ground.
///
/// The other outline is in front of a line or behind it by its middle; what is behind is let pass.
/// Every direction belongs to one line of a chain: a line owns its own normal, and the line that
/// starts at a joint owns the directions between the normals of the two that meet there, if the
/// joint bends away (a hilltop). So a contact never has a normal that the ground itself does not
/// have, and what slides over a flush joint feels nothing.
Manifold collideOneSided(const Convex& line, const Transform& a, const Convex& other,
                         const Transform& b, Real margin, Real preference);

/// Does the line deal with what touches it at vertex `end`, 0 or 1? Not at a joint that is flush or
/// bends inwards, where nothing but the faces can touch, nor at a hilltop that the next one owns.
bool ownsVertex(const Convex& line, std::size_t end);

/// May the line push what touches it at vertex `end` along a direction (unit, in the line's frame,
/// away from the line)? At an end without neighbour: along all that lead to its front.
bool ownsDirection(const Convex& line, std::size_t end, Vec2 direction);

/// What a contact with a one-sided line remembers from step to step, so that what has come from
/// behind stays free until it is out, though its middle is in front by then. Give it what it
/// returned for this contact in the last step (false for a new one), and the manifold of now; call
/// it in every step in which the pair exists, also when the two are not near. When it returns true
/// the contact is passing, and the manifold is empty.
bool letPass(bool passing, Manifold& manifold);

} // namespace kodo::inline KODO_PRECISION
