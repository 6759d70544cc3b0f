// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/crew.hpp>
#include <kodo/bodies/bodies.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/collide/time_of_impact.hpp>
#include <kodo/contacts/contact_set.hpp>
#include <kodo/solve/settings.hpp>

#include <array>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Stops bodies where they would first touch within the step, so that nothing passes through
/// anything, however fast and thin. A pair is looked at when its motion could close its gap, and it
/// bounces or moves by more than the thinner one's inner radius; by more than half of that where
/// one of the two is locked.
///
/// Sensors stop nothing; one that was passed through within the step is marked as touched, with
/// where and how fast.
///
/// A body that is stopped keeps the velocity it had at that moment and gives up the rest of its
/// step; the blow itself is dealt in the next one. Impacts are taken in the order of their time.
///
/// What is locked and moves cannot be stopped. It would go on through whatever has been stopped in
/// front of it; so it pushes that along, and what that touches in turn. What bounces off it is not
/// pushed.
class SweepStage {
public:
    void run(Bodies& bodies, ContactSet& contactSet, const StepSettings& settings,
             const Tolerances& tolerances, Real dt, Crew& crew);

private:
    /// An impact as it was found once; out of date if the contact has another time by now.
    struct Event {
        Real time;
        std::uint32_t contact;
    };
    /// What all of it is about.
    struct Step {
        const Bodies& bodies;
        std::span<const Contact> contacts;
        std::span<const ContactHead> heads;
        const StepSettings& settings;
        const Tolerances& tolerances;
        bool driven; // something locked moves
    };

    bool markSwift(const Bodies& bodies, bool mayBounce, const Tolerances& tolerances, Crew& crew);
    bool findCandidates(const Bodies& bodies, const ContactSet& contactSet,
                        const Tolerances& tolerances, Crew& crew);
    bool isSwift(const ContactHead& head) const {
        return (swift_[head.bodyA] | swift_[head.bodyB]) != 0;
    }
    void linkContacts(const Step& step);
    void findTime(const Step& step, std::uint32_t contact);
    void expect(std::uint32_t contact);
    void findImpacts(const Step& step, Crew& crew);
    void stopInOrder(const Step& step);
    Sweep sweepOf(const Bodies& bodies, std::uint32_t body) const;
    Real motionOf(const Bodies& bodies, const Contact& contact) const;
    Real impactTime(const Bodies& bodies, const Contact& contact, Real gap) const;
    void findPushes(const Step& step);
    void takePush(const Step& step, const Contact& contact, Real time);
    void cutShort(const Step& step, std::uint32_t body, Real time);
    void finish(Bodies& bodies, bool driven, Real dt);
    void noticeSensors(const Bodies& bodies, std::span<Contact> contacts,
                       const StepSettings& settings, const Tolerances& tolerances);
    void noticeOnTheWay(const Bodies& bodies, Contact& contact, Real share,
                        const Tolerances& tolerances) const;

    std::vector<std::uint8_t> swift_; // by body: does it go so far that a pair needs a look?
    std::vector<Real> stopAt_;        // share of the step, by body
    std::vector<Vec2> push_;          // m, over a whole step, by body: by what is locked and moves
    std::vector<std::uint32_t> stopped_;    // bodies
    std::vector<std::uint32_t> candidates_; // contacts that could meet if nobody is stopped
    Findings<std::uint32_t> found_;
    std::vector<Real> times_; // by contact: share of the step; 1: they do not meet in it
    // Lists of the contacts of each body: where that of a body begins, and where that of the first
    // and of the second body of a contact goes on.
    std::vector<std::uint32_t> first_;
    std::vector<std::array<std::uint32_t, 2>> next_;
    std::vector<std::uint32_t> againstLocked_; // contacts
    std::vector<Event> events_;                // a heap, the earliest on top
};

} // namespace kodo::inline KODO_PRECISION
