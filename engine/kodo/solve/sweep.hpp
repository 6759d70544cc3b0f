// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/contacts/contact.hpp>
#include <kodo/solve/settings.hpp>

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
class SweepStage {
public:
    void run(Bodies& bodies, std::span<Contact> contacts, const StepSettings& settings,
             const Tolerances& tolerances, Real dt);

private:
    struct Candidate {
        std::uint32_t contact;
        Real gap;  // m, at which it is to be stopped
        Real time; // share of the step
        bool done;
    };

    void stopInOrder(const Bodies& bodies, std::span<const Contact> contacts);
    void noticeSensors(const Bodies& bodies, std::span<Contact> contacts,
                       const StepSettings& settings, const Tolerances& tolerances);
    void noticeOnTheWay(const Bodies& bodies, Contact& contact, Real share,
                        const Tolerances& tolerances) const;

    std::vector<Candidate> candidates_;
    std::vector<Real> stopAt_; // by body
};

} // namespace kodo::inline KODO_PRECISION
