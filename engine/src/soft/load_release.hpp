// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "joints/step_input.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include "lanes/contact_blocks.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Takes back warm started impulses that carried a load which is gone: a body on top was removed,
/// teleported or became lighter, or a field was switched off. Passes over a tower spread the
/// velocity that such impulses cause instead of removing it, and the bodies below leap.
///
/// A warm start that fits balances the forces of the step. Where it does not, it kicks a body. The
/// contacts that push in the direction of the kick give up the share of their impulses that does,
///
///   share = <kick, gain> / <gain, gain>,  0 <= share <= 1,  <v, w> = m v.w + I v_r w_r
///
/// `gain` is the velocity change by these contacts. That kicks the bodies below, which follow in
/// the same way, down to what cannot move. With all impulses gone there is no kick. So this adds no
/// energy, and impulses within the islands of other bodies stay as they are. Bodies with joints are
/// never kicked, since trees of joints are solved without a warm start.
///
/// It starts at bodies with BodyRecord::lostLoad, so a step without changes or impacts costs
/// nothing. A contact of such a body that separates faster than the forces of a substep could stop
/// loses its impulses first: so it does where the load was thrown off.
class LoadRelease {
public:
    /// Velocity or change of speeds(). The fourth component, 1/mass, stays constant.
    struct Velocity {
        Four speeds{};
    };
    /// Sizes the arrays by body.
    void makeRoom(const Bodies& bodies) {
        resizeByBody(visits_, bodies);
        resizeByBody(queued_, bodies);
    }
    /// After the warm start of contacts in a substep of h (s). `list`: bodies; `before`: their
    /// velocities with the forces of the substep, without contacts and joints.
    void run(const StepInput& inputs, std::span<const std::uint32_t> list,
             std::span<const Velocity> before, Real h);

private:
    /// Velocity change of a body by one contact.
    struct Gain {
        std::uint32_t slot;
        Vec2 velocity;
        Real angular;
    };

    bool isKicked(const StepInput& inputs, std::uint32_t body, Real h) const;
    Real separatingSpeed(const Bodies& bodies, const ContactLanes::Place& at) const;
    void releaseSeparating(const StepInput& inputs, std::uint32_t body, Real h);
    void addKicked(std::uint32_t body);
    void release(const StepInput& inputs, std::uint32_t body, Real h);
    void listContacts(const StepInput& inputs, std::uint32_t body);
    void findGains(const StepInput& inputs, std::uint32_t body);

    std::span<const Velocity> before_;
    std::vector<std::uint32_t> changed_; // bodies with BodyRecord::lostLoad
    std::vector<std::uint32_t> queue_;
    std::vector<std::uint32_t> slots_;
    std::vector<Gain> gains_;
    std::vector<std::uint8_t> visits_; // by body; 0 between steps
    std::vector<std::uint8_t> queued_; // by body: is in queue_
};

} // namespace KODO_PRECISION
} // namespace kodo
