// SPDX-License-Identifier: MIT
#include "collide/one_sided.hpp"

#include "collide/chain_line.hpp"
#include "collide/faces.hpp"
#include "collide/round.hpp"
#include "collide/sat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// True if the line is responsible for shapes behind it at p. Beyond a chain vertex its neighbour
/// is.
bool ownsAlong(const ConvexShape& line, Vec2 p) {
    const Vec2 along = alongOf(line);
    return (isFree(line, 0) || dot(along, p - line.vertices[0]) >= 0) &&
           (isFree(line, 1) || dot(along, p - line.vertices[1]) < 0);
}

/// Distance (m) by which the middle of a thin shape may lie behind a line that supports it.
/// Contacts are soft, so a shape without thickness would otherwise be behind at once.
Real sinkOf(const ConvexShape& other, const ContactLimits& limits) {
    return std::max(limits.sink - other.coreRadius, Real(0));
}

/// Feature nearest to the centre of a circle: the face, a vertex, the face extended along a valley,
/// or none of this line.
enum class Nearest : std::uint8_t { Face, Start, End, Ahead, Other };

/// True if a centre beyond a vertex by `beyond` (m) is in the valley of the line, within `reach`.
bool isAhead(Real beyond, Real valley, Real reach) {
    return beyond < std::min(valley, reach);
}

Nearest nearestOf(const ConvexShape& line, Vec2 center, Real reach) {
    const Vec2 along = alongOf(line);
    const Vec2 fromStart = center - line.vertices[0];
    const Vec2 fromEnd = center - line.vertices[1];
    if (dot(along, fromStart) < 0) {
        if (isFree(line, 0)) {
            return Nearest::Start;
        }
        if (isAhead(-dot(along, fromStart), line.valleyBefore, reach)) {
            return Nearest::Ahead;
        }
        // The neighbour tests the same product, so exactly one of the two lines owns the centre.
        const bool pastNeighbour = dot(line.before, fromStart) >= 0;
        const Vec2 between = perp(line.before) + line.normals[1] + (line.before - along);
        const bool bends = turnAt(line, 0) <= kFlush && dot(between, fromStart) > 0;
        return pastNeighbour && bends ? Nearest::Start : Nearest::Other;
    }
    if (dot(along, fromEnd) >= 0) {
        if (isFree(line, 1)) {
            return Nearest::End;
        }
        return isAhead(dot(along, fromEnd), line.valleyAfter, reach) ? Nearest::Ahead
                                                                     : Nearest::Other;
    }
    return Nearest::Face;
}

Manifold collideWithRound(const ConvexShape& line, const Transform& a, const ConvexShape& circle,
                          const Transform& b, const ContactLimits& limits) {
    const Vec2 center = between(a, b) * circle.vertices[0];
    const Real sink = sinkOf(circle, limits);
    const Nearest nearest = nearestOf(line, center, std::max(limits.reach, sink));
    Manifold manifold;
    if (nearest == Nearest::Other) {
        return manifold;
    }
    Vec2 normal = line.normals[1];
    Real distance = dot(normal, center - line.vertices[0]);
    const std::size_t end = nearest == Nearest::End ? 1 : 0;
    if (nearest == Nearest::Ahead && distance < -sink) {
        return manifold;
    }
    if (distance < -sink && (nearest == Nearest::Face || isFree(line, end))) {
        manifold.fromBehind = true;
        return manifold;
    }
    if (nearest == Nearest::Start || nearest == Nearest::End) {
        const Vec2 arm = center - line.vertices[end];
        distance = length(arm);
        normal = distance > 0 ? arm / distance : normal;
    }
    const Real gap = distance - circle.radius;
    if (gap > limits.margin) {
        return manifold;
    }
    manifold.normal = a.rotation * normal;
    add(manifold,
        {center - (circle.radius + gap / 2) * normal, gap, static_cast<std::uint32_t>(nearest)}, a,
        b);
    armFromOwnCenter(manifold, circle, b);
    return manifold;
}

/// How the line treats a contact whose normal is a face normal of the other shape.
enum class Verdict : std::uint8_t {
    Own,       // the line accepts that normal
    Front,     // the line uses its own normal instead
    Neighbour, // the adjacent line, if any, is responsible
    Aside,     // the shape comes from beyond a free end
};

Verdict judge(const ConvexShape& line, std::size_t end, Vec2 direction) {
    if (isFree(line, end)) {
        return ownsDirection(line, end, direction) ? Verdict::Own : Verdict::Aside;
    }
    if (turnAt(line, end) >= -kFlush) {
        return Verdict::Front;
    }
    return ownsDirection(line, end, direction) ? Verdict::Own : Verdict::Neighbour;
}

