// SPDX-License-Identifier: MIT
#include <kodo/collide/collide.hpp>
#include <kodo/collide/one_sided.hpp>
#include <kodo/solve/prediction.hpp>

#include <algorithm>
#include <cmath>

namespace kodo::inline KODO_PRECISION {
namespace {

/// Of a body, relative to where the step began.
struct Place {
    Vec2 move;
    Real turn = 0;
};

/// Where a body will be after h, relative to the start of the step, if nothing stops it.
Place ahead(const Bodies& bodies, std::uint32_t body, Real h) {
    const Motion& motion = bodies.motion[body];
    if (!bodies.active(body)) {
        return {};
    }
    const Acceleration& a = bodies.acceleration[body];
    return {motion.move + h * (motion.velocity + h * a.linear),
            motion.turn + h * (motion.angularVelocity + h * a.angular)};
}

Place now(const Bodies& bodies, std::uint32_t body) {
    if (!bodies.active(body)) {
        return {};
    }
    return {bodies.motion[body].move, bodies.motion[body].turn};
}

Transform placed(const Transform& pose, const Place& by) {
    return {pose.position + by.move, by.turn == 0 ? pose.rotation : turned(pose.rotation, by.turn)};
}

/// How much nearer the bodies come at a point when they move from one place to the other.
Real approach(const Contact& contact, std::size_t i, const Place& a, const Place& b) {
    const ManifoldPoint& p = contact.manifold.points[i];
    const Vec2 n = contact.manifold.normal;
    return dot(n, a.move - b.move) + cross(p.armA, n) * a.turn - cross(p.armB, n) * b.turn;
}

Place difference(const Place& later, const Place& earlier) {
    return {later.move - earlier.move, later.turn - earlier.turn};
}

/// One contact of two bodies on the way from here to there.
class Way {
public:
    Way(Contact& contact, const Bodies& bodies, const Prediction& prediction)
        : bodies_(bodies),
          contact_(contact),
          tolerances_(prediction.tolerances),
          hereA_(now(bodies, contact.key.bodyA)),
          hereB_(now(bodies, contact.key.bodyB)),
          thereA_(ahead(bodies, contact.key.bodyA, prediction.h)),
          thereB_(ahead(bodies, contact.key.bodyB, prediction.h)) {}

    /// No point of one moves farther than that towards the other.
    Real motion() const {
        const Place a = difference(thereA_, hereA_);
        const Place b = difference(thereB_, hereB_);
        return length(a.move) + length(b.move) + std::abs(a.turn) * outlineA().reach +
               std::abs(b.turn) * outlineB().reach;
    }
    /// So fast that it could be past the other, or well inside, before it is noticed.
    bool outruns() const { return motion() > std::min(outlineA().inside, outlineB().inside) / 2; }
    /// A line has no inside, so which side of it a body is on can be seen only where it is now.
    bool ofLine() const { return outlineA().isLine() || outlineB().isLine(); }

    void findHere() { find(hereA_, hereB_); }
    void findThere() { find(thereA_, thereB_); }

    /// How much the separation of point i shrinks on the way.
    Real closing(std::size_t i) const {
        return approach(contact_, i, difference(thereA_, hereA_), difference(thereB_, hereB_));
    }

private:
    const Convex& outlineA() const {
        return bodies_.outline(contact_.key.bodyA, contact_.key.partA);
    }
    const Convex& outlineB() const {
        return bodies_.outline(contact_.key.bodyB, contact_.key.partB);
    }
    void find(const Place& atA, const Place& atB) {
        const Transform a = placed(bodies_.pose[contact_.key.bodyA], atA);
        const Transform b = placed(bodies_.pose[contact_.key.bodyB], atB);
        const Real reach = outlineA().reach + outlineB().reach + tolerances_.margin;
        if (lengthSquared(b.position - a.position) > reach * reach) {
            contact_.manifold.count = 0;
            contact_.passing = false;
            return;
        }
        contact_.near = true;
        contact_.centerA = a.position;
        contact_.manifold =
            collide(outlineA(), a, outlineB(), b, tolerances_.margin, tolerances_.slop / 8);
        contact_.passing = letPass(contact_.passing, contact_.manifold);
    }

    const Bodies& bodies_;
    Contact& contact_;
    const Tolerances& tolerances_;
    Place hereA_;
    Place hereB_;
    Place thereA_;
    Place thereB_;
};

} // namespace

std::array<Real, 2> predictContact(Contact& contact, const Bodies& bodies,
                                   const Prediction& prediction) {
    Way way(contact, bodies, prediction);
    const bool hardlyMoves = way.motion() <= prediction.tolerances.margin / 2;
    const bool outruns = way.ofLine() || (prediction.swept && way.outruns());
    if (!hardlyMoves && !outruns) {
        way.findThere();
    } else if (!prediction.fresh) {
        way.findHere();
    }
    const Motion& motionA = bodies.motion[contact.key.bodyA];
    const Motion& motionB = bodies.motion[contact.key.bodyB];
    std::array<Real, 2> gaps{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
        const ManifoldPoint& p = contact.manifold.points[i];
        const Vec2 velocity = velocityAt(motionB, p.armB) - velocityAt(motionA, p.armA);
        contact.approachSpeed =
            std::max(contact.approachSpeed, -dot(contact.manifold.normal, velocity));
        Real& separation = contact.manifold.points[i].separation;
        gaps[i] = separation;
        if (outruns) {
            continue;
        }
        if (hardlyMoves) {
            separation -= way.closing(i);
        } else {
            // What moves apart may have come round a corner: backwards, this normal says nothing.
            gaps[i] += std::max(way.closing(i), Real(0));
        }
    }
    return gaps;
}

} // namespace kodo::inline KODO_PRECISION
