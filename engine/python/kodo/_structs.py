# SPDX-License-Identifier: MIT
"""The structs of kodo.h. tests/python compares their sizes and offsets with the list of the ABI."""
from __future__ import annotations

import ctypes
import re
from ctypes import POINTER, c_bool, c_int32, c_size_t, c_uint8, c_uint16, c_uint32, c_uint64
from ctypes import c_void_p
from typing import Type, TypeVar

from ._library import REAL_SIZE, Real, call

VERSION = 3  # KODO_C_VERSION


class Values(ctypes.Structure):
    """A struct whose refusal of a value names its field, as the module spells it."""

    def __init__(self, *values: object) -> None:
        try:
            super().__init__(*values)
        except TypeError:
            for field, value in zip(self._fields_, values):
                setattr(self, field[0], value)
            raise

    def __setattr__(self, name: str, value: object) -> None:
        try:
            super().__setattr__(name, value)
        except TypeError:
            wanted = {Real: "a number", c_bool: "True or False"}
            kind = wanted.get(dict(field[:2] for field in self._fields_)[name], "an integer")
            raise TypeError(f"{in_python(name)}: must be {kind}, but is {value!r}") from None


def in_python(name: str) -> str:
    """angularVelocity is angular_velocity."""
    return re.sub(r"(?<=[a-z])([A-Z])", lambda letter: "_" + letter[0].lower(), name)


class Head(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("version", c_uint32), ("realSize", c_uint32)]


def head_of(struct: Type[ctypes.Structure]) -> Head:
    return Head(ctypes.sizeof(struct), VERSION, REAL_SIZE)


class Vec2(ctypes.Structure):
    _fields_ = [("x", Real), ("y", Real)]


class Rot(ctypes.Structure):
    _fields_ = [("c", Real), ("s", Real)]


class Transform(ctypes.Structure):
    _fields_ = [("position", Vec2), ("rotation", Rot)]


class Aabb(ctypes.Structure):
    _fields_ = [("lower", Vec2), ("upper", Vec2)]


class Range(Values):
    _fields_ = [("lower", Real), ("upper", Real)]


class BodyId(ctypes.Structure):
    _fields_ = [("index", c_uint32), ("generation", c_uint32), ("world", c_uint32)]


class JointId(ctypes.Structure):
    _fields_ = [("index", c_uint32), ("generation", c_uint32), ("world", c_uint32)]


class Filter(Values):
    _fields_ = [("flags", c_uint64), ("required", c_uint64), ("group", c_int32)]


class Material(Values):
    _fields_ = [
        ("staticFriction", Real),
        ("kineticFriction", Real),
        ("restitution", Real),
        ("rollingResistance", Real),
        ("surfaceSpeed", Real),
        ("frictionRule", c_uint8),
        ("restitutionRule", c_uint8),
    ]


class Circle(Values):
    _fields_ = [("radius", Real), ("center", Vec2)]


class Box(Values):
    _fields_ = [
        ("width", Real),
        ("height", Real),
        ("center", Vec2),
        ("rotation", Rot),
        ("radius", Real),
    ]


class Polygon(Values):
    _fields_ = [("corners", POINTER(Vec2)), ("cornerCount", c_size_t), ("radius", Real)]


class Compound(Values):
    _fields_ = [("parts", c_void_p), ("partCount", c_size_t)]


class Point(Values):
    _fields_ = [("position", Vec2)]


class Segment(Values):
    _fields_ = [("from", Vec2), ("to", Vec2), ("oneSided", c_bool), ("radius", Real)]


class Plane(Values):
    _fields_ = [("normal", Vec2), ("offset", Real)]


class Heightmap(Values):
    _fields_ = [
        ("origin", Vec2),
        ("spacing", Real),
        ("heights", POINTER(Real)),
        ("heightCount", c_size_t),
    ]


class Chain(Values):
    _fields_ = [
        ("points", POINTER(Vec2)),
        ("pointCount", c_size_t),
        ("closed", c_bool),
        ("oneSided", c_bool),
        ("materials", POINTER(Material)),
        ("materialCount", c_size_t),
    ]


