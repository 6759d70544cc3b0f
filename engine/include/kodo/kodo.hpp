// SPDX-License-Identifier: MIT
#pragma once

/// Kodo, a 2D rigid-body engine. This header includes all others.
///
/// CONVENTIONS
///   units     SI: metres, kilograms, seconds, radians. Density in kg/m^2, impulse in N s.
///   axes      x to the right, y up. Angles counter-clockwise.
///   polygons  convex, corners counter-clockwise.
///   pairs     a before b by index. Normals point from a to b. Separation < 0 is overlap.
///   frames    position is the origin of the shape's frame. Velocities are of the centre of mass.
///   order     bodies(), joints(), brokenJoints() and overlaps are in the order of ids,
///             collisions() in that of a, its part, b, its part. Rays list what they hit first.
///   bits      the same calls give the same bits with every compiler, CPU and thread count.
///   errors    bad values and unknown joints throw BadDefinition, unknown bodies BadBodyId, bytes
///             that are no snapshot BadSnapshot, changes within a step std::logic_error. Nothing
///             has changed then.

#include <kodo/axis_lock.hpp>
#include <kodo/debug_draw.hpp>
#include <kodo/executor.hpp>
#include <kodo/explosion.hpp>
#include <kodo/geometry.hpp>
#include <kodo/mover.hpp>
#include <kodo/query.hpp>
#include <kodo/snapshot.hpp>
#include <kodo/state_hash.hpp>
#include <kodo/step_stats.hpp>
#include <kodo/version.hpp>
#include <kodo/world.hpp>
