// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world/world.hpp>
#include <kodo_sfml/camera.hpp>
#include <kodo_sfml/painter.hpp>

namespace kodo_sfml {

/// What of a World is drawn. Off costs nothing.
struct WorldLook {
    bool shapes = true;    // filled, with a line from the middle that shows the rotation; what
                           // rests is hollow
    bool contacts = false; // of the last step: point and normal
    bool impulses = false; // of the last step: an arrow along the normal, length by totalImpulse
    bool bounds = false;   // the boxes that the broad phase sees
    float metresPerImpulse = 0.1f; // m/(N s), of the arrows
};

/// Adds a World to a picture. Bodies are told apart by colour; locked ones are grey.
void paintWorld(Painter& painter, const Camera& camera, const kodo::World& world,
                const WorldLook& look = {});

/// The corners of a part placed in a picture; a round one becomes a polygon.
std::vector<sf::Vector2f> cornersOf(const kodo::Convex& convex, const kodo::Transform& placement,
                                    const Camera& camera);

} // namespace kodo_sfml