/// Contact over the convex vertex at the line's start: the nearest face with a normal that the line
/// owns.
Manifold overHilltop(Placed line, Placed other, const Transform& ba, const ContactLimits& limits) {
    const Vec2 top = ba * line.shape.vertices[0];
    FaceAxis best{0, -std::numeric_limits<Real>::infinity()};
    for (std::size_t i = 0; i < other.shape.normals.size(); ++i) {
        const Vec2 normal = other.shape.normals[i];
        const Real height = dot(normal, top - other.shape.vertices[i]);
        if (height > best.separation &&
            ownsDirection(line.shape, 0, -unrotate(ba.rotation, normal))) {
            best = {i, height};
        }
    }
    const Vec2 middle = top - other.shape.middle;
    const bool pierced = dot(other.shape.normals[best.face], middle) < -sinkOf(other.shape, limits);
    if (isFree(line.shape, 0) || pierced ||
        !(best.separation > -std::numeric_limits<Real>::infinity())) {
        return {};
    }
    return clipAgainstFaceOfB(line, other, ba, best, limits.margin, BeyondEnds::Nothing);
}

/// The other end of a face whose deepest corner is beyond the line: it may come down on the line.
/// The deeper point of the face is the vertex. The neighbour owns it, but may have no contact where
/// it is deep.
Manifold otherEnd(Placed line, Placed other, const Transform& ab, const FaceAxis& front,
                  Real margin) {
    Manifold lying = clipAgainstFace(line, other, ab, front, margin, BeyondEnds::Nothing);
    if (lying.count < 2) {
        return {};
    }
    if (lying.points[0].separation > -margin / 4) {
        lying.points[0] = lying.points[1];
        lying.count = 1;
    }
    return lying;
}

/// Contact of a rounded shape where a corner of its core and a vertex of the line are nearest;
/// empty if the vertex belongs to the neighbour. Nothing if a face decides.
std::optional<Manifold> overCorner(Placed line, Placed other, const Transform& ab,
                                   const FaceAxis& face, const ContactLimits& limits) {
    const CoreGap gap = gapOfCores(line.shape, other.shape, ab);
    const Vec2 towards = ab.rotation * other.shape.normals[face.face];
    if (!isOfCorners(gap, line, other, line.shape.normals[1], towards)) {
        return std::nullopt;
    }
    const Vec2 arm = ab * other.shape.middle - line.shape.vertices[gap.vertexA];
    if (ownsDirection(line.shape, gap.vertexA, gap.normal) &&
        dot(gap.normal, arm) >= -sinkOf(other.shape, limits)) {
        return collideCorners(line, gap.vertexA, other, gap.vertexB, limits.margin);
    }
    return isFree(line.shape, gap.vertexA) ? std::nullopt : std::optional(Manifold{});
}

Manifold collideWithFaces(const ConvexShape& line, const Transform& a, const ConvexShape& other,
                          const Transform& b, const ContactLimits& limits) {
    const Real margin = limits.margin;
    const Transform ab = between(a, b);
    const Vec2 normal = line.normals[1];
    const std::size_t support = supportVertex(other, unrotate(ab.rotation, -normal), 0);
    const FaceAxis front{1, dot(normal, ab * other.vertices[support] - line.vertices[1])};
    const Vec2 middle = ab * other.middle;
    const bool behind = dot(normal, middle - line.vertices[0]) < -sinkOf(other, limits);

    Manifold manifold;
    manifold.fromBehind = behind && ownsAlong(line, middle);
    const Transform ba = between(b, a);
    const Real reach = margin + other.radius;
    const FaceAxis face = leastPenetratingFace(other, line, ba, reach);
    if (front.separation > reach || face.separation > reach) {
        return manifold;
    }
    if (other.radius > 0 && !manifold.fromBehind) {
        if (const auto corner = overCorner({line, a}, {other, b}, ab, face, limits)) {
            return *corner;
        }
    }
    if (face.separation > front.separation + limits.preference) {
        const Vec2 direction = -(ab.rotation * other.normals[face.face]);
        const std::size_t end = endTowards(line, direction);
        const Verdict verdict = judge(line, end, direction);
        // The middle of a shape astride a steep hilltop may be behind this side of it.
        const bool astride = !manifold.fromBehind &&
                             dot(direction, middle - line.vertices[end]) >= -sinkOf(other, limits);
        if (verdict == Verdict::Own && (!behind || astride)) {
            return clipAgainstFaceOfB({line, a}, {other, b}, ba, face, margin);
        }
        if (verdict == Verdict::Neighbour) {
            // A corner that has just passed a hilltop has least overlap at its side face. The
            // contact is instead a face over the hilltop, or the corner over this line.
            manifold = overHilltop({line, a}, {other, b}, ba, limits);
            if (manifold.count > 0) {
                return manifold;
            }
            if (!ownsAlong(line, ab * other.vertices[support])) {
                return behind ? manifold : otherEnd({line, a}, {other, b}, ab, front, margin);
            }
        }
        if (verdict == Verdict::Aside && front.separation < other.radius - margin / 2) {
            manifold.fromBehind = true;
            return manifold;
        }
    }
    return behind ? manifold
                  : clipAgainstFace({line, a}, {other, b}, ab, front, margin, BeyondEnds::Nothing);
}