class Capsule(Values):
    _fields_ = [("from", Vec2), ("to", Vec2), ("radius", Real)]


class _Shapes(ctypes.Union):
    _fields_ = [
        ("circle", Circle),
        ("box", Box),
        ("polygon", Polygon),
        ("compound", Compound),
        ("point", Point),
        ("segment", Segment),
        ("plane", Plane),
        ("heightmap", Heightmap),
        ("chain", Chain),
        ("capsule", Capsule),
    ]


class Shape(Values):
    _anonymous_ = ("shapes",)
    _fields_ = [("kind", c_int32), ("shapes", _Shapes)]


class Polygons(Values):
    _fields_ = [
        ("corners", POINTER(Vec2)),
        ("cornerCapacity", c_size_t),
        ("cornerCount", c_size_t),
        ("sizes", POINTER(c_size_t)),
        ("capacity", c_size_t),
        ("count", c_size_t),
    ]


class SoftSettings(Values):
    _fields_ = [
        ("substeps", c_int32),
        ("impactPasses", c_int32),
        ("contactHertz", Real),
        ("contactDamping", Real),
        ("jointHertz", Real),
        ("jointDamping", Real),
        ("pushSpeed", Real),
        ("jointGap", Real),
    ]


class PropagationSettings(Values):
    _fields_ = [
        ("substeps", c_int32),
        ("impactPasses", c_int32),
        ("contactPasses", c_int32),
        ("shockPasses", c_int32),
        ("jointHertz", Real),
        ("jointDamping", Real),
        ("pushSpeed", Real),
    ]


class _Solvers(ctypes.Union):
    _fields_ = [("soft", SoftSettings), ("propagation", PropagationSettings)]


class Settings(Values):
    _anonymous_ = ("solvers",)
    _fields_ = [
        ("head", Head),
        ("solver", c_int32),
        ("solvers", _Solvers),
        ("sleepSteps", c_int32),
        ("leaveOut", c_uint8),
    ]


class WorldDef(Values):
    _fields_ = [("head", Head), ("gravity", Vec2), ("lengthUnit", Real), ("settings", Settings)]


class MassDef(Values):
    _fields_ = [
        ("mass", Real),
        ("hasCenter", c_bool),
        ("center", Vec2),
        ("hasInertia", c_bool),
        ("inertia", Real),
    ]


class BodyDef(Values):
    _fields_ = [
        ("head", Head),
        ("shape", Shape),
        ("position", Vec2),
        ("rotation", Rot),
        ("velocity", Vec2),
        ("angularVelocity", Real),
        ("material", Material),
        ("density", Real),
        ("hasMass", c_bool),
        ("mass", MassDef),
        ("linearDamping", Real),
        ("angularDamping", Real),
        ("gravityScale", Real),
        ("continuousMode", c_int32),
        ("type", c_int32),
        ("flags", c_uint64),
        ("required", c_uint64),
        ("group", c_int32),
        ("userData", c_uint64),
    ]


class BodyState(Values):
    _fields_ = [
        ("id", BodyId),
        ("type", c_int32),
        ("transform", Transform),
        ("massFrame", Transform),
        ("velocity", Vec2),
        ("angularVelocity", Real),
        ("mass", Real),
        ("inertia", Real),
        ("localCenter", Vec2),
        ("area", Real),
        ("bounds", Aabb),
        ("flags", c_uint64),
        ("required", c_uint64),
        ("group", c_int32),
        ("hasSetMass", c_bool),
        ("isAsleep", c_bool),
        ("userData", c_uint64),
        ("partCount", c_size_t),
        ("linearDamping", Real),
        ("angularDamping", Real),
        ("gravityScale", Real),
        ("continuousMode", c_int32),
    ]


class Part(Values):
    _fields_ = [
        ("shape", Shape),
        ("material", Material),
        ("density", Real),
        ("hasFilter", c_bool),
        ("filter", Filter),
        ("userData", c_uint64),
    ]


class Velocity(Values):
    _fields_ = [("linear", Vec2), ("angular", Real)]


