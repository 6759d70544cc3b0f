// SPDX-License-Identifier: MIT
#include "collide/rising_face.hpp"

#include "collide/faces.hpp"
#include "collide/round.hpp"

#include <cmath>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Least cosine between the normals of both faces. Steeper ones are walls.
constexpr Real kLeastFacing = Real(0.05);
constexpr Real kSameDirection = Real(0.999999);   // cosine
constexpr std::uint32_t kFirstVertexFeature = 64; // of vertices; beyond those of faces and ends

/// A face that begins at a vertex.
struct Face {
    std::size_t vertex;
    std::size_t face;
    Real facing; // cosine between the normals
};

/// The face that rises from a vertex at the surface dot(normal, p) = height, if any.
std::optional<Face> risingFace(const ConvexShape& ground, Vec2 normal, Real height, Real slop) {
    const std::size_t n = ground.vertices.size();
    std::optional<Face> best;
    for (std::size_t i = 0; i < n; ++i) {
        const Real above = dot(normal, ground.vertices[i]) - height;
        if (std::abs(above) > slop) {
            continue;
        }
        for (const bool next : {true, false}) {
            const std::size_t face = next ? i : (i + n - 1) % n;
            const Vec2 end = ground.vertices[next ? (i + 1) % n : face];
            const Real facing = dot(normal, ground.normals[face]);
            if (facing > (best ? best->facing : kLeastFacing) &&
                dot(normal, end - ground.vertices[i]) > 0) {
                best = Face{i, face, facing};
            }
        }
    }
    return best;
}

/// Contact of the deepest vertex, or of a circle, with the line of a face. Body a has the face.
Manifold contactWithLine(const ConvexShape& ground, const Transform& a, const Face& face,
                         const ConvexShape& other, const Transform& b, Real margin) {
    const Transform ab = between(a, b);
    const Vec2 normal = ground.normals[face.face];
    const std::size_t support =
        other.isRound() ? 0 : supportVertex(other, unrotate(ab.rotation, -normal), 0);
    const Vec2 nearest = ab * other.vertices[support];
    const Real gap = dot(normal, nearest - ground.vertices[face.vertex]) - other.radius;
    Manifold manifold;
    if (gap > margin) {
        return manifold;
    }
    const std::size_t feature = other.isRound() ? face.face : kFirstVertexFeature + support;
    manifold.normal = a.rotation * normal;
    add(manifold,
        {nearest - (other.radius + gap / 2) * normal, gap, static_cast<std::uint32_t>(feature)}, a,
        b);
    if (other.isRound()) {
        armFromOwnCenter(manifold, other, b);
    }
    return manifold;
}

} // namespace

std::optional<Manifold> contactWithRisingFace(const ConvexShape& ground, const Transform& a,
                                              const ConvexShape& other, const Transform& b,
                                              const Manifold& found, const CarryingFace& carrying) {
    if (ground.isPlane() || ground.radius > 0 || ground.oneSided || other.isPlane()) {
        return std::nullopt;
    }
    const Vec2 normal = unrotate(a.rotation, carrying.normal);
    const Real height = dot(carrying.normal, carrying.point - a.position);
    const std::optional<Face> face = risingFace(ground, normal, height, carrying.slop);
    if (!face) {
        return std::nullopt;
    }
    constexpr Real kGentle = Real(0.9); // cosine: a steep face counts once it is near
    const Vec2 vertex = ground.vertices[face->vertex];
    const Real apart = std::abs(cross(normal, between(a, b).position - vertex)); // along the face
    if (found.count == 0 &&
        (face->facing < kGentle || apart > other.boundingRadius + carrying.way)) {
        return std::nullopt;
    }
    const Vec2 rising = ground.normals[face->face];
    if (dot(rising, unrotate(a.rotation, found.normal)) > kSameDirection ||
        dot(rising, between(a, b) * other.middle - vertex) < 0) {
        return std::nullopt;
    }
    const Real near = carrying.margin + carrying.slop;
    for (int i = 0; i < found.count; ++i) {
        const Vec2 arm = found.points[static_cast<std::size_t>(i)].armA;
        if (lengthSquared(unrotate(a.rotation, arm) - vertex) > near * near) {
            return std::nullopt;
        }
    }
    return contactWithLine(ground, a, *face, other, b, carrying.margin);
}

} // namespace KODO_PRECISION
} // namespace kodo
