// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/continuous_mode.hpp"
#include "collide/time_of_impact.hpp"
#include "joints/step_input.hpp"

#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Continuous collision: stops bodies at the time of impact within the step, so that no body
/// tunnels, however fast and thin. A pair is processed if its motion can close its gap. It must
/// also have restitution, or move by more than the core radius of the thinner part. Against a
/// locked body the limit is half of that core radius.
///
/// Sensors stop no body. A sensor that is passed within the step is marked as touched, with the
/// point and the speed.
///
/// A stopped body keeps the velocity of that time and loses the rest of its displacement. The next
/// step applies the impact impulse. Impacts are processed in the order of time.
///
/// A kinematic body cannot be stopped and would pass through bodies stopped in front of it. So it
/// carries these along, and pushes the bodies that they touch. What meets it with restitution gets
/// its impact within the step.
///
/// A body that a joint connects to a stopped one is stopped where the joint would open.
class ContinuousCollision {
public:
    /// Sizes the arrays by body, so that no first use costs a step as much as all bodies.
    void makeRoom(const Bodies& bodies);
    void run(const StepInput& input);
    /// Slots of the contacts with lines whose bodies the last run stopped: a corner that was far
    /// off may now be near, so their manifolds must be found again.
    std::span<const std::uint32_t> stoppedAtLines() const { return stoppedAtLines_; }

private:
    static constexpr Real kTaken = -1; // as a time: the impact has been processed

    /// An impact; out of date if its contact has another time in times_.
    struct Event {
        Real time;
        std::uint32_t contact;
        ContactKey key;
    };
    /// Inputs of all functions for one step.
    struct Step : StepInput {
        std::span<Contact> contacts;
        std::span<const ContactSummary> summaries;
        bool driven; // a locked body moves
    };

    bool markSwift(const Bodies& bodies, const Tolerances& tolerances, WorkerTeam& team);
    bool findCandidates(const StepInput& input);
    bool isSwift(const Bodies& bodies, const ContactSummary& summary) const {
        return (swift_[summary.bodyA] | swift_[summary.bodyB]) != 0 &&
               areChecked(bodies, summary.bodyA, summary.bodyB);
    }
    Vec2& pushOf(std::uint32_t body);
    void findTime(const Step& step, std::uint32_t contact, Real from);
    void queueImpact(const Step& step, std::uint32_t contact);
    void findImpacts(const Step& step, WorkerTeam& team);
    void stopInOrder(const Step& step);
    MotionPath pathOf(const Bodies& bodies, std::uint32_t body) const;
    Real motionOf(const Bodies& bodies, const Contact& contact) const;
    bool meetsSurface(const Step& step, const Contact& contact, Real time) const;
    Real impactTime(const Bodies& bodies, const Contact& contact, Real gap, Real from) const;
    void noteLine(const Step& step, std::uint32_t contact);
    Real timeThroughLine(const Step& step, const Contact& contact, Real motion) const;
    Real timeToJointedLine(const Step& step, const Contact& contact, Real gap, Real from) const;
    void findPushes(const Step& step);
    Separation separationAt(const Step& step, const Contact& contact, Real time) const;
    void holdBackAtGround(const Step& step, std::uint32_t body, Real time);
    void bounceOff(const Step& step, std::uint32_t slot, Real time);
    void takePushedDisplacement(const Step& step, const Contact& contact, Real time);
    void cutShort(const Step& step, std::uint32_t body, Real time);
    bool mayMeetStopped(const Step& step, std::uint32_t body, std::uint32_t other) const;
    void stopJointed(const Step& step, bool atGround);
    Real violationAt(const Bodies& bodies, const JointDef& def, Real fractionA,
                     Real fractionB) const;
    void finish(Bodies& bodies, Real dt);
    void noticeSensors(const StepInput& input);
    bool meet(const Bodies& bodies, Contact& contact, const ContactLane& lane, Real fraction,
              const Tolerances& tolerances) const;

    std::vector<std::uint8_t> swift_;       // by body: moves so far that its pairs are tested
    std::vector<Real> stopAt_;              // by body: fraction of the step
    std::vector<Vec2> push_;                // by body: m, per whole step, by kinematic bodies
    std::vector<std::uint32_t> pushed_;     // bodies that may have a push_
    std::vector<std::uint32_t> stopped_;    // bodies with stopAt_ < 1
    std::vector<std::uint32_t> candidates_; // contacts that may meet while no body is stopped
    ParallelCollector<std::uint32_t> found_;
    std::vector<Real> times_;             // by contact: fraction of the step; 1: no impact
    std::vector<std::uint32_t> pulling_;  // stopped bodies whose joints are still to be tested
    std::vector<std::uint32_t> jointsOf_; // scratch: of one body
    std::vector<std::uint32_t> stoppedAtLines_; // see stoppedAtLines()
    std::vector<Event> events_;                 // heap, the earliest on top
};

} // namespace KODO_PRECISION
} // namespace kodo