class Load(Values):
    _fields_ = [("force", Vec2), ("torque", Real)]


class JointEnds(Values):
    _fields_ = [
        ("a", BodyId),
        ("b", BodyId),
        ("anchorA", Vec2),
        ("anchorB", Vec2),
        ("breakForce", Real),
        ("breakTorque", Real),
        ("collide", c_bool),
        ("userData", c_uint64),
    ]


class RevoluteJoint(Values):
    _fields_ = [
        ("ends", JointEnds),
        ("reference", Real),
        ("hasLimits", c_bool),
        ("limits", Range),
        ("motorSpeed", Real),
        ("motorTorque", Real),
        ("target", Real),
        ("hertz", Real),
        ("damping", Real),
        ("ratchet", Real),
    ]


class FixedJoint(Values):
    _fields_ = [("ends", JointEnds), ("reference", Real), ("hertz", Real), ("damping", Real)]


class DistanceJoint(Values):
    _fields_ = [
        ("ends", JointEnds),
        ("length", Real),
        ("hertz", Real),
        ("damping", Real),
        ("hasLimits", c_bool),
        ("limits", Range),
        ("motorSpeed", Real),
        ("motorForce", Real),
    ]


class PrismaticJoint(Values):
    _fields_ = [
        ("ends", JointEnds),
        ("axis", Vec2),
        ("reference", Real),
        ("hasLimits", c_bool),
        ("limits", Range),
        ("motorSpeed", Real),
        ("motorForce", Real),
        ("target", Real),
        ("hertz", Real),
        ("damping", Real),
    ]


class MotorJoint(Values):
    _fields_ = [
        ("ends", JointEnds),
        ("reference", Real),
        ("force", Real),
        ("torque", Real),
        ("hertz", Real),
        ("damping", Real),
    ]


class MouseJoint(Values):
    _fields_ = [
        ("body", BodyId),
        ("anchor", Vec2),
        ("target", Vec2),
        ("force", Real),
        ("hertz", Real),
        ("damping", Real),
        ("userData", c_uint64),
    ]


class WheelJoint(Values):
    _fields_ = [
        ("ends", JointEnds),
        ("axis", Vec2),
        ("hasLimits", c_bool),
        ("limits", Range),
        ("hertz", Real),
        ("damping", Real),
        ("motorSpeed", Real),
        ("motorTorque", Real),
    ]


class PulleyJoint(Values):
    _fields_ = [
        ("ends", JointEnds),
        ("groundA", Vec2),
        ("groundB", Vec2),
        ("length", Real),
        ("ratio", Real),
    ]


class GearJoint(Values):
    _fields_ = [("ends", JointEnds), ("ratio", Real), ("hasRack", c_bool), ("rack", Vec2)]


class FilterJoint(Values):
    _fields_ = [("ends", JointEnds)]


class _Joints(ctypes.Union):
    _fields_ = [
        ("revolute", RevoluteJoint),
        ("fixed", FixedJoint),
        ("distance", DistanceJoint),
        ("prismatic", PrismaticJoint),
        ("motor", MotorJoint),
        ("mouse", MouseJoint),
        ("wheel", WheelJoint),
        ("pulley", PulleyJoint),
        ("gear", GearJoint),
        ("filter", FilterJoint),
    ]


class JointDef(Values):
    _anonymous_ = ("joints",)
    _fields_ = [("head", Head), ("kind", c_int32), ("joints", _Joints)]


class Spring(Values):
    _fields_ = [("hertz", Real), ("damping", Real)]


class JointState(Values):
    _fields_ = [
        ("anchorA", Vec2),
        ("anchorB", Vec2),
        ("angle", Real),
        ("angularSpeed", Real),
        ("length", Real),
        ("lengthSpeed", Real),
        ("translation", Real),
        ("speed", Real),
    ]


class BrokenJoint(Values):
    _fields_ = [
        ("id", JointId),
        ("a", BodyId),
        ("b", BodyId),
        ("force", Real),
        ("torque", Real),
    ]


