# SPDX-License-Identifier: MIT
"""Kodo, a 2D rigid-body engine.

Units are SI: metres, kilograms, seconds, radians. x points to the right, y up; angles are
counter-clockwise. The same calls give the same bits on every machine, and as in C and C++.

    import kodo

    world = kodo.World(gravity=(0, -10))
    world.add(kodo.Box(20, 1), type=kodo.BodyType.STATIC)
    ball = world.add(kodo.Circle(0.5), position=(0, 10))
    for _ in range(120):
        world.step(1 / 60)
    print(ball.position)
"""
from ._library import REAL_CODE, REAL_SIZE, library as _library
from .body import Body
from .errors import (BadBodyId, BadDefinition, BadSnapshot, KodoError, NoMemory, OtherError,
                     WrongUse)
from .fields import Attractor, Buoyancy, Drag, FieldBody, FieldForce, Gravity, OwnField, Wind
from .geometry import convex_hull, decompose
from .joints import (BrokenJoint, DistanceJoint, FilterJoint, FixedJoint, GearJoint, JointState,
                     MotorJoint, MouseJoint, PrismaticJoint, PulleyJoint, RevoluteJoint, WheelJoint)
from .mover import Mover
from .records import (ClosestPoints, CollisionRecord, ExplosionHit, QueryContact, QueryHit,
                      QueryPoint, RaySpan, RecordPoint, StepStats)
from .settings import (Feature, PropagationSettings, Settings, SoftSettings, accurate, balanced,
                       fast, thesis2006)
from .shapes import (Box, Capsule, Chain, Circle, Compound, Heightmap, MassDef, Part, Plane, Point,
                     Polygon, Segment)
from .values import (BodyId, BodyType, ContinuousMode, Filter, Flags, JointId, Material, MixRule,
                     Phase, StartOverlap, Transform, with_friction)
from .world import ThreadPool, World
from .worlds import Worlds

_number = _library.kodo_version()
#: Version of the library.
__version__ = f"{_number // 10000}.{_number // 100 % 100}.{_number % 100}"

__all__ = [
    "Attractor",
    "BadBodyId",
    "BadDefinition",
    "BadSnapshot",
    "Body",
    "BodyId",
    "BodyType",
    "Box",
    "BrokenJoint",
    "Buoyancy",
    "Capsule",
    "Chain",
    "Circle",
    "ClosestPoints",
    "CollisionRecord",
    "Compound",
    "ContinuousMode",
    "DistanceJoint",
    "Drag",
    "ExplosionHit",
    "Feature",
    "FieldBody",
    "FieldForce",
    "Filter",
    "FilterJoint",
    "FixedJoint",
    "Flags",
    "GearJoint",
    "Gravity",
    "Heightmap",
    "JointId",
    "JointState",
    "KodoError",
    "MassDef",
    "Material",
    "MixRule",
    "MotorJoint",
    "MouseJoint",
    "Mover",
    "NoMemory",
    "OtherError",
    "OwnField",
    "Part",
    "Phase",
    "Plane",
    "Point",
    "Polygon",
    "PrismaticJoint",
    "PropagationSettings",
    "PulleyJoint",
    "QueryContact",
    "QueryHit",
    "QueryPoint",
    "REAL_CODE",
    "REAL_SIZE",
    "RaySpan",
    "RecordPoint",
    "RevoluteJoint",
    "Segment",
    "Settings",
    "SoftSettings",
    "StartOverlap",
    "StepStats",
    "ThreadPool",
    "Transform",
    "WheelJoint",
    "Wind",
    "World",
    "Worlds",
    "WrongUse",
    "accurate",
    "balanced",
    "convex_hull",
    "decompose",
    "fast",
    "thesis2006",
    "with_friction",
]
