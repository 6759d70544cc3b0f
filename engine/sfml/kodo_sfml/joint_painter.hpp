// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world.hpp>
#include <kodo_sfml/painter.hpp>

#include <kodo_draw/camera.hpp>

namespace kodo_sfml {

using kodo_draw::Camera;

/// Adds a joint to a picture. Thin lines lead from the centres of its bodies to the anchors.
/// A pin is a ring, a fixed joint a square, a spring a zigzag, a rod or rope a line, a slider its
/// axis with bars at its limits, a motor joint a line with an arrow head at its target, and a mouse
/// joint a line with a cross at its target.
void paintJoint(Painter& painter, const Camera& camera, const kodo::World& world,
                const kodo::JointDef& joint);

} // namespace kodo_sfml
