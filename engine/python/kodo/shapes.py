# SPDX-License-Identifier: MIT
"""Shapes of bodies, in the frame of the body (m)."""
from __future__ import annotations

import ctypes
import dataclasses
from typing import List, Optional, Sequence, Tuple, Union

from . import _structs as c
from ._library import Real, library
from .values import Filter, Material, Vec2, from_vec2, to_array, to_material, to_rot, to_vec2


@dataclasses.dataclass(frozen=True)
class Circle:
    """A solid disc."""

    radius: float = 0.5  #: m, > 0
    center: Vec2 = (0.0, 0.0)  #: m


@dataclasses.dataclass(frozen=True)
class Box:
    """A solid rectangle with its full width and height."""

    width: float  #: m, > 0, without the radius
    height: float  #: m, > 0, without the radius
    center: Vec2 = (0.0, 0.0)  #: m
    angle: float = 0.0  #: rad, of the width axis
    radius: float = 0.0  #: m, >= 0, around the rectangle


@dataclasses.dataclass(frozen=True)
class Polygon:
    """A solid, strictly convex polygon."""

    corners: Sequence[Vec2]  #: m, counter-clockwise, 3 to 1024
    radius: float = 0.0  #: m, >= 0, around the outline


@dataclasses.dataclass(frozen=True)
class Point:
    """A particle. The number given as density is its mass (kg)."""

    position: Vec2 = (0.0, 0.0)  #: m


@dataclasses.dataclass(frozen=True)
class Segment:
    """A line; its density is a mass per length (kg/m), with a radius per area."""

    start: Vec2  #: m
    end: Vec2  #: m
    one_sided: bool = False  #: collides with what comes from the left of start -> end
    radius: float = 0.0  #: m, >= 0; two-sided only


@dataclasses.dataclass(frozen=True)
class Plane:
    """A half-plane, for static and kinematic bodies."""

    normal: Vec2 = (0.0, 1.0)  #: unit, out of the solid side
    offset: float = 0.0  #: m, from the origin to the surface, along the normal


@dataclasses.dataclass(frozen=True)
class Capsule:
    """A solid disc that is drawn along a line."""

    start: Vec2  #: m, centre of one end
    end: Vec2  #: m, centre of the other
    radius: float  #: m, > 0


@dataclasses.dataclass(frozen=True)
class Compound:
    """Several primitives as one rigid body."""

    parts: Sequence[Primitive]


@dataclasses.dataclass(frozen=True)
class Heightmap:
    """One-sided ground between the points origin + (i spacing, heights[i]); not for dynamic
    bodies."""

    spacing: float  #: m, > 0
    heights: Sequence[float]  #: m, 2 to 65536
    origin: Vec2 = (0.0, 0.0)  #: m


@dataclasses.dataclass(frozen=True)
class Chain:
    """Linked segments from each point to the next."""

    points: Sequence[Vec2]  #: m
    closed: bool = False
    one_sided: bool = False  #: front: left of the points, or outside if closed
    materials: Sequence[Material] = ()  #: of each segment; empty: that of the body


Primitive = Union[Circle, Box, Polygon, Point, Segment, Plane, Capsule]
Shape = Union[Primitive, Compound, Heightmap, Chain]


