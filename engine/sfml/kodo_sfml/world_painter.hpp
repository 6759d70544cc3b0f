// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world.hpp>
#include <kodo_sfml/painter.hpp>

#include <kodo_draw/camera.hpp>

namespace kodo_sfml {

using kodo_draw::Camera;

/// Selects what is drawn of a World.
struct WorldLook {
    bool shapes = true;    // filled, with a line from the centre that shows the rotation; sleeping
                           // bodies are almost transparent
    bool contacts = false; // of the last step: point and normal
    bool impulses = false; // of the last step: a line along the normal, length by totalImpulse
    bool bounds = false;   // bounds of the bodies
    float metresPerImpulse = 0.1f; // m/(N s), length of these lines
    bool joints = true;            // see joint_painter.hpp
};

/// Adds a World to a picture. Dynamic bodies are coloured by id; static and kinematic ones are
/// grey.
void paintWorld(Painter& painter, const Camera& camera, const kodo::World& world,
                const WorldLook& look = {});

/// The outline of a part in pixels, as a convex polygon: arcs become chords, and of a plane the
/// shown piece is taken. A point has one corner, a segment without radius two.
std::vector<Pixel> outlineOf(const kodo::ConvexShape& convex, const kodo::Transform& massFrame,
                             const Camera& camera);

} // namespace kodo_sfml