class Gravity(Values):
    _fields_ = [("acceleration", Vec2)]


class DragLaw(Values):
    _fields_ = [("linear", Real), ("quadratic", Real)]


class Drag(Values):
    _fields_ = [("law", DragLaw), ("air", Vec2)]


class Wind(Values):
    _fields_ = [("law", DragLaw), ("velocity", Vec2), ("hasRegion", c_bool), ("region", Aabb)]


class Attractor(Values):
    _fields_ = [("law", c_int32), ("center", Vec2), ("strength", Real), ("softening", Real)]


class Buoyancy(Values):
    _fields_ = [("density", Real), ("drag", Real), ("surface", Vec2), ("gravity", Vec2)]


class FieldBody(Values):
    _fields_ = [
        ("id", BodyId),
        ("flags", c_uint64),
        ("transform", Transform),
        ("massFrame", Transform),
        ("midStep", Transform),
        ("velocity", Vec2),
        ("angularVelocity", Real),
        ("mass", Real),
        ("inertia", Real),
        ("area", Real),
        ("userData", c_uint64),
    ]


class FieldForce(Values):
    _fields_ = [("force", Vec2), ("torque", Real), ("drag", Real), ("spinDrag", Real)]


FIELD_FUNCTION = ctypes.CFUNCTYPE(None, c_void_p, POINTER(FieldBody), Real, POINTER(FieldForce))
END_FUNCTION = ctypes.CFUNCTYPE(None, c_void_p)


class OwnField(Values):
    _fields_ = [
        ("at", FIELD_FUNCTION),
        ("destroy", END_FUNCTION),
        ("context", c_void_p),
        ("steady", c_bool),
    ]


class _Fields(ctypes.Union):
    _fields_ = [
        ("own", OwnField),
        ("gravity", Gravity),
        ("drag", Drag),
        ("wind", Wind),
        ("attractor", Attractor),
        ("buoyancy", Buoyancy),
    ]


class Field(Values):
    _anonymous_ = ("fields",)
    _fields_ = [("head", Head), ("which", Filter), ("kind", c_int32), ("fields", _Fields)]


STAGE_FUNCTION = ctypes.CFUNCTYPE(None, c_void_p, c_int32)


class StepOptions(Values):
    _fields_ = [
        ("head", Head),
        ("pool", c_void_p),
        ("enterStage", STAGE_FUNCTION),
        ("leaveStages", END_FUNCTION),
        ("context", c_void_p),
    ]


class StepStats(Values):
    _fields_ = [
        ("bodies", c_size_t),
        ("contacts", c_size_t),
        ("joints", c_size_t),
        ("mostParts", c_uint32),
        ("refinedBodies", c_size_t),
        ("pairs", c_size_t),
        ("continuousPairs", c_size_t),
        ("continuousStops", c_size_t),
        ("pairWork", c_uint64),
        ("changeVisits", c_uint64),
    ]


class RecordPoint(Values):
    _fields_ = [("position", Vec2), ("separation", Real), ("maxImpulse", Real)]


class CollisionRecord(Values):
    _fields_ = [
        ("a", BodyId),
        ("b", BodyId),
        ("partA", c_uint16),
        ("partB", c_uint16),
        ("phase", c_int32),
        ("pointCount", c_int32),
        ("points", RecordPoint * 2),
        ("point", Vec2),
        ("normal", Vec2),
        ("separation", Real),
        ("approachSpeed", Real),
        ("maxImpulse", Real),
        ("totalImpulse", Real),
        ("tangentImpulse", Real),
    ]


class Query(Values):
    _fields_ = [
        ("head", Head),
        ("which", Filter),
        ("except", POINTER(BodyId)),
        ("exceptCount", c_size_t),
    ]


class Ray(Values):
    _fields_ = [("from", Vec2), ("to", Vec2)]


class PlacedShape(Values):
    _fields_ = [("shape", POINTER(Shape)), ("at", Transform)]


class NearShape(Values):
    _fields_ = [("shape", POINTER(Shape)), ("at", Transform), ("margin", Real)]


