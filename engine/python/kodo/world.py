# SPDX-License-Identifier: MIT
"""A World: bodies, joints, force fields and their simulation."""
from __future__ import annotations

import ctypes
import dataclasses
from ctypes import byref, c_bool, c_size_t, c_uint64
from typing import Any, Iterator, List, Optional, Sequence, Tuple, Type, TypeVar, Union

from . import _structs as c
from . import fields as _fields
from ._library import call, library
from .body import Body
from .buffers import readable, writable
from .fields import Field, OwnField
from .joints import BrokenJoint, Joint, JointState, from_joint, to_joint
from .records import (ClosestPoints, CollisionRecord, ExplosionHit, QueryContact, QueryHit,
                      QueryPoint, RaySpan, StepStats, from_hit, from_query_point, from_record)
from .settings import Settings, from_settings, to_settings
from .shapes import BuiltShape, Circle, MassDef, Shape, to_mass
from .values import (Aabb, BodyId, BodyType, ContinuousMode, Filter, JointId, Material, StartOverlap,
                     Vec2, from_aabb, from_body_id, from_joint_id, from_vec2, to_aabb, to_array,
                     to_bits, to_body_id, to_filter, to_group, to_joint_id, to_material, to_mode,
                     to_real, to_rot, to_type, to_vec2)

#: A handle or an id names a body.
BodyLike = Union[Body, BodyId]
Struct = TypeVar("Struct", bound=ctypes.Structure)


def id_of(body: BodyLike) -> c.BodyId:
    return to_body_id(body.id if isinstance(body, Body) else body)


class ThreadPool:
    """Threads that help a step. One pool can serve many Worlds, one call at a time."""

    def __init__(self, helpers: int) -> None:
        """Starts 0 to 255 threads."""
        self.handle = ctypes.c_void_p()
        call("kodo_createThreadPool", ctypes.c_int32(helpers), byref(self.handle))

    def __del__(self) -> None:
        if getattr(self, "handle", None):
            library.kodo_destroyThreadPool(self.handle)