/// Contact of the deepest corner with a line ahead in a valley; see collideOneSided().
Manifold collideCornerAhead(const ConvexShape& line, const Transform& a, const ConvexShape& other,
                            const Transform& b, Real margin, Real reach) {
    const Transform ab = between(a, b);
    const Vec2 normal = line.normals[1];
    const Vec2 along = alongOf(line);
    const std::size_t support = supportVertex(other, unrotate(ab.rotation, -normal), 0);
    const Vec2 corner = ab * other.vertices[support];
    const Real beforeStart = -dot(along, corner - line.vertices[0]);
    const Real afterEnd = dot(along, corner - line.vertices[1]);
    const bool ahead = (beforeStart > 0 && isAhead(beforeStart, line.valleyBefore, reach)) ||
                       (afterEnd >= 0 && isAhead(afterEnd, line.valleyAfter, reach));
    const Real gap = dot(normal, corner - line.vertices[0]) - other.radius;
    Manifold manifold;
    const bool inFront = dot(normal, ab * other.middle - line.vertices[0]) >= 0;
    if (ahead && inFront && gap <= margin) {
        constexpr std::uint32_t kFirstFeature = 64; // beyond those of faces and ends
        manifold.normal = a.rotation * normal;
        add(manifold,
            {corner - (other.radius + gap / 2) * normal, gap,
             kFirstFeature + static_cast<std::uint32_t>(support)},
            a, b);
    }
    return manifold;
}

} // namespace

ConvexShape facingTo(const ConvexShape& line, Vec2 direction) {
    ConvexShape facing = line;
    facing.oneSided = true;
    if (dot(direction, line.normals[1]) < 0) {
        std::swap(facing.vertices.data()[0], facing.vertices.data()[1]);
        std::swap(facing.normals.data()[0], facing.normals.data()[1]);
        facing.before = -line.after;
        facing.after = -line.before;
        std::swap(facing.valleyBefore, facing.valleyAfter);
    }
    facing.valleyBefore *= turnAt(facing, 0) > 0 ? Real(1) : Real(0);
    facing.valleyAfter *= turnAt(facing, 1) > 0 ? Real(1) : Real(0);
    return facing;
}

bool ownsVertex(const ConvexShape& line, std::size_t end) {
    return isFree(line, end) || (end == 0 && turnAt(line, 0) < -kFlush);
}

bool ownsDirection(const ConvexShape& line, std::size_t end, Vec2 direction) {
    if (isFree(line, end)) {
        return dot(direction, line.normals[1]) > 0;
    }
    return ownsVertex(line, end) && cross(line.normals[1], direction) >= 0 &&
           cross(direction, perp(line.before)) >= 0;
}

bool missesLine(const ConvexShape& line, const PointOverLine& point, Real tolerance) {
    const Real passed = std::abs(dot(alongOf(line), point.displacement));
    const std::size_t end = endTowards(line, point.displacement);
    if (passed == 0 || isFree(line, end) || turnAt(line, end) >= -kFlush) {
        return false;
    }
    const Vec2 next = perp(end == 0 ? line.before : line.after);
    const Real way = dot(alongOf(line), line.vertices[end] - point.position);
    const Real distance = end == 0 ? -way : way;
    const Real sink = -dot(line.normals[1], point.displacement);
    // It reaches the hilltop after distance / passed steps.
    return distance > tolerance && 2 * sink > -turnAt(line, end) * passed &&
           dot(next, point.displacement) > -tolerance && point.gap > -tolerance &&
           (point.gap + tolerance) * passed > sink * distance;
}

Manifold collideOneSided(const ConvexShape& line, const Transform& a, const ConvexShape& other,
                         const Transform& b, const ContactLimits& limits) {
    if (other.isRound()) {
        return collideWithRound(line, a, other, b, limits);
    }
    Manifold manifold = collideWithFaces(line, a, other, b, limits);
    if (manifold.count == 0 && !manifold.fromBehind && limits.reach > 0) {
        manifold = collideCornerAhead(line, a, other, b, limits.margin, limits.reach);
    }
    if (other.oneSided) {
        const Vec2 middle = between(b, a) * line.middle - other.vertices[0];
        if (dot(other.normals[1], middle) < 0) {
            manifold = {};
            manifold.fromBehind = true;
        }
    }
    return manifold;
}

bool letPass(bool passing, Manifold& manifold) {
    const bool overlaps = manifold.count > 0 && manifold.points[0].separation < 0;
    if (!manifold.fromBehind && !(passing && overlaps)) {
        return false;
    }
    manifold.count = 0;
    return true;
}

} // namespace KODO_PRECISION
} // namespace kodo
