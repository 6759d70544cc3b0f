# SPDX-License-Identifier: MIT
"""Joints. `a` and `b` are bodies; anchors are in the frames of their shapes (m). Forces and torques
are those on b."""
from __future__ import annotations

import dataclasses
import math
from typing import Any, List, NamedTuple, Optional, Tuple, Type, Union

from . import _structs as c
from .values import BodyId, JointId, Vec2, from_body_id, to_bits, to_body_id, to_range

Range = Tuple[float, float]


@dataclasses.dataclass
class _Ends:
    a: BodyId
    b: BodyId
    anchor_a: Vec2 = (0.0, 0.0)  #: m
    anchor_b: Vec2 = (0.0, 0.0)  #: m
    break_force: float = math.inf  #: N, > 0; a larger one, as mean of a step, breaks the joint
    break_torque: float = math.inf  #: N m, > 0; likewise
    collide: bool = False  #: True: the two bodies collide with each other
    user_data: int = 0  #: for the user


@dataclasses.dataclass
class RevoluteJoint(_Ends):
    """Hinge: both anchors coincide, and the bodies rotate about them. With a spring, a ratchet,
    or limits beyond -3 to 3 rad, it counts its turns."""

    reference: float = 0.0  #: rad; relative angle of b that counts as 0
    limits: Optional[Range] = None  #: rad
    motor_speed: float = 0.0  #: rad/s, of b relative to a
    motor_torque: float = 0.0  #: N m, >= 0; 0: no motor
    target: float = 0.0  #: rad, rest angle of the spring
    hertz: float = 0.0  #: stiffness, as frequency about the anchor; 0: no spring
    damping: float = 0.0  #: damping ratio; 1 is critical
    ratchet: float = 0.0  #: rad between teeth: the lower limit follows; < 0: the upper; 0: none


@dataclasses.dataclass
class FixedJoint(_Ends):
    """The anchors coincide and the relative angle is constant."""

    reference: float = 0.0  #: rad; relative angle of b
    hertz: float = 0.0  #: stiffness, as frequency of the pair; 0: rigid
    damping: float = 0.0  #: damping ratio; 1 is critical


@dataclasses.dataclass
class DistanceJoint(_Ends):
    """A spring, a rod (hertz 0, equal limits), a rope (hertz 0, limits from 0) or a winch
    (motor)."""

    length: float = 1.0  #: m, rest length of the spring
    hertz: float = 0.0  #: stiffness, as frequency of the pair; 0: no spring
    damping: float = 0.0  #: damping ratio; 1 is critical
    limits: Optional[Range] = None  #: m, of the distance
    motor_speed: float = 0.0  #: m/s, of the distance
    motor_force: float = 0.0  #: N, >= 0; 0: no motor


@dataclasses.dataclass
class PrismaticJoint(_Ends):
    """b slides along an axis fixed to a, without relative rotation."""

    axis: Vec2 = (1.0, 0.0)  #: unit, in the frame of a's shape
    reference: float = 0.0  #: rad; relative angle of b
    limits: Optional[Range] = None  #: m, of anchor b along the axis
    motor_speed: float = 0.0  #: m/s
    motor_force: float = 0.0  #: N, >= 0; 0: no motor
    target: float = 0.0  #: m, rest translation of the spring
    hertz: float = 0.0  #: stiffness, as frequency of the pair; 0: no spring
    damping: float = 0.0  #: damping ratio; 1 is critical


@dataclasses.dataclass
class MotorJoint(_Ends):
    """Drives anchor b to anchor a, and b to an angle relative to a, with limited force. With
    hertz 0 it brakes alone, as friction."""

    reference: float = 0.0  #: rad; target of the relative angle of b
    force: float = 0.0  #: N, >= 0; the largest
    torque: float = 0.0  #: N m, >= 0; the largest
    hertz: float = 30.0  #: stiffness, as frequency of the pair
    damping: float = 1.0  #: damping ratio; 1 is critical


@dataclasses.dataclass
class MouseJoint:
    """Pulls a point of one body towards a target."""

    body: BodyId
    anchor: Vec2 = (0.0, 0.0)  #: m, in the frame of the body's shape
    target: Vec2 = (0.0, 0.0)  #: m, world
    force: float = 1.0  #: N, > 0; the largest
    hertz: float = 5.0  #: stiffness, with the body's mass
    damping: float = 0.7  #: damping ratio; 1 is critical
    user_data: int = 0  #: for the user


@dataclasses.dataclass
class WheelJoint(_Ends):
    """The axle, anchor b, stays on a line through anchor a that is fixed to a."""

    axis: Vec2 = (0.0, 1.0)  #: unit, in the frame of a's shape
    limits: Optional[Range] = None  #: m, of the axle along the axis
    hertz: float = 0.0  #: stiffness, as frequency of the pair; 0: no spring
    damping: float = 0.0  #: damping ratio; 1 is critical
    motor_speed: float = 0.0  #: rad/s, of b relative to a
    motor_torque: float = 0.0  #: N m, >= 0; 0: no motor