class World:
    """Bodies, joints, force fields and their simulation. `copy()` is a snapshot that continues with
    the same bits; ids name the same bodies in it."""

    __slots__ = ("handle", "__weakref__")  # a misspelled property is an error

    def __init__(
        self,
        gravity: Vec2 = (0.0, 0.0),
        length_unit: float = 1.0,
        settings: Optional[Settings] = None,
    ) -> None:
        """gravity: m/s^2; length_unit: m, size of a typical body."""
        definition = c.initialised(c.WorldDef)
        definition.gravity = to_vec2(gravity)
        definition.lengthUnit = length_unit
        if settings is not None:
            definition.settings = to_settings(settings)
        self.handle = ctypes.c_void_p()
        call("kodo_createWorld", byref(definition), byref(self.handle))

    @classmethod
    def _owning(cls, handle: ctypes.c_void_p) -> World:
        made = cls.__new__(cls)
        made.handle = handle
        return made

    def __del__(self) -> None:
        if getattr(self, "handle", None):
            library.kodo_destroyWorld(self.handle)

    def copy(self) -> World:
        """Another World with the same state and ids."""
        handle = ctypes.c_void_p()
        call("kodo_copyWorld", self.handle, byref(handle))
        return self._owning(handle)

    __copy__ = copy

    def assign(self, other: World) -> None:
        """Makes this World equal to another one, without a new World."""
        call("kodo_assignWorld", self.handle, other.handle)

    def to_bytes(self) -> bytes:
        """A snapshot: the same on every machine."""
        size = c_size_t()
        call("kodo_toBytes", self.handle, None, c_size_t(0), byref(size))
        made = ctypes.create_string_buffer(size.value)
        call("kodo_toBytes", self.handle, made, size, byref(size))
        return made.raw

    @classmethod
    def from_bytes(cls, snapshot: bytes, own_fields: Sequence[OwnField] = ()) -> World:
        """The World of a snapshot. Fields of the user are not in the bytes: pass as many as it had,
        in their order."""
        definition = c.initialised(c.SnapshotDef)
        definition.bytes = ctypes.cast(ctypes.c_char_p(snapshot), ctypes.c_void_p)
        definition.byteCount = len(snapshot)
        handle = ctypes.c_void_p()
        with _fields.built([(field, Filter()) for field in own_fields]) as own:
            definition.ownFields, definition.ownFieldCount = own, len(own)
            call("kodo_fromBytes", byref(definition), byref(handle))
        return cls._owning(handle)

    def state_hash(self) -> int:
        """Equal for Worlds that continue alike; the same on every machine."""
        value = c_uint64()
        call("kodo_stateHash", self.handle, byref(value))
        return value.value

    # Bodies.

    def add(
        self,
        shape: Shape = Circle(0.5),
        position: Vec2 = (0.0, 0.0),
        angle: float = 0.0,
        velocity: Vec2 = (0.0, 0.0),
        angular_velocity: float = 0.0,
        material: Material = Material(),
        density: float = 1.0,
        mass: Optional[Union[float, MassDef]] = None,
        type: BodyType = BodyType.DYNAMIC,  # pylint: disable=redefined-builtin # as in C++
        flags: int = 0,
        required: int = 0,
        group: int = 0,
        user_data: int = 0,
        linear_damping: float = 0.0,
        angular_damping: float = 0.0,
        gravity_scale: float = 1.0,
        continuous_mode: ContinuousMode = ContinuousMode.ALL,
    ) -> Body:
        """Adds a body. position: m, world, of the shape's frame; angle: rad; velocity: m/s, of the
        centre of mass; angular_velocity: rad/s; density: kg/m^2; mass: kg, instead of that of the
        density; damping: 1/s."""
        definition = c.initialised(c.BodyDef)
        built = BuiltShape(shape)
        definition.shape = built.struct
        definition.position = to_vec2(position)
        definition.rotation = to_rot(angle)
        definition.velocity = to_vec2(velocity)
        definition.angularVelocity = angular_velocity
        definition.material = to_material(material)
        definition.density = density
        if mass is not None:
            definition.hasMass = True
            definition.mass = to_mass(mass if isinstance(mass, MassDef) else MassDef(mass))
        definition.type = to_type(type)
        definition.flags = to_bits("flags", flags)
        definition.required = to_bits("required", required)
        definition.group = to_group(group)
        definition.userData = to_bits("user_data", user_data)
        definition.linearDamping = linear_damping
        definition.angularDamping = angular_damping
        definition.gravityScale = gravity_scale
        definition.continuousMode = to_mode(continuous_mode)
        added = c.BodyId()
        call("kodo_addBody", self.handle, byref(definition), byref(added))
        return Body(self, from_body_id(added))

    def __getitem__(self, body: BodyLike) -> Body:
        """The handle of a body, also for an id or a handle of a copy."""
        return Body(self, body.id if isinstance(body, Body) else body)

    def __contains__(self, body: BodyLike) -> bool:
        contained = c_bool()
        call("kodo_containsBody", self.handle, id_of(body), byref(contained))
        return contained.value

    def __len__(self) -> int:
        """Number of bodies."""
        count = c_size_t()
        call("kodo_bodyCount", self.handle, byref(count))
        return count.value

    def __bool__(self) -> bool:
        return True

    @property
    def bodies(self) -> List[Body]:
        """In the order of ids."""
        ids = self._list("kodo_bodies", c.BodyId)
        return [Body(self, from_body_id(each)) for each in ids]

    @property
    def moved_bodies(self) -> List[Body]:
        """The bodies that moved or fell asleep in the last step, in the order of ids."""
        ids = self._list("kodo_movedBodies", c.BodyId)
        return [Body(self, from_body_id(each)) for each in ids]

    def __iter__(self) -> Iterator[Body]:
        return iter(self.bodies)

    def _list(self, name: str, struct: Type[Struct], *arguments: Any) -> List[Struct]:
        """The items of a call that writes a list."""
        room, count = 16, c_size_t()
        while True:
            items = (struct * room)()
            call(name, self.handle, *arguments, items, c_size_t(room), byref(count))
            if count.value <= room:
                return items[: count.value]
            room = count.value

    # Many bodies in one call.

    def poses(self, bodies: Sequence[BodyLike], out: Optional[Any] = None) -> Any:
        """x, y (m), cosine and sine of the angle of each body: a NumPy array n x 4, or without
        NumPy a memoryview of this shape. `out`, an array of the right type, is filled instead."""
        return self._read("kodo_poses", bodies, 4, out)

    def velocities(self, bodies: Sequence[BodyLike], out: Optional[Any] = None) -> Any:
        """x and y of the velocity (m/s) and angular velocity (rad/s) of each body: n x 3."""
        return self._read("kodo_velocities", bodies, 3, out)

    def _read(self, name: str, bodies: Sequence[BodyLike], width: int, out: Optional[Any]) -> Any:
        ids = to_array(c.BodyId, [id_of(body) for body in bodies])
        made, memory = writable(out, (len(ids), width))
        if memory is not None:
            call(name, byref(self.handle), c_size_t(1), ids, c_size_t(len(ids)), memory)
        return made

    def apply_loads(self, bodies: Sequence[BodyLike], loads: Any) -> None:
        """x and y of a force (N) and a torque (N m) on each body in the next step: n x 3."""
        ids = to_array(c.BodyId, [id_of(body) for body in bodies])
        memory = readable(loads, (len(ids), 3))
        if memory is not None:
            call("kodo_applyLoads", byref(self.handle), c_size_t(1), ids, c_size_t(len(ids)),
                 memory)

    # Joints.

    def add_joint(self, joint: Joint) -> JointId:
        """Adds a RevoluteJoint or another joint; its ends are bodies or their ids."""
        added = c.JointId()
        call("kodo_addJoint", self.handle, byref(to_joint(joint)), byref(added))
        return from_joint_id(added)

    def remove_joint(self, joint: JointId) -> None:
        call("kodo_removeJoint", self.handle, to_joint_id(joint))

    def contains_joint(self, joint: JointId) -> bool:
        contained = c_bool()
        call("kodo_containsJoint", self.handle, to_joint_id(joint), byref(contained))
        return contained.value

    @property
    def joints(self) -> List[JointId]:
        return [from_joint_id(each) for each in self._list("kodo_joints", c.JointId)]

    def joints_of(self, body: BodyLike) -> List[JointId]:
        """The joints of one body."""
        return [from_joint_id(each) for each in self._list("kodo_jointsOf", c.JointId, id_of(body))]

    def joint(self, joint: JointId) -> Joint:
        """A copy of the numbers of a joint; set_joint() writes them back."""
        made = c.JointDef()
        call("kodo_joint", self.handle, to_joint_id(joint), byref(made))
        return from_joint(made)

    def set_joint(self, joint: JointId, numbers: Joint) -> None:
        """Changes the numbers of a joint; kind and bodies must stay."""
        call("kodo_setJoint", self.handle, to_joint_id(joint), byref(to_joint(numbers)))

    def change_joint(self, joint: JointId, **numbers: Any) -> None:
        """Changes some numbers of a joint: `change_joint(hinge, motor_speed=3)`."""
        self.set_joint(joint, dataclasses.replace(self.joint(joint), **numbers))

    def spring_of(self, joint: Joint, stiffness: float,
                  damping: float = 0.0) -> Tuple[float, float]:
        """(hertz, damping) for a spring of that stiffness (N/m) and damping (N s/m), with the
        present masses of the bodies; of a RevoluteJoint N m/rad and N m s/rad."""
        spring = c.Spring()
        call("kodo_springOf", self.handle, byref(to_joint(joint)),
             to_real("stiffness", stiffness), to_real("damping", damping), byref(spring))
        return (spring.hertz, spring.damping)

    def joint_state(self, joint: JointId) -> JointState:
        """Angle, length and translation of a joint, their speeds, and its anchors in the world."""
        state = c.JointState()
        call("kodo_jointState", self.handle, to_joint_id(joint), byref(state))
        return JointState(from_vec2(state.anchorA), from_vec2(state.anchorB), state.angle,
                          state.angularSpeed, state.length, state.lengthSpeed, state.translation,
                          state.speed)

    def joint_load(self, joint: JointId) -> Tuple[Vec2, float]:
        """Force (N) and torque (N m) on body b: mean over the last step."""
        load = c.Load()
        call("kodo_jointLoad", self.handle, to_joint_id(joint), byref(load))
        return (from_vec2(load.force), load.torque)

    def broken_joints(self) -> List[BrokenJoint]:
        """Joints that broke in the last step."""
        return [
            BrokenJoint(from_joint_id(each.id), from_body_id(each.a), from_body_id(each.b),
                        each.force, each.torque)
            for each in self._list("kodo_brokenJoints", c.BrokenJoint)
        ]

    # Forces.

    def add_field(self, field: Field, which: Filter = Filter()) -> None:
        """Adds a force field, which acts on the bodies that the filter accepts."""
        with _fields.built([(field, which)]) as made:
            call("kodo_addField", self.handle, made)

    def set_fields(self, fields: Sequence[Tuple[Field, Filter]]) -> None:
        """Replaces all fields."""
        with _fields.built(fields) as made:
            call("kodo_setFields", self.handle, made, c_size_t(len(made)))

    @property
    def fields(self) -> List[Tuple[Field, Filter]]:
        return [
            (_fields.from_field(each), Filter(each.which.flags, each.which.required,
                                               each.which.group))
            for each in self._list("kodo_fields", c.Field)
        ]

    def apply_force_to_all(self, force: Vec2, which: Filter = Filter()) -> None:
        """N at the centre of mass, in the next step, on each body that the filter accepts."""
        call("kodo_applyForceToAll", self.handle, to_vec2(force), byref(to_filter(which)))

    def apply_torque_to_all(self, torque: float, which: Filter = Filter()) -> None:
        """N m, likewise."""
        call("kodo_applyTorqueToAll", self.handle, to_real("torque", torque),
             byref(to_filter(which)))

    # Steps.

    def step(self, dt: float, pool: Optional[ThreadPool] = None) -> None:
        """Advances by dt (s); a fixed dt is best. Raises an exception of a field of the user after
        the step, with a force of 0 where it was raised."""
        options = None
        if pool is not None:
            options = c.initialised(c.StepOptions)
            options.pool = pool.handle
        call("kodo_step", self.handle, to_real("dt", dt), options and byref(options))
        _fields.raise_errors()

    @property
    def step_count(self) -> int:
        count = c_uint64()
        call("kodo_stepCount", self.handle, byref(count))
        return count.value

    @property
    def stats(self) -> StepStats:
        """Work of the last step."""
        made = c.StepStats()
        call("kodo_stepStats", self.handle, byref(made))
        return StepStats(*(getattr(made, name) for name, _ in c.StepStats._fields_))

    @property
    def settings(self) -> Settings:
        made = c.Settings()
        call("kodo_worldSettings", self.handle, byref(made))
        return from_settings(made)

    @settings.setter
    def settings(self, settings: Settings) -> None:
        call("kodo_setSettings", self.handle, byref(to_settings(settings)))

    @property
    def region(self) -> Optional[Aabb]:
        """Only bodies whose bounds meet it (m, world) are simulated. None: all."""
        box, is_set = c.Aabb(), c_bool()
        call("kodo_region", self.handle, byref(box), byref(is_set))
        return from_aabb(box) if is_set.value else None

    @region.setter
    def region(self, box: Optional[Aabb]) -> None:
        call("kodo_setRegion", self.handle, None if box is None else byref(to_aabb(box)))

    def frozen_bodies(self) -> List[BodyId]:
        """Bodies that the last step stopped, since forces made them too fast or not finite."""
        return [from_body_id(each) for each in self._list("kodo_frozenBodies", c.BodyId)]

    # Collisions of the last step.

    def collisions(self, body: Optional[BodyLike] = None) -> List[CollisionRecord]:
        """Contacts that began, persisted or ended; of one body, or of all."""
        if body is None:
            found = self._list("kodo_collisions", c.CollisionRecord)
        else:
            found = self._list("kodo_collisionsOf", c.CollisionRecord, id_of(body))
        return [from_record(each) for each in found]

    def begun_collisions(self) -> List[CollisionRecord]:
        return [from_record(each) for each in self._list("kodo_begunCollisions", c.CollisionRecord)]

    def ended_collisions(self) -> List[CollisionRecord]:
        return [from_record(each) for each in self._list("kodo_endedCollisions", c.CollisionRecord)]

    def hits(self, min_speed: float) -> List[CollisionRecord]:
        """Impacts with an approach speed of at least min_speed (m/s)."""
        found = self._list("kodo_hits", c.CollisionRecord, to_real("min_speed", min_speed))
        return [from_record(each) for each in found]

    # Drawing.

    def svg(self, view: Optional[Aabb] = None, shapes: bool = True,
            joints: bool = True, contacts: bool = False, impulses: bool = False,
            bounds: bool = False, velocities: bool = False, centers: bool = False,
            labels: bool = False, islands: bool = False,
            metres_per_impulse: Optional[float] = None,
            seconds_of_velocity: Optional[float] = None) -> str:
        """The World as a picture, which a browser or a notebook shows. view: m, world, by default
        all bodies. Contacts and impulses are those of the last step; islands: one
        colour for bodies that touch or share a joint. metres_per_impulse (m/(N s)) and
        seconds_of_velocity (s) scale the arrows."""
        options = c.initialised(c.DrawOptions)
        options.shapes, options.joints = shapes, joints
        options.contacts, options.impulses = contacts, impulses
        options.bounds, options.velocities = bounds, velocities
        options.centers, options.labels, options.islands = centers, labels, islands
        if metres_per_impulse is not None:
            options.metresPerImpulse = metres_per_impulse
        if seconds_of_velocity is not None:
            options.secondsOfVelocity = seconds_of_velocity
        box = None if view is None else byref(to_aabb(view))
        made, size = ctypes.create_string_buffer(0), c_size_t()
        for _ in range(2):  # the second time with enough room
            made = ctypes.create_string_buffer(size.value)
            call("kodo_svg", self.handle, byref(options), box, made, size, byref(size))
        return made.raw.decode("utf-8")

    def _repr_svg_(self) -> str:
        """What a notebook shows of a World."""
        return self.svg()

    # Queries. `which` selects bodies; `ignore` leaves some out.

    def ray_cast(self, start: Vec2, end: Vec2, which: Filter = Filter(),
                 ignore: Sequence[BodyLike] = ()) -> Optional[QueryHit]:
        """The first part on a ray (m, world)."""
        hit = c.QueryHit()
        ray = c.Ray(to_vec2(start), to_vec2(end))
        call("kodo_rayCast", self.handle, ray, byref(_query(which, ignore)), byref(hit))
        return from_hit(hit) if hit.found else None

    def ray_cast_all(self, start: Vec2, end: Vec2, which: Filter = Filter(),
                     ignore: Sequence[BodyLike] = ()) -> List[QueryHit]:
        """All parts on a ray, ordered by fraction, then id, then part."""
        ray = c.Ray(to_vec2(start), to_vec2(end))
        found = self._list("kodo_rayCastAll", c.QueryHit, ray, byref(_query(which, ignore)))
        return [from_hit(hit) for hit in found]

    def ray_spans(self, start: Vec2, end: Vec2, which: Filter = Filter(),
                  ignore: Sequence[BodyLike] = ()) -> List[RaySpan]:
        """The same parts with the points where the ray leaves them."""
        ray = c.Ray(to_vec2(start), to_vec2(end))
        found = self._list("kodo_raySpans", c.RaySpan, ray, byref(_query(which, ignore)))
        return [
            RaySpan(from_hit(each.entry), each.exitFraction, from_vec2(each.exitPoint),
                    from_vec2(each.exitNormal))
            for each in found
        ]

    def shape_cast(self, shape: Shape, position: Vec2, displacement: Vec2, angle: float = 0.0,
                   which: Filter = Filter(), ignore: Sequence[BodyLike] = (), turn: float = 0.0,
                   at_start: StartOverlap = StartOverlap.REPORT) -> Optional[QueryHit]:
        """The first part that a shape meets when it moves by a displacement (m) and turns by
        `turn` (rad, -100 to 100) about its origin. position (m) and angle (rad) are those at the
        start. With a turn it stops less than a quarter of the slop before the part."""
        built, hit = BuiltShape(shape), c.QueryHit()
        cast = c.initialised(c.CastDef)
        cast.shape = built.struct
        cast.start = c.Transform(to_vec2(position), to_rot(angle))
        cast.displacement, cast.angle, cast.atStart = to_vec2(displacement), turn, int(at_start)
        call("kodo_castShape", self.handle, byref(cast), byref(_query(which, ignore)), byref(hit))
        return from_hit(hit) if hit.found else None

    def collide(self, shape: Shape, position: Vec2 = (0.0, 0.0), angle: float = 0.0,
                margin: float = 0.0, which: Filter = Filter(),
                ignore: Sequence[BodyLike] = ()) -> List[QueryContact]:
        """The deepest contact of a shape at a pose (m, rad) with each part nearer than margin
        (m, >= 0), ordered by id and part."""
        built = BuiltShape(shape)
        at = c.Transform(to_vec2(position), to_rot(angle))
        near = c.NearShape(ctypes.pointer(built.struct), at, margin)
        found = self._list("kodo_collide", c.QueryContact, byref(near),
                           byref(_query(which, ignore)))
        return [
            QueryContact(from_body_id(each.body), each.part, from_vec2(each.point),
                         from_vec2(each.normal), each.separation)
            for each in found
        ]

    def overlap_box(self, box: Aabb, which: Filter = Filter(),
                    ignore: Sequence[BodyLike] = ()) -> List[BodyId]:
        """Bodies that overlap or touch a box (m, world), in the order of ids."""
        found = self._list("kodo_overlapBox", c.BodyId, to_aabb(box),
                           byref(_query(which, ignore)))
        return [from_body_id(each) for each in found]

    def overlap(self, shape: Shape, position: Vec2 = (0.0, 0.0), angle: float = 0.0,
                which: Filter = Filter(), ignore: Sequence[BodyLike] = ()) -> List[BodyId]:
        """The same for a shape at a pose (m, rad)."""
        built = BuiltShape(shape)
        found = self._list("kodo_overlapShape", c.BodyId, byref(_placed(built, position, angle)),
                           byref(_query(which, ignore)))
        return [from_body_id(each) for each in found]

    def closest_point(self, point: Vec2, max_distance: float = float("inf"),
                      which: Filter = Filter(),
                      ignore: Sequence[BodyLike] = ()) -> Optional[QueryPoint]:
        """The closest body within max_distance (m)."""
        found = c.QueryPoint()
        call("kodo_closestPoint", self.handle, to_vec2(point),
             to_real("max_distance", max_distance), byref(_query(which, ignore)), byref(found))
        return from_query_point(found) if found.found else None

    def closest_point_of(self, body: BodyLike, point: Vec2) -> QueryPoint:
        """The point of one body closest to a point (m, world), however far."""
        found = c.QueryPoint()
        call("kodo_closestPointOf", self.handle, id_of(body), to_vec2(point), byref(found))
        return from_query_point(found)

    def distance(self, a: BodyLike, b: BodyLike) -> ClosestPoints:
        """The closest points of two bodies."""
        found = c.ClosestPoints()
        call("kodo_distance", self.handle, id_of(a), id_of(b), byref(found))
        return ClosestPoints(from_vec2(found.onA), from_vec2(found.onB), from_vec2(found.normal),
                             found.distance)

    def touching(self, body: BodyLike) -> List[BodyId]:
        """The bodies that touched a body in the last step, awake or asleep, in the order of ids.
        Of a sensor: what it holds."""
        found = self._list("kodo_touching", c.BodyId, id_of(body))
        return [from_body_id(each) for each in found]

    # Explosions and locks of one axis.

    def lock_axis(self, body: BodyLike, axis: Vec2) -> Body:
        """Locks the motion of a body along one axis (unit), (1, 0) for x: its centre stays on a
        line through its present place. The rotation stays free. Adds the static body that has the
        groove, a point that nothing meets, and returns it. Removing that body unlocks."""
        groove = c.BodyId()
        call("kodo_lockAxis", self.handle, id_of(body), to_vec2(axis), byref(groove))
        return Body(self, from_body_id(groove))

    def explode(self, center: Vec2, radius: float = 1.0, impulse: float = 1.0, falloff: float = 0.0,
                which: Filter = Filter()) -> List[ExplosionHit]:
        """Pushes the sides of dynamic bodies that the centre (m, world) sees, and lists the bodies
        in the order of ids. At full strength up to radius (m, > 0), from there on it falls to 0
        over falloff (m). impulse: N s for each metre of a side, seen from the centre; < 0 pulls.
        `which` names bodies that it pushes; all others but sensors are a cover too."""
        given = c.initialised(c.Explosion)
        given.center, given.which = to_vec2(center), to_filter(which)
        given.radius, given.impulse, given.falloff = radius, impulse, falloff
        room, count = len(self), c_size_t()
        hits = (c.ExplosionHit * room)()
        call("kodo_explode", self.handle, byref(given), hits, c_size_t(room), byref(count))
        return [
            ExplosionHit(from_body_id(each.body), from_vec2(each.point), from_vec2(each.impulse),
                         each.width)
            for each in hits[: count.value]
        ]


def _query(which: Filter, ignore: Sequence[BodyLike]) -> c.Query:
    query = c.initialised(c.Query)
    query.which = to_filter(which)
    setattr(query, "except", to_array(c.BodyId, [id_of(body) for body in ignore]))
    query.exceptCount = len(ignore)
    return query


def _placed(built: BuiltShape, position: Vec2, angle: float) -> c.PlacedShape:
    at = c.Transform(to_vec2(position), to_rot(angle))
    return c.PlacedShape(ctypes.pointer(built.struct), at)
