// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/crew.hpp>
#include <kodo/bodies/bodies.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/collide/time_of_impact.hpp>
#include <kodo/contacts/contact.hpp>
#include <kodo/solve/settings.hpp>

#include <array>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Stops bodies where they would first touch within the step, so that nothing passes through
/// anything, however fast and thin. A pair is looked at when its motion could close its gap, and it
/// bounces or moves by more than half of the thinner one's inner radius.
///
/// Sensors stop nothing; one that was passed through within the step is marked as touched, with
/// where and how fast.
///
/// A body that is stopped keeps the velocity it had at that moment and gives up the rest of its
/// step; the blow itself is dealt in the next one. Impacts are taken in the order of their time.
///
/// What is locked and moves cannot be stopped. It would run over what has been stopped in front of
/// it, step by step until that is through; so it pushes that along, with whom that has met. What
/// bounces off it is not pushed.
class SweepStage {
public:
    void run(Bodies& bodies, std::span<Contact> contacts, const StepSettings& settings,
             const Tolerances& tolerances, Real dt, Crew& crew);

private:
    struct Candidate {
        std::uint32_t contact;
        std::array<std::uint32_t, 2> next{}; // candidate of the same first, of the same second body
        Real time = 1;                       // share of the step; 1: they do not meet in it
        bool done = false;
    };
    /// An impact as it was found once; out of date if the candidate has another time by now.
    struct Event {
        Real time;
        std::uint32_t candidate;
    };
    /// What all of it is about.
    struct Step {
        const Bodies& bodies;
        std::span<const Contact> contacts;
        const StepSettings& settings;
        const Tolerances& tolerances;
        bool driven; // something locked moves
    };

    void measureWays(const Bodies& bodies, Crew& crew);
    bool findCandidates(const Bodies& bodies, std::span<const Contact> contacts,
                        const StepSettings& settings, const Tolerances& tolerances, Crew& crew);
    void linkCandidates(std::span<const Contact> contacts);
    void findTime(const Step& step, Candidate& candidate) const;
    void expect(std::uint32_t candidate);
    void stopInOrder(const Step& step, Crew& crew);
    Sweep sweepOf(const Bodies& bodies, std::uint32_t body) const;
    Real impactTime(const Bodies& bodies, const Contact& contact, Real gap) const;
    void findPushes(const Bodies& bodies, std::span<const Contact> contacts);
    void takePush(const Step& step, const Contact& contact, Real time);
    void cutShort(const Step& step, std::uint32_t body, Real time);
    void noticeSensors(const Bodies& bodies, std::span<Contact> contacts,
                       const StepSettings& settings, const Tolerances& tolerances);
    void noticeOnTheWay(const Bodies& bodies, Contact& contact, Real share,
                        const Tolerances& tolerances) const;

    std::vector<Real> ways_;           // m, by body: how far its outermost point goes at most
    std::vector<Real> stopAt_;         // share of the step, by body
    std::vector<Vec2> push_;           // m, over a whole step, by body: by what is locked and moves
    std::vector<std::uint32_t> first_; // by body: one of its candidates
    std::vector<std::uint32_t> places_; // of the contacts that need a sweep
    Findings<std::uint32_t> found_;
    std::vector<Candidate> candidates_;
    std::vector<Event> events_; // a heap, the earliest on top
};

} // namespace kodo::inline KODO_PRECISION
