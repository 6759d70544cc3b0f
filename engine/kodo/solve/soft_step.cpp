// SPDX-License-Identifier: MIT
#include <kodo/bodies/integrate.hpp>
#include <kodo/solve/soft_step.hpp>

#include <algorithm>

namespace kodo::inline KODO_PRECISION {
namespace {

/// A row is needed once the bodies are near enough to touch within the step. Those that bounce must
/// not be braked before they touch, or they would lose the speed they bounce with.
bool needsRow(const Bodies& bodies, const Contact& contact, const StepSettings& settings,
              const Tolerances& tolerances) {
    // What rests is woken by a touch, not by what comes near.
    if (!contact.responds() || bodies.resting(contact.key.bodyA) ||
        bodies.resting(contact.key.bodyB)) {
        return false;
    }
    const bool bounces = contact.material.restitution > 0 && settings.has(Feature::Restitution);
    return !bounces || contact.manifold.points[0].separation <= tolerances.slop;
}

} // namespace

/// Besides the blocks: which bodies are held by something, and which are crowded. A body in the
/// middle of a heap is pushed by all of it, and those behind push on; together they must not exceed
/// the speed that one of them may push with, or the heap would burst.
void SoftStep::collect(const Bodies& bodies, std::span<const Contact> contacts,
                       const JointSet& joints, const StepSettings& settings,
                       const Tolerances& tolerances) {
    blocks_.clear(bodies);
    held_.resize(bodies.size());
    crowd_.resize(bodies.size());
    for (const std::uint32_t body : bodies.awake) {
        held_[body] = 0;
        crowd_[body] = 0;
    }
    joints.forEach([&](const JointSet::Joint& joint) {
        held_[firstBody(joint.def).index] = 1;
        held_[secondBody(joint.def).index] = 1;
    });
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Contact& contact = contacts[i];
        if (!needsRow(bodies, contact, settings, tolerances)) {
            continue;
        }
        blocks_.add(bodies, contact, static_cast<std::uint32_t>(i));
        const Real separation = contact.manifold.points[0].separation;
        for (const std::uint32_t body : {contact.key.bodyA, contact.key.bodyB}) {
            held_[body] |= separation <= tolerances.slop ? 1 : 0;
            if (separation < -4 * tolerances.slop && !bodies.locked(body)) {
                ++crowd_[body];
            }
        }
    }
}

void SoftStep::beginSubstep(Bodies& bodies, Real h) {
    integrateVelocities(bodies, h);
    for (const std::uint32_t i : bodies.awake) {
        Motion& motion = bodies.motion[i];
        before_[i] = {motion.velocity, motion.angularVelocity};
        motion.velocity += gained_[i].velocity;
        motion.angularVelocity += gained_[i].angularVelocity;
    }
}

/// The arms of joints do turn within a step, so their share is taken out again, and put back by
/// their own warm start.
void SoftStep::endSubstep(Bodies& bodies, JointSet& joints, const JointPass& pass) {
    for (const std::uint32_t i : bodies.awake) {
        const Motion& motion = bodies.motion[i];
        gained_[i].velocity = motion.velocity - before_[i].linear;
        gained_[i].angularVelocity = motion.angularVelocity - before_[i].angular;
    }
    joints.takeOut(bodies, pass, gained_);
}

void SoftStep::solve(Bodies& bodies, std::span<Contact> contacts, JointSet& joints,
                     const StepSettings& settings, const Tolerances& tolerances, Real dt) {
    collect(bodies, contacts, joints, settings, tolerances);
    blocks_.arrange(bodies, contacts, crowd_,
                    settings.pushSpeed * tolerances.slop * Tolerances::kSlopsPerUnit,
                    settings.has(Feature::RollingResistance));
    before_.resize(bodies.size());
    gained_.resize(bodies.size());
    for (const std::uint32_t i : bodies.awake) {
        gained_[i] = {};
        gained_[i].invMass = bodies.motion[i].invMass;
        gained_[i].invInertia = bodies.motion[i].invInertia;
    }
    const Real h = dt / static_cast<Real>(settings.substeps);
    const Real hertz = std::min(settings.contactHertz, Real(0.25) / h);
    const ContactPasses& passes = ContactPasses::best();
    const ContactPassArguments pass =
        blocks_.pass(bodies, {Softness::from(hertz, settings.contactDamping, h),
                              Softness::from(2 * hertz, settings.contactDamping, h), 1 / h,
                              settings.has(Feature::Friction)});
    JointPass jointPass{
        h, Softness::from(std::min(settings.jointHertz, Real(0.25) / h), settings.jointDamping, h)};
    joints.beginStep();
    for (int substep = 0; substep < settings.substeps; ++substep) {
        beginSubstep(bodies, h);
        joints.warmStart(bodies, jointPass);
        if (substep == 0) {
            passes.warmStart(pass);
        }
        jointPass.biased = true;
        joints.solve(bodies, jointPass);
        passes.solve(pass);
        integrateMoves(bodies, held_, h);
        jointPass.biased = false;
        joints.solve(bodies, jointPass);
        passes.relax(pass);
        endSubstep(bodies, joints, jointPass);
    }
    blocks_.store(contacts);
}

} // namespace kodo::inline KODO_PRECISION
