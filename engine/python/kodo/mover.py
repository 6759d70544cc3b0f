# SPDX-License-Identifier: MIT
"""Characters that are moved by casts instead of forces."""
from __future__ import annotations

import dataclasses
from ctypes import byref
from typing import TYPE_CHECKING

from . import _structs as c
from ._library import call
from .shapes import BuiltShape, Capsule, Primitive
from .values import (BodyId, Filter, Transform, Vec2, from_body_id, from_transform, from_vec2,
                     to_body_id, to_filter, to_real, to_vec2)

if TYPE_CHECKING:
    from .world import World


@dataclasses.dataclass
class Mover:
    """A character that walks on slopes, climbs steps, stays on the ground over crests, and rides on
    moving bodies. Call move() after World.step(). A value: `dataclasses.replace(mover)` copies it,
    to go back with a copy of the World."""

    shape: Primitive = Capsule((0.0, -0.4), (0.0, 0.4), 0.3)  #: never turns; no plane
    position: Vec2 = (0.0, 0.0)  #: m, world: of the shape's frame; set it to teleport
    up: Vec2 = (0.0, 1.0)  #: unit
    slope_limit: float = 0.9  #: rad, 0 to 1.5: steepest ground that it stands on
    step_height: float = 0.3  #: m: of steps that it climbs, and descends without a fall
    skin: float = 0.01  #: m, > 0: gap that it keeps from everything
    push_force: float = 0.0  #: N: largest force on a dynamic body in its way
    weight: float = 0.0  #: N, on a dynamic body below it
    which: Filter = Filter()  #: what blocks it; sensors never do
    body: BodyId = BodyId()  #: a kinematic body that follows, one step late; BodyId(): none

    # Results of the last move().

    velocity: Vec2 = (0.0, 0.0)  #: m/s; on the ground relative to it, across `up`; else in the world
    grounded: bool = False  #: on ground up to slope_limit, or wedged between steeper slopes
    ground_normal: Vec2 = (0.0, 0.0)  #: unit, out of the ground; zero in the air
    ground_body: BodyId = BodyId()  #: BodyId() in the air
    ground_pose: Transform = Transform((0.0, 0.0), (1.0, 0.0))  #: of ground_body then
    wall_normal: Vec2 = (0.0, 0.0)  #: unit, out of what stopped it sideways; zero if nothing did

    def move(self, world: World, wish: Vec2, dt: float) -> None:
        """Moves for dt (s) with a wished velocity (m/s), as `velocity` is meant. With a part along
        `up` the mover jumps, and takes the velocity of the ground with it. Else, on the ground, the
        part across `up` is the speed along the ground. Gravity may be added always."""
        built = BuiltShape(self.shape)
        made = self._struct(built)
        call("kodo_moveMover", world.handle, byref(made), to_vec2(wish), to_real("dt", dt))
        self.position = from_vec2(made.position)
        self.velocity = from_vec2(made.velocity)
        self.grounded = made.grounded
        self.ground_normal = from_vec2(made.groundNormal)
        self.ground_body = from_body_id(made.groundBody)
        self.ground_pose = from_transform(made.groundPose)
        self.wall_normal = from_vec2(made.wallNormal)

    def _struct(self, built: BuiltShape) -> c.Mover:
        made = c.initialised(c.Mover)
        made.shape = built.struct
        made.position, made.up = to_vec2(self.position), to_vec2(self.up)
        made.slopeLimit, made.stepHeight, made.skin = self.slope_limit, self.step_height, self.skin
        made.pushForce, made.weight = self.push_force, self.weight
        made.which, made.body = to_filter(self.which), to_body_id(self.body)
        made.velocity, made.grounded = to_vec2(self.velocity), self.grounded
        made.groundNormal = to_vec2(self.ground_normal)
        made.groundBody = to_body_id(self.ground_body)
        place, turn = self.ground_pose
        made.groundPose = c.Transform(to_vec2(place), c.Rot(*turn))
        made.wallNormal = to_vec2(self.wall_normal)
        return made
