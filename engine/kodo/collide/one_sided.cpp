// SPDX-License-Identifier: MIT
#include <kodo/collide/faces.hpp>
#include <kodo/collide/one_sided.hpp>
#include <kodo/collide/round.hpp>
#include <kodo/collide/sat.hpp>

#include <algorithm>
#include <limits>

namespace kodo::inline KODO_PRECISION {
namespace {

// Sine of the angle up to which a joint counts as flush. A normal may be wrong by that much there.
constexpr Real kFlush = Real(1e-3);

Vec2 alongOf(const Convex& line) {
    return -perp(line.normals[1]);
}

/// Sine of the turn at a joint, counter-clockwise positive: < 0 at a hilltop, > 0 in a valley.
Real turnAt(const Convex& line, std::size_t end) {
    return end == 0 ? cross(line.before, alongOf(line)) : cross(alongOf(line), line.after);
}

bool isFree(const Convex& line, std::size_t end) {
    return (end == 0 ? line.before : line.after) == Vec2{};
}

/// Does the line deal with what lies behind it there? Beyond a joint its neighbour does.
bool ownsAlong(const Convex& line, Vec2 p) {
    const Vec2 along = alongOf(line);
    return (isFree(line, 0) || dot(along, p - line.vertices[0]) >= 0) &&
           (isFree(line, 1) || dot(along, p - line.vertices[1]) < 0);
}

/// How far behind a line the middle of something thin may be that lies on it (m). Contacts give way
/// a little, and what has no thickness would be behind at once.
Real sinkOf(const Convex& other, Real margin) {
    return std::max(margin / 4 - other.inside, Real(0));
}

/// What is nearest to the centre of a circle: the face, a vertex, or nothing of this line's.
enum class Nearest : std::uint8_t { Face, Start, End, Other };

Nearest nearestOf(const Convex& line, Vec2 center) {
    const Vec2 along = alongOf(line);
    const Vec2 fromStart = center - line.vertices[0];
    const Vec2 fromEnd = center - line.vertices[1];
    if (dot(along, fromStart) < 0) {
        if (isFree(line, 0)) {
            return Nearest::Start;
        }
        // The neighbour owns what it has not passed yet: the same product, so the same answer.
        const bool pastNeighbour = dot(line.before, fromStart) >= 0;
        const Vec2 between = perp(line.before) + line.normals[1];
        const bool bends = turnAt(line, 0) <= kFlush && dot(between, fromStart) > 0;
        return pastNeighbour && bends ? Nearest::Start : Nearest::Other;
    }
    if (dot(along, fromEnd) >= 0) {
        return isFree(line, 1) ? Nearest::End : Nearest::Other;
    }
    return Nearest::Face;
}

Manifold collideWithRound(const Convex& line, const Transform& a, const Convex& circle,
                          const Transform& b, Real margin) {
    const Vec2 center = between(a, b) * circle.vertices[0];
    const Nearest nearest = nearestOf(line, center);
    Manifold manifold;
    if (nearest == Nearest::Other) {
        return manifold;
    }
    Vec2 normal = line.normals[1];
    Real distance = dot(normal, center - line.vertices[0]);
    const std::size_t end = nearest == Nearest::End ? 1 : 0;
    if (distance < -sinkOf(circle, margin) && (nearest == Nearest::Face || isFree(line, end))) {
        manifold.fromBehind = true;
        return manifold;
    }
    if (nearest != Nearest::Face) {
        const Vec2 arm = center - line.vertices[end];
        distance = length(arm);
        normal = distance > 0 ? arm / distance : normal;
    }
    const Real gap = distance - circle.radius;
    if (gap > margin) {
        return manifold;
    }
    manifold.normal = a.rotation * normal;
    add(manifold,
        {center - (circle.radius + gap / 2) * normal, gap, static_cast<std::uint32_t>(nearest)}, a,
        b);
    armFromOwnCenter(manifold, circle, b);
    return manifold;
}

/// What becomes of a contact that a face of the other outline would carry, pushing it along a
/// direction of its own.
enum class Verdict : std::uint8_t {
    Own,       // the line may push along it
    Front,     // the line pushes along its normal instead
    Neighbour, // the line beyond the joint pushes, if any
    Aside,     // it comes from beyond a free end
};

std::size_t endTowards(const Convex& line, Vec2 direction) {
    return dot(direction, alongOf(line)) < 0 ? 0 : 1;
}

Verdict judge(const Convex& line, std::size_t end, Vec2 direction) {
    if (isFree(line, end)) {
        return ownsDirection(line, end, direction) ? Verdict::Own : Verdict::Aside;
    }
    if (turnAt(line, end) >= -kFlush) {
        return Verdict::Front;
    }
    return ownsDirection(line, end, direction) ? Verdict::Own : Verdict::Neighbour;
}

/// The face over the hilltop at the line's start that is the nearest of those whose directions the
/// line owns.
Manifold overHilltop(Placed line, Placed other, const Transform& ba, Real margin) {
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
    if (isFree(line.shape, 0) || dot(other.shape.normals[best.face], middle) < 0 ||
        !(best.separation > -std::numeric_limits<Real>::infinity())) {
        return {};
    }
    return clipAgainstFaceOfB(line, other, ba, best, margin, BeyondEnds::Nothing);
}

Manifold collideWithFaces(const Convex& line, const Transform& a, const Convex& other,
                          const Transform& b, Real margin, Real preference) {
    const Transform ab = between(a, b);
    const Vec2 normal = line.normals[1];
    const std::size_t support = supportVertex(other, unrotate(ab.rotation, -normal), 0);
    const FaceAxis front{1, dot(normal, ab * other.vertices[support] - line.vertices[1])};
    const Vec2 middle = ab * other.middle;
    const bool behind = dot(normal, middle - line.vertices[0]) < -sinkOf(other, margin);

    Manifold manifold;
    manifold.fromBehind = behind && ownsAlong(line, middle);
    const Transform ba = between(b, a);
    const FaceAxis face = leastPenetratingFace(other, line, ba, margin);
    if (front.separation > margin || face.separation > margin) {
        return manifold;
    }
    if (face.separation > front.separation + preference) {
        const Vec2 direction = -(ab.rotation * other.normals[face.face]);
        const std::size_t end = endTowards(line, direction);
        const Verdict verdict = judge(line, end, direction);
        // What sits astride a steep hilltop may have its middle behind this side of it.
        const bool astride =
            !manifold.fromBehind && dot(direction, middle - line.vertices[end]) >= 0;
        if (verdict == Verdict::Own && (!behind || astride)) {
            return clipAgainstFaceOfB({line, a}, {other, b}, ba, face, margin);
        }
        if (verdict == Verdict::Neighbour) {
            // A corner that has only just passed a hilltop would leave soonest by its side. But the
            // hilltop is under a face of it, or the corner over this line now.
            manifold = overHilltop({line, a}, {other, b}, ba, margin);
            if (manifold.count > 0 || !ownsAlong(line, ab * other.vertices[support])) {
                return manifold;
            }
        }
        if (verdict == Verdict::Aside && front.separation < -margin / 2) {
            manifold.fromBehind = true;
            return manifold;
        }
    }
    return behind ? manifold
                  : clipAgainstFace({line, a}, {other, b}, ab, front, margin, BeyondEnds::Nothing);
}

} // namespace

bool ownsVertex(const Convex& line, std::size_t end) {
    return isFree(line, end) || (end == 0 && turnAt(line, 0) < -kFlush);
}

bool ownsDirection(const Convex& line, std::size_t end, Vec2 direction) {
    if (isFree(line, end)) {
        return dot(direction, line.normals[1]) > 0;
    }
    return ownsVertex(line, end) && cross(line.normals[1], direction) >= 0 &&
           cross(direction, perp(line.before)) >= 0;
}

Manifold collideOneSided(const Convex& line, const Transform& a, const Convex& other,
                         const Transform& b, Real margin, Real preference) {
    if (other.isRound()) {
        return collideWithRound(line, a, other, b, margin);
    }
    Manifold manifold = collideWithFaces(line, a, other, b, margin, preference);
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

} // namespace kodo::inline KODO_PRECISION
