# SPDX-License-Identifier: MIT
"""Joints. `a` and `b` are bodies; anchors are in the frames of their shapes (m). Forces and torques
are those on b."""
from __future__ import annotations

import dataclasses
import math
from typing import Any, List, NamedTuple, Optional, Tuple, Type, Union

from . import _structs as c
from .values import BodyId, JointId, Vec2, from_body_id, to_body_id, to_range

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


@dataclasses.dataclass
class RevoluteJoint(_Ends):
    """Hinge: both anchors coincide, and the bodies rotate about them."""

    reference: float = 0.0  #: rad; relative angle of b that counts as 0
    limits: Optional[Range] = None  #: rad, -3 to 3
    motor_speed: float = 0.0  #: rad/s, of b relative to a
    motor_torque: float = 0.0  #: N m, >= 0; 0: no motor


@dataclasses.dataclass
class FixedJoint(_Ends):
    """The anchors coincide and the relative angle is constant."""

    reference: float = 0.0  #: rad; relative angle of b


@dataclasses.dataclass
class DistanceJoint(_Ends):
    """A spring, a rod (hertz 0, equal limits) or a rope (hertz 0, limits from 0)."""

    length: float = 1.0  #: m, rest length of the spring
    hertz: float = 0.0  #: stiffness, as frequency of the pair; 0: no spring
    damping: float = 0.0  #: damping ratio; 1 is critical
    limits: Optional[Range] = None  #: m, of the distance


@dataclasses.dataclass
class PrismaticJoint(_Ends):
    """b slides along an axis fixed to a, without relative rotation."""

    axis: Vec2 = (1.0, 0.0)  #: unit, in the frame of a's shape
    reference: float = 0.0  #: rad; relative angle of b
    limits: Optional[Range] = None  #: m, of anchor b along the axis
    motor_speed: float = 0.0  #: m/s
    motor_force: float = 0.0  #: N, >= 0; 0: no motor


@dataclasses.dataclass
class MotorJoint(_Ends):
    """Drives anchor b to anchor a, and b to an angle relative to a, with limited force."""

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


Joint = Union[
    RevoluteJoint, FixedJoint, DistanceJoint, PrismaticJoint, MotorJoint, MouseJoint
]


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
]
_ENDS = [field.name for field in dataclasses.fields(_Ends)]


def _name_in_c(name: str) -> str:
    first, *rest = name.split("_")
    return first + "".join(word.capitalize() for word in rest)


def _write(struct: Any, name: str, value: Any) -> None:
    if name == "limits":
        struct.hasLimits, struct.limits = value is not None, to_range(value)
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
