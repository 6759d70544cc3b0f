// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include "bodies/bodies.hpp"

#include <algorithm>
#include <array>

#include "lanes/contact_lane.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Sets the fields that follow from the key and the definitions of both bodies.
void describeContact(Contact& contact, const Bodies& bodies);
/// The same for a contact that was read. Throws BadSnapshot if its bodies or parts do not exist.
void completeContact(Contact& contact, const Bodies& bodies);

/// Begins a step of dt (s) for two parts near each other with the manifold of the last step;
/// BodyVelocity still holds the displacements of that step. False if the manifold is outdated and
/// must be found again. If it is kept, the approach speed is measured too, with the same levers.
/// `inPasses`: both was done by ContactBlocks::advance.
bool followContact(Contact& contact, const ContactLane& lane, const Bodies& bodies,
                   const Tolerances& tolerances, Real dt, bool inPasses);

/// False if a body was teleported: the relative displacement is then meaningless.
bool isKnown(const Bodies& bodies, const Contact& contact);

/// Slops of relative displacement up to which a manifold is kept. With restitution it is small:
/// impact impulses that act on two parallel lines would form a couple and rotate both bodies.
constexpr Real kKeptWay = 8;
constexpr Real kKeptExactly = Real(1) / 8;

/// True if a manifold must be found again after this relative displacement (m) of the bodies.
/// `exact`: they bounce, or arrive in this step.
inline bool isOutdated(Real relativeDisplacement, bool exact, const Tolerances& tolerances) {
    return relativeDisplacement > (exact ? kKeptExactly : kKeptWay) * tolerances.slop;
}

/// Finds the manifold for a step of dt (s); new points take over the impulses of old ones.
void findContact(Contact& contact, const ContactLane& lane, const Bodies& bodies,
                 const Tolerances& tolerances, Real dt);

/// True if the manifold of a contact may get a further point. That with a disc has one.
bool mayGainPoint(const Bodies& bodies, const Contact& contact);

/// Removes the points of a manifold that move over a hilltop of a one-sided or jointed line before
/// they touch it, in a step of dt (s). With them, the straight extension of the line would lift a
/// shape whose last corner leaves a ramp. All points of sensors and round shapes are kept: the
/// next contact of a disc is the vertex. Likewise those of two parts thinner than the slop: without
/// its contact, such a part could pass the next line within the step.
void removePassingPoints(Manifold& manifold, const Contact& contact, const Bodies& bodies,
                         const Tolerances& tolerances, Real dt);

/// Steps within which a row may act: the relax pass looks one substep beyond the step.
constexpr Real kActs = Real(1.5);

/// True for parts that are apart (m) and at this speed (m/s) touch while a row acts in a step of dt
/// (s), or are within the slop, as far as their manifold tells. It predicts along its tangent, so
/// it must be new then.
inline bool arrives(Real separation, Real approachSpeed, Real slop, Real dt) {
    constexpr Real kLeastWay = Real(1) / 256; // slops
    const Real way = kActs * dt * approachSpeed;
    return way > kLeastWay * slop && separation > 0 && separation < std::max(way, slop);
}

/// Removes a manifold that predicts a touch although its bodies, from these poses at their
/// velocities, pass each other: beyond a corner or on a disc, its tangent goes on. True if so; the
/// lane of the contact must then expire.
bool removePassing(Manifold& manifold, const Contact& contact, const Bodies& bodies,
                   const std::array<Transform, 2>& poses, Real slop, Real dt);

/// Sets the approach speed (m/s) from the current velocities, for the record and the impacts.
void measureApproach(const Contact& contact, const ContactLane& lane, const Bodies& bodies);

/// False if a number of the contact is larger than any of a World, or not a number. Products of
/// two such lengths and speeds are finite.
bool isSound(const Contact& contact, const ContactNumbers& numbers);

/// Resets a contact whose parts are not near each other any more.
void clearContact(Contact& contact, const ContactLane& lane);

} // namespace KODO_PRECISION
} // namespace kodo
