# SPDX-License-Identifier: MIT
"""Plain values: vectors are tuples (x, y) in metres, angles are in radians, counter-clockwise."""
from __future__ import annotations

import ctypes
import dataclasses
import enum
import operator
from typing import NamedTuple, Optional, Sequence, Tuple, Type

from . import _structs as c
from ._library import Real, library

#: (x, y): x to the right, y up.
Vec2 = Tuple[float, float]
#: (lower left corner, upper right corner), in metres.
Aabb = Tuple[Vec2, Vec2]

library.kodo_rotation.restype = c.Rot
library.kodo_angle.restype = Real


class BodyType(enum.IntEnum):
    """How a body moves."""

    DYNAMIC = 0  #: by forces, contacts and joints
    KINEMATIC = 1  #: by the velocity that it is given
    STATIC = 2  #: never


class ContinuousMode(enum.IntEnum):
    """Against which bodies continuous collision checks a body. Of a pair, the lower mode counts."""

    NEVER = 0  #: it may tunnel, and passes sensors unnoticed
    STATIC = 1  #: static and kinematic ones, and others that nothing moves
    ALL = 2


class Flags(enum.IntFlag):
    """Flags of a body beside the 48 categories of the user (bits 0 to 15 and 32 to 63)."""

    LOCK_MOVE = 1 << 16  #: infinite mass
    LOCK_ROTATE = 1 << 17  #: infinite moment of inertia
    DISABLED = 1 << 18  #: collides with nothing, no query finds it
    ASLEEP = 1 << 19  #: status
    NEVER_SLEEP = 1 << 20  #: the body keeps its island awake
    COLLIDING = 1 << 21  #: status: touched something in the last step
    SENSOR = 1 << 22  #: detects overlap, without any response
    FROZEN = 1 << 23  #: status: see World.frozen_bodies()
    OUTSIDE = 1 << 24  #: status: outside the region
    NO_SENSORS = 1 << 25  #: of queries alone: parts that are sensors are left out
    DEFAULT_CATEGORY = 1 << 26  #: of `required` alone: bodies without a category
    MATCH_NONE = 1 << 27  #: collides where none of the required flags is set
    MATCH_ANY = 1 << 28  #: where at least one of the required flags is set
    MATCH_ALL = 1 << 29  #: where all of them are set
    MATCH_EQUAL = 1 << 30  #: where exactly these are set


class StartOverlap(enum.IntEnum):
    """What a cast does with a part that its shape overlaps or touches at the start."""

    REPORT = 0  #: a hit with fraction 0 and a zero normal
    NORMAL = 1  #: with the normal of least overlap; no hit if the displacement leads outwards
    IGNORE = 2  #: no hit: the shape passes


class Phase(enum.IntEnum):
    """Phase of a contact."""

    BEGIN = 0
    PERSIST = 1
    END = 2


@dataclasses.dataclass(frozen=True, order=True)
class BodyId:
    """Names a body of a World and of its copies. Compared by index and generation."""

    index: int = 0
    generation: int = 0
    world: int = dataclasses.field(default=0, compare=False)  #: stamp of the World


@dataclasses.dataclass(frozen=True, order=True)
class JointId:
    """Names a joint of a World and of its copies. Compared by index and generation."""

    index: int = 0
    generation: int = 0
    world: int = dataclasses.field(default=0, compare=False)  #: stamp of the World


class MixRule(enum.IntEnum):
    """How a coefficient of a contact follows from two. Of two rules, the later one counts."""

    GEOMETRIC_MEAN = 0
    MINIMUM = 1
    MEAN = 2
    MULTIPLY = 3
    MAXIMUM = 4


@dataclasses.dataclass(frozen=True)
class Material:
    """Surface of a body or part."""

    static_friction: float = 0.6  #: >= kinetic_friction
    kinetic_friction: float = 0.6  #: >= 0
    restitution: float = 0.0  #: 0 to 2; above 1 an impact adds energy
    rolling_resistance: float = 0.0  #: >= 0; as share of the radius
    surface_speed: float = 0.0  #: m/s, clockwise around the body, as of a belt
    friction_rule: MixRule = MixRule.GEOMETRIC_MEAN
    restitution_rule: MixRule = MixRule.MINIMUM


def with_friction(friction: float, restitution: float = 0.0) -> Material:
    """A material with equal static and kinetic friction."""
    return Material(friction, friction, restitution)


class Filter(NamedTuple):
    """Which bodies a query, a field or a force concerns. Filter() is all."""

    flags: int = 0  #: at most one of MATCH_NONE, MATCH_ANY, MATCH_ALL, MATCH_EQUAL; NO_SENSORS
    required: int = 0  #: categories that the mode compares with those of a body
    group: int = 0  #: before the mode: > 0 finds the bodies of the group, < 0 leaves them out


