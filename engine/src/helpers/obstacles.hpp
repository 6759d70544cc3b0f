// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/mover.hpp>

#include <optional>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// What a mover meets during one move. It keeps `skin` away, as far as the angle permits.
class Obstacles {
public:
    static constexpr Real kLeastClosing = Real(0.05); // cosine; less counts as along a surface

    Obstacles(const World& world, const Mover& mover);

    Vec2 at() const { return cast_.start.position; } // m
    void setAt(Vec2 at) { cast_.start.position = at; }
    /// Finds out whether anything is within `reach` (m).
    void findNear(Real reach);
    /// Leaves out one more body in the calls of advance().
    void except(BodyId id) { except_.push_back(id); }
    void exceptNoMore() { except_.pop_back(); }

    std::optional<QueryHit> cast(Vec2 way);
    /// Moves by `way` until `skin` before what is in it. `moved`: m.
    std::optional<QueryHit> advance(Vec2 way, Real& moved);
    /// All that is nearer than `margin` (m).
    std::vector<QueryContact> touches(Real margin) const;
    /// True for ground that is not too steep.
    bool isFlat(Vec2 normal) const { return dot(normal, mover_.up) >= limit_.c - Real(1e-4); }
    Real slope() const { return limit_.s / limit_.c; } // of the steepest ground
    /// The normal of the ground that a hit is on, if it is flat. A hit on a corner is on ground if
    /// the surface beside the corner is.
    std::optional<Vec2> groundOf(const QueryHit& hit) const;
    /// m, along `up`, of the lowest point of the shape in its frame.
    Real lowest() const;

private:
    const World& world_;
    const Mover& mover_;
    Rot limit_; // of slopes
    ConvexShape convex_;
    ShapeCast cast_;
    bool isAlone_ = true;
    CollisionFilter which_; // no sensors
    std::vector<BodyId> except_;
};

} // namespace KODO_PRECISION
} // namespace kodo
