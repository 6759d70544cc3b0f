// SPDX-License-Identifier: MIT
#include "propagation/prediction.hpp"

#include <kodo/geometry.hpp>

#include "bodies/continuous_mode.hpp"
#include "collide/one_sided.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <cmath>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Displacement of a body since the start of the step.
struct Place {
    Vec2 deltaPosition;
    Real deltaAngle = 0;
};

/// Displacement after a further time h (s), or now with 0, if nothing stops the body.
Place ahead(const Bodies& bodies, std::uint32_t body, Real h) {
    const BodyVelocity& motion = bodies.motion[body];
    if (!bodies.active(body)) {
        return {};
    }
    const Acceleration& a = bodies.acceleration[body];
    return {motion.deltaPosition + h * (motion.velocity + h * a.linear),
            motion.deltaAngle + h * (motion.angularVelocity + h * a.angular)};
}

Transform placed(const Transform& pose, const Place& by) {
    return {pose.position + by.deltaPosition,
            by.deltaAngle == 0 ? pose.rotation : turned(pose.rotation, by.deltaAngle)};
}

/// Decrease (m) of the separation of a point by displacements of the bodies.
Real approach(const Contact& contact, std::size_t i, const Place& a, const Place& b) {
    const ManifoldPoint& p = contact.manifold.points[i];
    const Vec2 n = contact.manifold.normal;
    return dot(n, a.deltaPosition - b.deltaPosition) + cross(p.armA, n) * a.deltaAngle -
           cross(p.armB, n) * b.deltaAngle;
}

Place difference(const Place& later, const Place& earlier) {
    return {later.deltaPosition - earlier.deltaPosition, later.deltaAngle - earlier.deltaAngle};
}

/// One contact and the predicted motion of its bodies.
class Way {
public:
    Way(Contact& contact, const ContactLane& lane, const Bodies& bodies,
        const Prediction& prediction)
        : bodies_(bodies),
          contact_(contact),
          lane_(lane),
          prediction_(prediction),
          hereA_(ahead(bodies, contact.key.bodyA, 0)),
          hereB_(ahead(bodies, contact.key.bodyB, 0)),
          thereA_(ahead(bodies, contact.key.bodyA, prediction.h)),
          thereB_(ahead(bodies, contact.key.bodyB, prediction.h)) {}

    /// Bound (m) of the motion of any point of one body towards the other.
    Real motion() const {
        const Place a = difference(thereA_, hereA_);
        const Place b = difference(thereB_, hereB_);
        return length(a.deltaPosition) + length(b.deltaPosition) +
               std::abs(a.deltaAngle) * convexA().boundingRadius +
               std::abs(b.deltaAngle) * convexB().boundingRadius;
    }
    /// True if a body may tunnel, or overlap deeply, before a contact exists.
    bool outruns() const {
        return motion() > std::min(convexA().coreRadius, convexB().coreRadius) / 2;
    }
    /// True if the bodies, without a touch in the last step, have moved so far since the start of
    /// the step that they may have passed each other. Continuous collision then stops them.
    bool outran() const {
        return !contact_.wasTouching &&
               length(hereB_.deltaPosition - hereA_.deltaPosition) >
                   std::min(convexA().coreRadius, convexB().coreRadius) / 2;
    }
    /// True if the forces of the step part the bodies. Joints may then hold them where they are.
    bool leaves() const {
        const int count = contact_.manifold.count;
        return count > 0 && std::max(closing(0), closing(count > 1 ? 1 : 0)) < 0;
    }
    /// Removes the manifold.
    void clear() {
        lane_.updateSeparations(contact_.manifold);
        contact_.manifold.count = 0;
        contact_.passing = false;
    }
    /// A segment has no interior, so the side of a body is known only at its current pose.
    bool ofLine() const { return convexA().isLine() || convexB().isLine(); }

    void findHere() { find(hereA_, hereB_); }
    void findThere() { find(thereA_, thereB_); }

    /// After findThere(): true if the shapes overlap along an axis on which their extents overlap
    /// here as well: on a ledge that is narrower than the overlap is deep.
    bool entersAside() const {
        return contact_.manifold.count > 0 &&
               lane_.separation(0) + std::max(closing(0), Real(0)) < -prediction_.tolerances.slop;
    }

    /// Decrease (m) of the separation of point i by the motion.
    Real closing(std::size_t i) const {
        return approach(contact_, i, difference(thereA_, hereA_), difference(thereB_, hereB_));
    }

private:
    const ConvexShape& convexA() const {
        return bodies_.convex(contact_.key.bodyA, contact_.key.partA);
    }
    const ConvexShape& convexB() const {
        return bodies_.convex(contact_.key.bodyB, contact_.key.partB);
    }
    void find(const Place& atA, const Place& atB) {
        const Real margin = prediction_.tolerances.margin;
        const Real slop = prediction_.tolerances.slop;
        const Transform a = placed(bodies_.pose[contact_.key.bodyA], atA);
        const Transform b = placed(bodies_.pose[contact_.key.bodyB], atB);
        const Real reach = convexA().boundingRadius + convexB().boundingRadius + margin;
        if (lengthSquared(b.position - a.position) > reach * reach) {
            clear();
            return;
        }
        contact_.near = true;
        contact_.centerA = a.position;
        contact_.manifold = collide(convexA(), a, convexB(), b, margin, slop / 8);
        if (removePassing(contact_.manifold, contact_, bodies_, {a, b}, slop, prediction_.h)) {
            lane_.expire();
        }
        contact_.passing = letPass(contact_.passing, contact_.manifold);
        lane_.setSeparations(contact_.manifold);
    }

    const Bodies& bodies_;
    Contact& contact_;
    const ContactLane& lane_;
    const Prediction& prediction_;
    Place hereA_;
    Place hereB_;
    Place thereA_;
    Place thereB_;
};

} // namespace

std::array<Real, 2> predictContact(Contact& contact, const ContactLane& lane, const Bodies& bodies,
                                   const Prediction& prediction) {
    Way way(contact, lane, bodies, prediction);
    const bool hardlyMoves = way.motion() <= prediction.tolerances.margin / 2 || way.leaves();
    const bool swept = prediction.swept && areChecked(bodies, contact.key.bodyA, contact.key.bodyB);
    bool outruns = way.ofLine() || (swept && way.outruns());
    if (swept && !prediction.fresh && outruns && way.outran()) {
        way.clear();
    } else if (!hardlyMoves && !outruns) {
        way.findThere();
        const bool locked = bodies.locked(contact.key.bodyA) || bodies.locked(contact.key.bodyB);
        if (locked && way.entersAside()) {
            way.findHere();
            outruns = true;
        }
    } else if (!prediction.fresh) {
        way.findHere();
    }
    const BodyVelocity& motionA = bodies.motion[contact.key.bodyA];
    const BodyVelocity& motionB = bodies.motion[contact.key.bodyB];
    std::array<Real, 2> gaps{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
        const ManifoldPoint& p = contact.manifold.points[i];
        const Vec2 velocity = velocityAt(motionB, p.armB) - velocityAt(motionA, p.armA);
        lane.approachSpeed() =
            std::max(lane.approachSpeed(), -dot(contact.manifold.normal, velocity));
        Real& separation = lane.separation(i);
        gaps[i] = separation;
        if (outruns) {
            continue;
        }
        if (hardlyMoves) {
            separation -= way.closing(i);
        } else {
            // A separating pair may have passed a corner: the normal is then invalid for the
            // current poses.
            gaps[i] += std::max(way.closing(i), Real(0));
        }
    }
    return gaps;
}

} // namespace KODO_PRECISION
} // namespace kodo