class Transform(NamedTuple):
    """Pose of a frame."""

    position: Vec2  #: m
    rotation: Vec2  #: (cosine, sine) of the angle

    @property
    def angle(self) -> float:
        """-pi to pi (rad)."""
        return library.kodo_angle(c.Rot(*self.rotation))

    def __mul__(self, point: Vec2) -> Vec2:  # type: ignore[override]
        """A local point in the world (m)."""
        (x, y), (cosine, sine) = self.position, self.rotation
        return (cosine * point[0] - sine * point[1] + x, sine * point[0] + cosine * point[1] + y)

    def to_local(self, point: Vec2) -> Vec2:
        """A point of the world (m) in this frame."""
        cosine, sine = self.rotation
        x, y = point[0] - self.position[0], point[1] - self.position[1]
        return (cosine * x + sine * y, cosine * y - sine * x)


def to_vec2(value: Sequence[float]) -> c.Vec2:
    try:
        x, y = value
        return c.Vec2(x, y)
    except (TypeError, ValueError):
        raise TypeError(f"a vector must be two numbers, (x, y), but is {value!r}") from None


def to_real(name: str, value: float) -> ctypes._SimpleCData[float]:
    try:
        return Real(value)
    except TypeError:
        raise TypeError(f"{name}: must be a number, but is {value!r}") from None


def to_type(value: BodyType) -> int:
    try:
        return BodyType(value)
    except ValueError:
        raise TypeError(f"type: must be a BodyType, but is {value!r}") from None


def to_mode(value: ContinuousMode) -> int:
    try:
        return ContinuousMode(value)
    except ValueError:
        raise TypeError(f"continuous_mode: must be a ContinuousMode, but is {value!r}") from None


def _to_integer(name: str, value: int) -> int:
    try:
        return operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: must be an integer, but is {value!r}") from None


def to_bits(name: str, value: int) -> int:
    """64 bits. ctypes alone would cut off what is beyond them."""
    bits = _to_integer(name, value)
    if not 0 <= bits < 1 << 64:
        raise ValueError(f"{name}: must have bits 0 to 63, but is {value}")
    return bits


def to_group(value: int) -> int:
    group = _to_integer("group", value)
    if not -(1 << 31) <= group < 1 << 31:
        raise ValueError(f"group: must be from -2^31 to 2^31 - 1, but is {value}")
    return group


def to_rot(angle: float) -> c.Rot:
    return library.kodo_rotation(to_real("angle", angle))


def to_aabb(box: Aabb) -> c.Aabb:
    return c.Aabb(to_vec2(box[0]), to_vec2(box[1]))


def to_body_id(body: BodyId) -> c.BodyId:
    if not isinstance(body, BodyId):
        raise TypeError(f"a body is named by a Body or a BodyId, but is {body!r}")
    return c.BodyId(body.index, body.generation, body.world)


def to_joint_id(joint: JointId) -> c.JointId:
    if not isinstance(joint, JointId):
        raise TypeError(f"a joint is named by its JointId, but is {joint!r}")
    return c.JointId(joint.index, joint.generation, joint.world)


def to_filter(which: Filter) -> c.Filter:
    return c.Filter(to_bits("flags", which[0]), to_bits("required", which[1]), to_group(which[2]))


def to_material(m: Material) -> c.Material:
    if not isinstance(m, Material):
        raise TypeError(f"material: must be a Material, as with_friction(0.5), but is {m!r}")
    *numbers, friction, restitution = dataclasses.astuple(m)
    return c.Material(*numbers, int(friction), int(restitution))


def to_range(limits: Optional[Tuple[float, float]]) -> c.Range:
    try:
        return c.Range(*(limits or (0.0, 0.0)))
    except TypeError:
        raise TypeError(f"limits: must be (lower, upper), but is {limits!r}") from None


def from_vec2(v: c.Vec2) -> Vec2:
    return (v.x, v.y)


def from_aabb(box: c.Aabb) -> Aabb:
    return (from_vec2(box.lower), from_vec2(box.upper))


def from_transform(t: c.Transform) -> Transform:
    return Transform(from_vec2(t.position), (t.rotation.c, t.rotation.s))


def from_material(m: c.Material) -> Material:
    *numbers, friction, restitution = (getattr(m, name) for name, _ in c.Material._fields_)
    return Material(*numbers, MixRule(friction), MixRule(restitution))


def from_body_id(i: c.BodyId) -> BodyId:
    return BodyId(i.index, i.generation, i.world)


def from_joint_id(i: c.JointId) -> JointId:
    return JointId(i.index, i.generation, i.world)


def to_array(struct: Type[c.Struct], items: Sequence[c.Struct]) -> ctypes.Array[c.Struct]:
    return (struct * len(items))(*items)