class BuiltShape:
    """A shape in C, with the memory that it points to."""

    def __init__(self, shape: Shape) -> None:
        self.kept: List[object] = []
        self.struct = self._build(shape)

    def _vectors(self, points: Sequence[Vec2]) -> ctypes.Array[c.Vec2]:
        made = to_array(c.Vec2, [to_vec2(point) for point in points])
        self.kept.append(made)
        return made

    def _build(self, shape: Shape) -> c.Shape:
        made = c.Shape()
        if isinstance(shape, Circle):
            made.kind, made.circle = 0, c.Circle(shape.radius, to_vec2(shape.center))
        elif isinstance(shape, Box):
            made.kind = 1
            made.box = c.Box(shape.width, shape.height, to_vec2(shape.center),
                             to_rot(shape.angle), shape.radius)
        elif isinstance(shape, Polygon):
            made.kind = 2
            made.polygon = c.Polygon(self._vectors(shape.corners), len(shape.corners), shape.radius)
        elif isinstance(shape, Point):
            made.kind, made.point = 4, c.Point(to_vec2(shape.position))
        elif isinstance(shape, Segment):
            made.kind = 5
            made.segment = c.Segment(to_vec2(shape.start), to_vec2(shape.end), shape.one_sided,
                                     shape.radius)
        elif isinstance(shape, Plane):
            made.kind, made.plane = 6, c.Plane(to_vec2(shape.normal), shape.offset)
        elif isinstance(shape, Capsule):
            made.kind = 9
            made.capsule = c.Capsule(to_vec2(shape.start), to_vec2(shape.end), shape.radius)
        else:
            self._build_list(shape, made)
        return made

    def _build_list(self, shape: Union[Compound, Heightmap, Chain], made: c.Shape) -> None:
        if isinstance(shape, Compound):
            parts = to_array(c.Shape, [self._build(part) for part in shape.parts])
            self.kept.append(parts)
            made.kind = 3
            made.compound = c.Compound(ctypes.cast(parts, ctypes.c_void_p), len(parts))
        elif isinstance(shape, Heightmap):
            heights = (Real * len(shape.heights))(*shape.heights)
            self.kept.append(heights)
            made.kind = 7
            made.heightmap = c.Heightmap(to_vec2(shape.origin), shape.spacing, heights,
                                         len(heights))
        elif isinstance(shape, Chain):
            materials = to_array(c.Material, [to_material(each) for each in shape.materials])
            self.kept.append(materials)
            made.kind = 8
            made.chain = c.Chain(self._vectors(shape.points), len(shape.points), shape.closed,
                                 shape.one_sided, materials, len(materials))
        else:
            hint = ": add_joint() takes joints" if type(shape).__name__.endswith("Joint") else ""
            raise TypeError(f"{shape!r} is no shape{hint}")


def from_shape(shape: c.Shape, corners: Sequence[Vec2]) -> Primitive:
    """The primitive of a part. Polygons take the corners that were read beside it."""
    if shape.kind == 0:
        return Circle(shape.circle.radius, from_vec2(shape.circle.center))
    if shape.kind == 1:
        box = shape.box
        angle = library.kodo_angle(box.rotation)
        return Box(box.width, box.height, from_vec2(box.center), angle, box.radius)
    if shape.kind == 2:
        return Polygon(tuple(corners), shape.polygon.radius)
    if shape.kind == 4:
        return Point(from_vec2(shape.point.position))
    if shape.kind == 5:
        line = shape.segment
        return Segment(from_vec2(getattr(line, "from")), from_vec2(line.to), line.oneSided,
                       line.radius)
    if shape.kind == 6:
        return Plane(from_vec2(shape.plane.normal), shape.plane.offset)
    capsule = shape.capsule
    return Capsule(from_vec2(getattr(capsule, "from")), from_vec2(capsule.to), capsule.radius)


@dataclasses.dataclass(frozen=True)
class Part:
    """One convex part of a body."""

    shape: Primitive  #: in the frame of the body's shape
    material: Material = Material()
    density: float = 1.0  #: kg/m^2
    filter: Optional[Filter] = None  #: instead of the filter and the SENSOR of the body
    user_data: int = 0  #: 0 to 2^64 - 1; the engine never reads it


@dataclasses.dataclass(frozen=True)
class MassDef:
    """A mass that is set, instead of that of shape and density."""

    mass: float  #: kg
    center: Optional[Vec2] = None  #: m, in the frame of the shape; None: that of the shapes
    inertia: Optional[float] = None  #: kg m^2, about the centre of mass


def to_mass(mass: MassDef) -> c.MassDef:
    center: Tuple[float, float] = mass.center or (0.0, 0.0)
    return c.MassDef(mass.mass, mass.center is not None, to_vec2(center),
                     mass.inertia is not None, mass.inertia or 0.0)