@dataclasses.dataclass
class PulleyJoint(_Ends):
    """A rope from anchor a over two points of the world to anchor b."""

    ground_a: Vec2 = (0.0, 0.0)  #: m, world
    ground_b: Vec2 = (0.0, 0.0)  #: m, world
    length: float = 1.0  #: m, of the rope: that to a + ratio times that to b
    ratio: float = 1.0


@dataclasses.dataclass
class GearJoint(_Ends):
    """The speed of b is `ratio` times that of a, as seen from the line between the anchors. With a
    rack, which is fixed to a, b rolls along it by `ratio` (m) per rad."""

    ratio: float = -1.0  #: size 0.001 to 1000; negative for teeth, positive for a belt
    rack: Optional[Vec2] = None  #: unit, in the frame of a's shape


@dataclasses.dataclass
class FilterJoint(_Ends):
    """The two bodies do not collide with each other."""


Joint = Union[
    RevoluteJoint, FixedJoint, DistanceJoint, PrismaticJoint, MotorJoint, MouseJoint,
    WheelJoint, PulleyJoint, GearJoint, FilterJoint
]


class JointState(NamedTuple):
    """Where a joint is, and how it moves: b relative to a."""

    anchor_a: Vec2  #: m, world; of a MouseJoint: the target
    anchor_b: Vec2  #: m, world
    angle: float  #: rad, from the reference; -pi to pi, or counted
    angular_speed: float  #: rad/s
    length: float  #: m, between the anchors; of a PulleyJoint: of the taut rope
    length_speed: float  #: m/s
    translation: float  #: m, along the axis of a PrismaticJoint or WheelJoint; else 0
    speed: float  #: m/s, likewise


class BrokenJoint(NamedTuple):
    """A joint that its load broke in the last step. Its id is no longer valid."""

    id: JointId
    a: BodyId
    b: BodyId
    force: float  #: N, mean over the step
    torque: float  #: N m, likewise


# In the order of kodo_JointKind: class, and member of the union.
_KINDS: List[Tuple[Type[Any], str]] = [
    (RevoluteJoint, "revolute"),
    (FixedJoint, "fixed"),
    (DistanceJoint, "distance"),
    (PrismaticJoint, "prismatic"),
    (MotorJoint, "motor"),
    (MouseJoint, "mouse"),
    (WheelJoint, "wheel"),
    (PulleyJoint, "pulley"),
    (GearJoint, "gear"),
    (FilterJoint, "filter"),
]
_ENDS = [field.name for field in dataclasses.fields(_Ends)]


def _name_in_c(name: str) -> str:
    first, *rest = name.split("_")
    return first + "".join(word.capitalize() for word in rest)


def _write(struct: Any, name: str, value: Any) -> None:
    if name == "limits":
        struct.hasLimits, struct.limits = value is not None, to_range(value)
    elif name == "rack":
        struct.hasRack, struct.rack = value is not None, c.Vec2(*(value or (0.0, 0.0)))
    elif name == "user_data":
        struct.userData = to_bits(name, value)
    elif isinstance(value, BodyId):
        setattr(struct, name, to_body_id(value))
    elif isinstance(value, tuple):
        setattr(struct, _name_in_c(name), c.Vec2(*value))
    else:
        setattr(struct, _name_in_c(name), value)


def _read(struct: Any, name: str) -> Any:
    value = getattr(struct, _name_in_c(name))
    if name == "limits":
        return (value.lower, value.upper) if struct.hasLimits else None
    if name == "rack" and not struct.hasRack:
        return None
    if isinstance(value, c.BodyId):
        return from_body_id(value)
    return (value.x, value.y) if isinstance(value, c.Vec2) else value


def to_joint(joint: Joint) -> c.JointDef:
    for kind, (made_of, member) in enumerate(_KINDS):
        if isinstance(joint, made_of):
            made = c.initialised(c.JointDef, kind)
            struct = getattr(made, member)
            for field in dataclasses.fields(joint):
                ends = field.name in _ENDS and hasattr(struct, "ends")
                value = getattr(joint, field.name)
                value = getattr(value, "id", value)  # a Body stands for its id
                _write(struct.ends if ends else struct, field.name, value)
            return made
    raise TypeError(f"{joint!r} is no joint")


def from_joint(made: c.JointDef) -> Joint:
    made_of, member = _KINDS[made.kind]
    struct = getattr(made, member)
    values = {}
    for field in dataclasses.fields(made_of):
        ends = field.name in _ENDS and hasattr(struct, "ends")
        values[field.name] = _read(struct.ends if ends else struct, field.name)
    return made_of(**values)
