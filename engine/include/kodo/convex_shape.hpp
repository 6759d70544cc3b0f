// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shape.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// A list that stores up to kInside elements in the object itself. A longer list is on the heap as
/// a whole. References to elements are invalid after push_back().
template <typename T, std::size_t kInside>
class SmallVector {
public:
    SmallVector() = default;
    explicit SmallVector(const std::vector<T>& from) {
        for (const T& element : from) {
            push_back(element);
        }
    }

    SmallVector(const SmallVector&) = default;
    SmallVector(SmallVector&& other) noexcept
        : size_(std::exchange(other.size_, 0)),
          inside_(std::move(other.inside_)),
          outside_(std::exchange(other.outside_, {})) {}
    SmallVector& operator=(SmallVector other) noexcept {
        std::swap(size_, other.size_);
        std::swap(inside_, other.inside_);
        std::swap(outside_, other.outside_);
        return *this;
    }
    ~SmallVector() = default;

    void push_back(const T& element) {
        if (size_ == kInside && outside_.empty()) {
            outside_.assign(inside_.begin(), inside_.end());
        }
        if (size_ >= kInside) {
            outside_.push_back(element);
        } else {
            inside_[size_] = element;
        }
        ++size_;
    }

    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }
    T* data() { return size_ > kInside ? outside_.data() : inside_.data(); }
    const T* data() const { return size_ > kInside ? outside_.data() : inside_.data(); }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    const T& back() const { return data()[size_ - 1]; }

private:
    std::size_t size_ = 0;
    std::array<T, kInside> inside_{};
    std::vector<T> outside_;
};

/// Kinds of convex shapes.
enum class ConvexKind : std::uint8_t {
    Round,     // circle or particle: one vertex and a radius >= 0
    Polygonal, // box, polygon, capsule, thick segment: two vertices or more; radius > 0 if two
    Line,      // segment without thickness: two vertices
    HalfPlane, // plane: one vertex on the surface
};

/// The form in which the engine stores each primitive: a core, the hull of vertices in a local
/// frame, and all points within `radius` of it. A circle is one vertex with a radius, a capsule
/// two.
///
/// Vertices are counter-clockwise. Edge i goes from vertex i to vertex i + 1, and normals[i] is its
/// outward unit normal. A segment has two edges: normals[0] on the right and normals[1] on the left
/// of the direction from vertex 0 to vertex 1. A one-sided segment blocks on the left.
struct ConvexShape {
    static constexpr std::size_t kFew = 8; // vertices stored without the heap
    using Points = SmallVector<Vec2, kFew>;

    Points vertices;         // m
    Points normals;          // unit; none for Round, one for HalfPlane
    Real radius = 0;         // m
    Real boundingRadius = 0; // m; largest distance of a point from the origin of the frame
    Real coreRadius = 0;     // m; of a disc that fits inside, about `middle`: half the thickness
    Vec2 middle;             // m; centroid of the core
    // Of a segment linked with others of its body, see BasicSegment:
    Vec2 before; // unit; direction of the segment that ends at vertex 0; zero: none
    Vec2 after;  // unit; direction of the segment that starts at vertex 1; zero: none
    // m; one-sided: length of the neighbours beyond each vertex that bend only towards the front;
    // there no line of the chain is below this one. Two-sided: length of the neighbour.
    Real valleyBefore = 0;
    Real valleyAfter = 0;
    ConvexKind kind = ConvexKind::Round;
    bool oneSided = false;

    /// Rotation reach (m): bound of the displacement of any point for a rotation by 1 rad about the
    /// origin. A disc about the origin has none.
    Real rotationReach() const { return isRound() && vertices[0] == Vec2{} ? 0 : boundingRadius; }
    bool isRound() const { return kind == ConvexKind::Round; }
    bool isLine() const { return kind == ConvexKind::Line; }
    bool isPlane() const { return kind == ConvexKind::HalfPlane; }
};

/// The convex shape of a valid primitive, relative to `origin` (m, in the primitive's frame).
/// Bodies use their centre of mass.
KODO_API ConvexShape convexShapeOf(const Primitive& primitive, Vec2 origin);

/// The part of boundsOf() for shapes that are not round.
KODO_API Aabb boundsOfAngular(const ConvexShape& convex, const Transform& t);
/// Bounds (m, world) of a convex shape at pose t. A plane reaches from its surface to kPlaneExtent.
inline Aabb boundsOf(const ConvexShape& convex, const Transform& t) {
    if (!convex.isRound()) {
        return boundsOfAngular(convex, t);
    }
    const Vec2 center = t * convex.vertices[0];
    return Aabb{center, center}.grown(convex.radius);
}
/// Half the extent of the bounds of a plane (m).
inline constexpr Real kPlaneExtent = sizeof(Real) == 4 ? Real(1e12) : Real(1e20);

/// True if a world point (m) is inside or on the edge of a convex shape at pose t. A segment
/// contains only points exactly on it.
KODO_API bool contains(const ConvexShape& convex, const Transform& t, Vec2 point);

} // namespace KODO_PRECISION
} // namespace kodo