class QueryHit(Values):
    _fields_ = [
        ("found", c_bool),
        ("body", BodyId),
        ("part", c_uint16),
        ("fraction", Real),
        ("point", Vec2),
        ("normal", Vec2),
    ]


class QueryPoint(Values):
    _fields_ = [
        ("found", c_bool),
        ("body", BodyId),
        ("part", c_uint16),
        ("point", Vec2),
        ("normal", Vec2),
        ("distance", Real),
    ]


class RaySpan(Values):
    _fields_ = [
        ("entry", QueryHit),
        ("exitFraction", Real),
        ("exitPoint", Vec2),
        ("exitNormal", Vec2),
    ]


class QueryContact(Values):
    _fields_ = [
        ("body", BodyId),
        ("part", c_uint16),
        ("point", Vec2),
        ("normal", Vec2),
        ("separation", Real),
    ]


class ClosestPoints(Values):
    _fields_ = [("onA", Vec2), ("onB", Vec2), ("normal", Vec2), ("distance", Real)]


class CastDef(Values):
    _fields_ = [
        ("head", Head),
        ("shape", Shape),
        ("start", Transform),
        ("displacement", Vec2),
        ("angle", Real),
        ("atStart", c_uint8),
    ]


class Mover(Values):
    _fields_ = [
        ("head", Head),
        ("shape", Shape),
        ("position", Vec2),
        ("up", Vec2),
        ("slopeLimit", Real),
        ("stepHeight", Real),
        ("skin", Real),
        ("pushForce", Real),
        ("weight", Real),
        ("which", Filter),
        ("body", BodyId),
        ("velocity", Vec2),
        ("grounded", c_bool),
        ("groundNormal", Vec2),
        ("groundBody", BodyId),
        ("groundPose", Transform),
        ("wallNormal", Vec2),
    ]


class Explosion(Values):
    _fields_ = [
        ("head", Head),
        ("center", Vec2),
        ("radius", Real),
        ("falloff", Real),
        ("impulse", Real),
        ("which", Filter),
    ]


class ExplosionHit(Values):
    _fields_ = [("body", BodyId), ("point", Vec2), ("impulse", Vec2), ("width", Real)]


class DrawColor(Values):
    _fields_ = [("r", c_uint8), ("g", c_uint8), ("b", c_uint8), ("a", c_uint8)]


class DrawStyle(Values):
    _fields_ = [("line", DrawColor), ("fill", DrawColor), ("width", Real)]


class DrawOptions(Values):
    _fields_ = [
        ("head", Head),
        ("shapes", c_bool),
        ("joints", c_bool),
        ("contacts", c_bool),
        ("impulses", c_bool),
        ("bounds", c_bool),
        ("velocities", c_bool),
        ("centers", c_bool),
        ("labels", c_bool),
        ("metresPerImpulse", Real),
        ("secondsOfVelocity", Real),
        ("islands", c_bool),
    ]


class DebugDraw(Values):
    _fields_ = [
        ("head", Head),
        ("context", c_void_p),
        ("view", Aabb),
        ("pixel", Real),
        ("line", c_void_p),
        ("circle", c_void_p),
        ("polygon", c_void_p),
        ("text", c_void_p),
        ("rounded", c_void_p),
        ("halfPlane", c_void_p),
        ("point", c_void_p),
        ("arrow", c_void_p),
        ("spring", c_void_p),
        ("begin", c_void_p),
        ("label", c_void_p),
    ]


class SnapshotDef(Values):
    _fields_ = [
        ("head", Head),
        ("bytes", c_void_p),
        ("byteCount", c_size_t),
        ("ownFields", POINTER(Field)),
        ("ownFieldCount", c_size_t),
    ]


Struct = TypeVar("Struct", bound=ctypes.Structure)


def initialised(struct: Type[Struct], *kind: int) -> Struct:
    """A definition with the defaults of the library, by kodo_initName()."""
    made = struct()
    kinds = [c_int32(number) for number in kind]
    call(f"kodo_init{struct.__name__}", ctypes.byref(made), head_of(struct), *kinds)
    return made
