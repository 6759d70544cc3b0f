# SPDX-License-Identifier: MIT
"""Polygons from points (m)."""
from __future__ import annotations

import ctypes
from ctypes import byref, c_size_t
from typing import Sequence

from . import _structs as c
from ._library import call
from .shapes import Compound, Polygon
from .values import Vec2, from_vec2, to_array, to_vec2


def convex_hull(points: Sequence[Vec2]) -> Polygon:
    """The smallest convex polygon around points in any order."""
    given = to_array(c.Vec2, [to_vec2(point) for point in points])
    corners, count = (c.Vec2 * max(len(given), 1))(), c_size_t()
    call("kodo_convexHull", given, c_size_t(len(given)), corners, c_size_t(len(corners)),
         byref(count))
    return Polygon(tuple(from_vec2(corner) for corner in corners[: count.value]))


def decompose(outline: Sequence[Vec2]) -> Compound:
    """A concave outline, in either direction, as convex polygons of one body."""
    given = to_array(c.Vec2, [to_vec2(point) for point in outline])
    made = c.Polygons()
    call("kodo_decompose", given, c_size_t(len(given)), byref(made))  # counts alone
    corners, sizes = (c.Vec2 * made.cornerCount)(), (c_size_t * made.count)()
    made.corners, made.cornerCapacity = corners, len(corners)
    made.sizes, made.capacity = ctypes.cast(sizes, ctypes.POINTER(c_size_t)), len(sizes)
    call("kodo_decompose", given, c_size_t(len(given)), byref(made))
    parts, first = [], 0
    for size in sizes:
        parts.append(Polygon(tuple(from_vec2(each) for each in corners[first : first + size])))
        first += size
    return Compound(parts)
