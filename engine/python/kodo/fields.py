# SPDX-License-Identifier: MIT
"""Force fields."""
from __future__ import annotations

import contextlib
import ctypes
import dataclasses
import itertools
from typing import Any, Callable, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple, Union

from . import _structs as c
from .values import (Aabb, BodyId, Filter, Transform, Vec2, from_aabb, from_body_id,
                     from_transform, from_vec2, to_aabb, to_array, to_filter,
                     to_vec2)


@dataclasses.dataclass(frozen=True)
class Gravity:
    """Force = mass * acceleration."""

    acceleration: Vec2  #: m/s^2


@dataclasses.dataclass(frozen=True)
class Drag:
    """Drag of a fluid that moves with one velocity everywhere; per width of the body."""

    linear: float = 0.0  #: N per m/s and m
    quadratic: float = 0.0  #: N per (m/s)^2 and m
    air: Vec2 = (0.0, 0.0)  #: m/s


@dataclasses.dataclass(frozen=True)
class Wind:
    """Drag of a fluid within a region."""

    linear: float = 0.0  #: N per m/s and m
    quadratic: float = 0.0  #: N per (m/s)^2 and m
    velocity: Vec2 = (0.0, 0.0)  #: m/s
    region: Optional[Aabb] = None  #: m, world; None: everywhere


@dataclasses.dataclass(frozen=True)
class Attractor:
    """Acceleration towards a point, equal for all masses; a negative strength repels."""

    center: Vec2  #: m, world
    strength: float  #: m^3/s^2, or 1/s^2 if linear
    softening: float = 0.0  #: m
    linear: bool = False  #: True: grows with the distance; False: inverse square


@dataclasses.dataclass(frozen=True)
class Buoyancy:
    """A fluid at rest below a surface, which is perpendicular to gravity."""

    density: float = 1.0  #: kg/m^2
    drag: float = 0.0  #: kg/(m^2 s)
    surface: Vec2 = (0.0, 0.0)  #: m, world; a point of the surface
    gravity: Vec2 = (0.0, -10.0)  #: m/s^2


class FieldForce(NamedTuple):
    """What a field of the user exerts on one body in one step."""

    force: Vec2 = (0.0, 0.0)  #: N, at the centre of mass
    torque: float = 0.0  #: N m
    drag: float = 0.0  #: N s/m, >= 0: how much the force decreases with the velocity
    spin_drag: float = 0.0  #: N m s, >= 0: likewise, with the angular velocity


class FieldBody:
    """The body that a field of the user acts on. Valid within the call alone."""

    def __init__(self, struct: c.FieldBody) -> None:
        self._struct = struct

    @property
    def id(self) -> BodyId:
        return from_body_id(self._struct.id)

    @property
    def flags(self) -> int:
        return self._struct.flags

    @property
    def transform(self) -> Transform:
        """Of the shape's frame."""
        return from_transform(self._struct.transform)

    @property
    def mid_step(self) -> Transform:
        """Of the centre of mass, after half a step without forces."""
        return from_transform(self._struct.midStep)

    @property
    def velocity(self) -> Vec2:
        """m/s, of the centre of mass."""
        return from_vec2(self._struct.velocity)

    @property
    def angular_velocity(self) -> float:
        """rad/s."""
        return self._struct.angularVelocity

    @property
    def mass(self) -> float:
        """kg."""
        return self._struct.mass

    @property
    def inertia(self) -> float:
        """kg m^2, about the centre of mass."""
        return self._struct.inertia

    @property
    def user_data(self) -> int:
        return self._struct.userData


class OwnField:
    """A field of the user: a function of body and dt (s) that returns a FieldForce. It must depend
    on its arguments alone, since copies of a World share it."""

    def __init__(self, function: Callable[[FieldBody, float], FieldForce], steady: bool = False):
        self.function = function
        self.steady = steady  #: the force depends on mass, shape and flags of the body alone


Field = Union[OwnField, Gravity, Drag, Wind, Attractor, Buoyancy]

# Contexts of fields of the user, as long as a World has them.
_fields: Dict[int, OwnField] = {}
_numbers = itertools.count(1)
#: Exceptions of fields since the last step that reported one.
errors: List[BaseException] = []


def _at(context: int, body: Any, dt: float, force: Any) -> None:
    try:
        result = _fields[context].function(FieldBody(body.contents), dt)
        out = force.contents
        out.force.x, out.force.y = result[0]
        out.torque, out.drag, out.spinDrag = result[1:]
    except BaseException as error:  # pylint: disable=broad-except # raised again after the step
        errors.append(error)


def _end(context: int) -> None:
    _fields.pop(context, None)


_AT = c.FIELD_FUNCTION(_at)
_END = c.END_FUNCTION(_end)


def raise_errors() -> None:
    """Raises the first exception of a field of the user since the last call."""
    if errors:
        first = errors[0]
        errors.clear()
        raise first


def _own(field: OwnField) -> c.OwnField:
    number = next(_numbers)  # each object of the engine has a context of its own, and ends it
    _fields[number] = field
    return c.OwnField(_AT, _END, number, field.steady)


def to_field(field: Field, which: Filter = Filter()) -> c.Field:
    names = [OwnField, Gravity, Drag, Wind, Attractor, Buoyancy]
    if type(field) not in names:
        raise TypeError(f"{field!r} is no field")
    made = c.initialised(c.Field, names.index(type(field)))
    made.which = to_filter(which)
    if isinstance(field, OwnField):
        made.own = _own(field)
    elif isinstance(field, Gravity):
        made.gravity = c.Gravity(to_vec2(field.acceleration))
    elif isinstance(field, Drag):
        made.drag = c.Drag(c.DragLaw(field.linear, field.quadratic), to_vec2(field.air))
    elif isinstance(field, Wind):
        region = field.region or ((0.0, 0.0), (0.0, 0.0))
        made.wind = c.Wind(c.DragLaw(field.linear, field.quadratic), to_vec2(field.velocity),
                           field.region is not None, to_aabb(region))
    elif isinstance(field, Attractor):
        made.attractor = c.Attractor(int(field.linear), to_vec2(field.center), field.strength,
                                     field.softening)
    else:
        made.buoyancy = c.Buoyancy(field.density, field.drag, to_vec2(field.surface),
                                   to_vec2(field.gravity))
    return made


def from_field(made: c.Field) -> Field:
    if made.kind == 0:
        return _fields[made.own.context]
    if made.kind == 1:
        return Gravity(from_vec2(made.gravity.acceleration))
    if made.kind == 2:
        law = made.drag.law
        return Drag(law.linear, law.quadratic, from_vec2(made.drag.air))
    if made.kind == 3:
        wind = made.wind
        region = from_aabb(wind.region) if wind.hasRegion else None
        return Wind(wind.law.linear, wind.law.quadratic, from_vec2(wind.velocity), region)
    if made.kind == 4:
        pull = made.attractor
        return Attractor(from_vec2(pull.center), pull.strength, pull.softening, pull.law == 1)
    fluid = made.buoyancy
    return Buoyancy(fluid.density, fluid.drag, from_vec2(fluid.surface), from_vec2(fluid.gravity))


@contextlib.contextmanager
def built(fields: Sequence[Tuple[Field, Filter]]) -> Iterator[ctypes.Array[c.Field]]:
    """The fields in C, for one call. If it is refused, it did not take over the contexts."""
    made = to_array(c.Field, [to_field(field, which) for field, which in fields])
    try:
        yield made
    except BaseException:
        for field in made:
            if field.kind == 0:
                _end(field.own.context)
        raise
