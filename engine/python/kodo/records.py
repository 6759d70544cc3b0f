# SPDX-License-Identifier: MIT
"""What a World lists after a step, and what queries find."""
from __future__ import annotations

from typing import NamedTuple, Tuple

from . import _structs as c
from .values import BodyId, Phase, Vec2, from_body_id, from_vec2


class RecordPoint(NamedTuple):
    """One of the points at which two parts touch."""

    position: Vec2  #: m, world
    separation: float  #: m, before the solver; < 0 in overlap
    max_impulse: float  #: N s; largest normal impulse at this point in one group


class CollisionRecord(NamedTuple):
    """Contact of two parts of two bodies in one step. At Phase.END the numbers are 0."""

    a: BodyId  #: a.index < b.index
    b: BodyId
    part_a: int
    part_b: int
    phase: Phase
    points: Tuple[RecordPoint, ...]  #: 1 or 2; none at Phase.END
    point: Vec2  #: m, world; that of the largest impulse, else the deepest one
    normal: Vec2  #: unit, from a to b
    separation: float  #: m, before the solver
    approach_speed: float  #: m/s along the normal before the solver; >= 0
    max_impulse: float  #: N s; largest normal impulse of all points in one group
    total_impulse: float  #: N s; normal impulses of all points, summed over the step
    tangent_impulse: float  #: N s; friction over the step: on b along perp(normal), on a against it

    def involves(self, body: BodyId) -> bool:
        return body in (self.a, self.b)

    def other(self, body: BodyId) -> BodyId:
        return self.b if self.a == body else self.a


class QueryHit(NamedTuple):
    """Where a ray or a moving shape meets a part of a body."""

    body: BodyId
    part: int
    fraction: float  #: 0 to 1 of the ray or displacement
    point: Vec2  #: m
    normal: Vec2  #: unit, out of the body; zero for overlap at the start


class QueryPoint(NamedTuple):
    """The point of a body closest to a query point."""

    body: BodyId
    part: int
    point: Vec2  #: m; the query point itself if it is inside
    normal: Vec2  #: unit, from the body to the query point; zero inside
    distance: float  #: m; 0 inside


class RaySpan(NamedTuple):
    """The span of a ray within a part."""

    entry: QueryHit  #: as of ray_cast_all()
    exit_fraction: float  #: 0 to 1 of the ray; 1 if it ends within the part
    exit_point: Vec2  #: m
    exit_normal: Vec2  #: unit, out of the body; zero if the ray ends within the part


class QueryContact(NamedTuple):
    """Where a shape touches or nearly touches a part."""

    body: BodyId
    part: int
    point: Vec2  #: m; halfway between the surfaces
    normal: Vec2  #: unit, out of the body
    separation: float  #: m, along the normal; < 0 in overlap


class ClosestPoints(NamedTuple):
    """The closest points of two bodies."""

    on_a: Vec2  #: m
    on_b: Vec2  #: m; equal to on_a in overlap
    normal: Vec2  #: unit, from a to b; zero in overlap
    distance: float  #: m; 0 in overlap


class ExplosionHit(NamedTuple):
    """A body that an explosion pushed."""

    body: BodyId
    point: Vec2  #: m, world; the closest point that was reached
    impulse: Vec2  #: N s
    width: float  #: m, across the rays: of what was reached


class StepStats(NamedTuple):
    """Work of the last step."""

    bodies: int  #: awake bodies
    contacts: int  #: visits of contacts by the solver, summed over all passes
    joints: int  #: joints of awake bodies
    most_parts: int  #: parts of a substep, in the island that needed the most; up to 8
    refined_bodies: int  #: bodies of islands with more than one part
    pairs: int  #: pairs of parts near each other, at least one of a body that is awake
    continuous_pairs: int  #: pairs whose paths continuous collision compared
    continuous_stops: int  #: bodies that it stopped
    pair_work: int  #: pairs of nodes of bounds trees compared, all steps so far
    change_visits: int  #: bodies and parts visited by calls that concern many, so far


def from_record(record: c.CollisionRecord) -> CollisionRecord:
    points = tuple(
        RecordPoint(from_vec2(point.position), point.separation, point.maxImpulse)
        for point in record.points[: record.pointCount]
    )
    return CollisionRecord(
        from_body_id(record.a),
        from_body_id(record.b),
        record.partA,
        record.partB,
        Phase(record.phase),
        points,
        from_vec2(record.point),
        from_vec2(record.normal),
        record.separation,
        record.approachSpeed,
        record.maxImpulse,
        record.totalImpulse,
        record.tangentImpulse,
    )


def from_hit(hit: c.QueryHit) -> QueryHit:
    return QueryHit(from_body_id(hit.body), hit.part, hit.fraction, from_vec2(hit.point),
                    from_vec2(hit.normal))


def from_query_point(closest: c.QueryPoint) -> QueryPoint:
    return QueryPoint(from_body_id(closest.body), closest.part, from_vec2(closest.point),
                      from_vec2(closest.normal), closest.distance)
