# SPDX-License-Identifier: MIT
"""Handles to bodies."""
from __future__ import annotations

import ctypes
from ctypes import byref
from typing import TYPE_CHECKING, List, Optional, Tuple, Union

from . import _structs as c
from ._library import call
from .shapes import BuiltShape, MassDef, Part, Primitive, from_shape, to_mass
from .values import (Aabb, BodyId, BodyType, ContinuousMode, Filter, Material, Transform, Vec2,
                     from_aabb, from_body_id, from_material, from_transform, from_vec2, to_bits,
                     to_body_id, to_filter, to_group, to_material, to_mode, to_real, to_rot, to_type,
                     to_vec2)

if TYPE_CHECKING:
    from .world import World


def _built(part: Part) -> Tuple[BuiltShape, c.Part]:
    """A part in C, and what keeps its shape alive."""
    built = BuiltShape(part.shape)
    which = to_filter(part.filter or Filter())
    return built, c.Part(built.struct, to_material(part.material), part.density,
                         part.filter is not None, which, to_bits("user_data", part.user_data))


class Body:
    """One body of a World: a light handle that checks its id at each use (BadBodyId). Setters
    raise BadDefinition for bad values, and nothing has changed then."""

    __slots__ = ("world", "id")

    def __init__(self, world: World, body_id: BodyId) -> None:
        self.world = world
        self.id = body_id

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Body) and self.id == other.id and self.world is other.world

    def __hash__(self) -> int:
        return hash(self.id)

    def __repr__(self) -> str:
        return f"<kodo.Body {self.id.index} of generation {self.id.generation}>"

    def _call(self, name: str, *arguments: object) -> None:
        call(name, self.world.handle, to_body_id(self.id), *arguments)

    def _state(self) -> c.BodyState:
        state = c.BodyState()
        self._call("kodo_bodyState", byref(state))
        return state

    # Each property reads the body again; transform has pose and angle in one.

    @property
    def position(self) -> Vec2:
        """m, world: origin of the shape's frame. Setting it is a teleport, without velocity."""
        return from_vec2(self._state().transform.position)

    @position.setter
    def position(self, position: Vec2) -> None:
        self._call("kodo_setPosition", to_vec2(position))

    @property
    def angle(self) -> float:
        """-pi to pi (rad), of the shape's frame. Setting it is a teleport too."""
        return self.transform.angle

    @angle.setter
    def angle(self, angle: float) -> None:
        self._call("kodo_setRotation", to_rot(angle))

    @property
    def transform(self) -> Transform:
        """Of the shape's frame."""
        return from_transform(self._state().transform)

    @property
    def center(self) -> Vec2:
        """m, world: centre of mass."""
        return from_vec2(self._state().massFrame.position)

    @property
    def velocity(self) -> Vec2:
        """m/s, of the centre of mass."""
        return from_vec2(self._state().velocity)

    @velocity.setter
    def velocity(self, velocity: Vec2) -> None:
        self._call("kodo_setVelocity", to_vec2(velocity))

    @property
    def angular_velocity(self) -> float:
        """rad/s, counter-clockwise."""
        return self._state().angularVelocity

    @angular_velocity.setter
    def angular_velocity(self, radians_per_second: float) -> None:
        self._call("kodo_setAngularVelocity", to_real("angular_velocity", radians_per_second))

    @property
    def type(self) -> BodyType:
        return BodyType(self._state().type)

    @type.setter
    def type(self, kind: BodyType) -> None:
        self._call("kodo_setType", ctypes.c_int32(to_type(kind)))

    @property
    def flags(self) -> int:
        """Categories, and Flags."""
        return self._state().flags

    @flags.setter
    def flags(self, flags: int) -> None:
        self._call("kodo_setFlags", ctypes.c_uint64(to_bits("flags", flags)))

    @property
    def required(self) -> int:
        """Categories that the match mode in flags compares with those of another body."""
        return self._state().required

    @required.setter
    def required(self, required: int) -> None:
        self._call("kodo_setRequired", ctypes.c_uint64(to_bits("required", required)))

    @property
    def group(self) -> int:
        """Bodies of one group collide if it is > 0, and do not if it is < 0; 0 is no group."""
        return self._state().group

    @group.setter
    def group(self, group: int) -> None:
        self._call("kodo_setGroup", ctypes.c_int32(to_group(group)))

    @property
    def user_data(self) -> int:
        """0 to 2^64 - 1; the engine never reads it."""
        return self._state().userData

    @user_data.setter
    def user_data(self, number: int) -> None:
        self._call("kodo_setUserData", ctypes.c_uint64(to_bits("user_data", number)))

    @property
    def linear_damping(self) -> float:
        """1/s: the velocity falls by exp(-c t) without forces."""
        return self._state().linearDamping

    @linear_damping.setter
    def linear_damping(self, per_second: float) -> None:
        self._call("kodo_setLinearDamping", to_real("linear_damping", per_second))

    @property
    def angular_damping(self) -> float:
        """1/s, likewise."""
        return self._state().angularDamping

    @angular_damping.setter
    def angular_damping(self, per_second: float) -> None:
        self._call("kodo_setAngularDamping", to_real("angular_damping", per_second))

    @property
    def gravity_scale(self) -> float:
        """Of the forces of all gravity fields."""
        return self._state().gravityScale

    @gravity_scale.setter
    def gravity_scale(self, scale: float) -> None:
        self._call("kodo_setGravityScale", to_real("gravity_scale", scale))

    @property
    def continuous_mode(self) -> ContinuousMode:
        """Against which bodies continuous collision checks it; of a pair the lower mode counts."""
        return ContinuousMode(self._state().continuousMode)

    @continuous_mode.setter
    def continuous_mode(self, mode: ContinuousMode) -> None:
        self._call("kodo_setContinuousMode", to_mode(mode))

    @property
    def mass(self) -> float:
        """kg, also of a static or kinematic body."""
        return self._state().mass

    @property
    def inertia(self) -> float:
        """kg m^2, about the centre of mass."""
        return self._state().inertia

    @property
    def local_center(self) -> Vec2:
        """m, in the frame of the shape: centre of mass."""
        return from_vec2(self._state().localCenter)

    @property
    def has_set_mass(self) -> bool:
        return self._state().hasSetMass

    @property
    def area(self) -> float:
        """m^2; overlapping parts count twice."""
        return self._state().area

    @property
    def bounds(self) -> Aabb:
        """m, world."""
        return from_aabb(self._state().bounds)

    @property
    def is_asleep(self) -> bool:
        return self._state().isAsleep

    @property
    def parts(self) -> List[Part]:
        """The convex parts, in the frame of the shape."""
        return [self._part(index) for index in range(self._state().partCount)]

    def _part(self, index: int) -> Part:
        part, room = c.Part(), 0
        while True:
            corners = (c.Vec2 * room)()
            self._call("kodo_part", ctypes.c_size_t(index), byref(part), corners,
                       ctypes.c_size_t(room))
            if part.shape.kind != 2 or part.shape.polygon.cornerCount <= room:
                break
            room = part.shape.polygon.cornerCount
        shape = from_shape(part.shape, [from_vec2(corner) for corner in corners])
        which = part.filter
        own = Filter(which.flags, which.required, which.group) if part.hasFilter else None
        return Part(shape, from_material(part.material), part.density, own, part.userData)

    def set_part(self, index: int, part: Part) -> None:
        """Changes a part: `body.set_part(0, dataclasses.replace(body.parts[0], density=2))`. A
        mass that was set stays: then the shape must stay too."""
        built, made = _built(part)
        self._call("kodo_setPart", ctypes.c_size_t(index), byref(made))

    def velocity_at(self, point: Vec2) -> Vec2:
        """m/s, of the body at a point of the world (m)."""
        velocity = c.Vec2()
        self._call("kodo_velocityAt", to_vec2(point), byref(velocity))
        return from_vec2(velocity)

    def contains(self, point: Vec2) -> bool:
        """Whether a point of the world (m) is inside or on the edge."""
        contained = ctypes.c_bool()
        self._call("kodo_containsPoint", to_vec2(point), byref(contained))
        return contained.value

    def move_to(self, position: Vec2, dt: float, angle: Optional[float] = None) -> None:
        """Sets the velocities that bring the shape's frame to a pose in one step of dt (s)."""
        if angle is None:
            self._call("kodo_moveTo", to_vec2(position), to_real("dt", dt))
        else:
            pose = c.Transform(to_vec2(position), to_rot(angle))
            self._call("kodo_moveToPose", pose, to_real("dt", dt))

    def apply_force(self, force: Vec2, point: Optional[Vec2] = None) -> None:
        """N, during the next step: at the centre of mass, or at a point of the world (m)."""
        if point is None:
            self._call("kodo_applyForce", to_vec2(force))
        else:
            self._call("kodo_applyForceAt", to_vec2(force), to_vec2(point))

    def apply_torque(self, torque: float) -> None:
        """N m, counter-clockwise, during the next step."""
        self._call("kodo_applyTorque", to_real("torque", torque))

    def apply_impulse(self, impulse: Vec2, point: Optional[Vec2] = None) -> None:
        """N s, at once: at the centre of mass, or at a point of the world (m)."""
        if point is None:
            self._call("kodo_applyImpulse", to_vec2(impulse))
        else:
            self._call("kodo_applyImpulseAt", to_vec2(impulse), to_vec2(point))

    def apply_angular_impulse(self, impulse: float) -> None:
        """N m s, counter-clockwise, at once."""
        self._call("kodo_applyAngularImpulse", to_real("impulse", impulse))

    def set_material(self, material: Material) -> None:
        """Of all parts."""
        self._call("kodo_setMaterial", byref(to_material(material)))

    def set_mass(self, mass: Union[float, MassDef]) -> None:
        """kg; a MassDef also sets centre of mass and moment of inertia."""
        given = mass if isinstance(mass, MassDef) else MassDef(mass)
        self._call("kodo_setMass", byref(to_mass(given)))

    def set_mass_from_density(self) -> None:
        """As it was before set_mass()."""
        self._call("kodo_setMassFromDensity")

    def copy_from(self, other: Body) -> None:
        """Makes the body move as another one, of this or another World, with its own shapes."""
        self._call("kodo_copyBodyFrom", other.world.handle, to_body_id(other.id))

    def clone(self, position: Vec2) -> Body:
        """Adds a copy of the body at another position (m, world)."""
        added = c.BodyId()
        self._call("kodo_cloneBody", to_vec2(position), byref(added))
        return Body(self.world, from_body_id(added))

    def weld(self, part: Union[Body, Part, Primitive], density: float = 1.0) -> int:
        """Takes over the parts of another body, which is removed, or a part of its own, in the
        frame of its shape. Returns the index of the first part added."""
        first = ctypes.c_size_t()
        if isinstance(part, Body):
            self._call("kodo_weld", to_body_id(part.id), byref(first))
        else:
            given = part if isinstance(part, Part) else Part(part, density=density)
            built, made = _built(given)
            self._call("kodo_weldPart", byref(made), byref(first))
        return first.value

    def unweld(self, part: int, flags: Optional[int] = None) -> Body:
        """Makes a part a body of its own. With flags, a dynamic one with these flags."""
        added = c.BodyId()
        given = None if flags is None else byref(ctypes.c_uint64(to_bits("flags", flags)))
        self._call("kodo_unweld", ctypes.c_size_t(part), given, byref(added))
        return Body(self.world, from_body_id(added))

    def wake(self) -> None:
        """Wakes the body, its island, and all that touches it."""
        self._call("kodo_wake")

    def sleep(self) -> bool:
        """Puts the island of the body to sleep. False if something keeps it awake."""
        asleep = ctypes.c_bool()
        self._call("kodo_sleep", byref(asleep))
        return asleep.value

    def remove(self) -> None:
        """Removes the body and its joints."""
        self._call("kodo_removeBody")
