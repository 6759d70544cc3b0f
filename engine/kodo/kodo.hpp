// SPDX-License-Identifier: MIT
#pragma once

/// Kodo, a 2D rigid-body engine. Include this one; everything else comes with it.
///
/// CONVENTIONS
///   units     SI: metres, kilograms, seconds, radians. Density in kg/m^2, impulse in N s.
///   axes      x right, y up; angles and turns counter-clockwise.
///   polygons  convex, corners counter-clockwise.
///   pairs     a before b by index; a normal points from a to b; separation < 0 is overlap.
///   frames    a body's position is the origin of its shape's frame; dynamics work about its
///             centre of mass.
///   order     whatever comes as a list comes in the order of ids.
///   bits      the same calls give the same bits with every compiler, CPU and day, as long as it
///             is built with -ffp-contract=off and without -ffast-math.
///   errors    bad values and ids of dead joints throw BadDefinition, ids of dead bodies BadBodyId,
///             bytes that are no snapshot BadSnapshot; nothing has changed then.

#include <kodo/base/thread_pool.hpp>
#include <kodo/bodies/fields.hpp>
#include <kodo/math/affine.hpp>
#include <kodo/shapes/box_fit.hpp>
#include <kodo/shapes/hull.hpp>
#include <kodo/world/queries.hpp>
#include <kodo/world/snapshot.hpp>
#include <kodo/world/world.hpp>
