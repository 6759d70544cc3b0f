// SPDX-License-Identifier: MIT
#include <kodo/bodies/integrate.hpp>
#include <kodo/solve/impact.hpp>
#include <kodo/world/world.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace kodo::inline KODO_PRECISION {
namespace {

/// With fewer bodies awake a step is over before anybody could come to help.
constexpr std::size_t kWorthHelp = 256;
constexpr std::size_t kBodiesAPiece = 256;

} // namespace

void World::step(Real dt, const StepAids& aids) {
    refuse(checkRange("dt", dt, kShortestStep, kLongestStep));
    const auto enter = [&](StepStage stage) {
        if (aids.watch != nullptr) {
            aids.watch->enter(stage);
        }
    };
    enter(StepStage::Broad);
    findAwake();
    Crew crew(bodies_.awake.size() >= kWorthHelp ? aids.executor : nullptr);
    contacts_.updatePairs(bodies_, tolerances_, dt, crew);
    enter(StepStage::Narrow);
    updateManifolds(crew);
    enter(StepStage::Forces);
    gatherForces(dt, crew);
    enter(StepStage::Solve);
    solve(dt, crew);
    enter(StepStage::Sweep);
    if (settings_.has(Feature::Sweep)) {
        sweep(dt, crew);
    }
    enter(StepStage::Record);
    finishMoves(crew);
    if (!contacts_.contacts().empty() || !contacts_.touchChanges().empty()) {
        recordCollisions(crew);
    }
    contacts_.finishStep(settings_.has(Feature::Records));
    broken_.clear();
    if (joints_.size() > 0) {
        breakJoints(dt);
    }
    enter(StepStage::Rest);
    if (settings_.has(Feature::Resting) && !bodies_.awake.empty() &&
        rest_.findRest(bodies_, contacts_, joints_, settings_, tolerances_, dt)) {
        fetchContacts();
        rest_.settle(bodies_, contacts_);
    }
    ++stepCount_;
    if (aids.watch != nullptr) {
        aids.watch->leave();
    }
}

/// Finds where bodies touch.
void World::updateManifolds(Crew& crew) {
    ContactBlocks& blocks = softStep_.blocks();
    reclaimJumped();
    noteStart(bodies_);
    blocks.carry(bodies_, crew);
    contacts_.updateManifolds(
        bodies_, tolerances_,
        {blocks.carried(), [&](Contact& contact) { blocks.reclaim(contact, bodies_); }}, crew);
}

/// Where some were put elsewhere, their contacts are not carried on unseen.
void World::reclaimJumped() {
    if (!bodies_.anyJumped) {
        return;
    }
    const std::span<const ContactHead> heads = contacts_.heads();
    for (std::uint32_t i = 0; i < heads.size(); ++i) {
        if (heads[i].row != ContactRow::kNone &&
            (bodies_.hasJumped[heads[i].bodyA] | bodies_.hasJumped[heads[i].bodyB]) != 0) {
            softStep_.blocks().reclaim(contacts_.contacts()[i], bodies_);
            contacts_.noteRow(i);
        }
    }
}

/// Wakes who is touched, and finds what will speed up whom.
void World::gatherForces(Real dt, Crew& crew) {
    forAwake(crew, beginMotion);
    if (mayWake()) {
        rest_.wakeTouched(bodies_, contacts_, tolerances_);
        rest_.wakeJointed(bodies_, contacts_, joints_);
    }
    joints_.findBusy(bodies_, refreshAwake(bodies_));
    frozen_.clear();
    const bool changed = bodies_.pushesStale;
    if (!gatherAccelerations(bodies_, fields_, dt, crew)) {
        freezeUnsoundForces();
    }
    if (changed) {
        noteLoads(bodies_);
    }
    if (region_) {
        holdWhatWaits();
    }
    bodies_.anyRests = rest_.anyResting();
}

/// Cuts moves short where bodies would first touch.
void World::sweep(Real dt, Crew& crew) {
    contacts_.coverMoves(bodies_, tolerances_, crew);
    if (mayWake() && rest_.wakeRunOver(bodies_, contacts_, tolerances_)) {
        joints_.findBusy(bodies_, refreshAwake(bodies_));
    }
    if (!contacts_.contacts().empty()) {
        sweep_.run(bodies_, contacts_, settings_, tolerances_, dt, crew);
    }
}

/// Puts bodies where their moves lead; those whose motion is unsound freeze where they are.
void World::finishMoves(Crew& crew) {
    releaseWhatWaits();
    if (!allSound(crew)) {
        freezeUnsoundMotion();
    }
    forAwake(crew, movePoses);
}

void World::forAwake(Crew& crew, void (*work)(Bodies&, std::span<const std::uint32_t>)) {
    crew.forEach(bodies_.awake.size(), kBodiesAPiece, [&](std::size_t first, std::size_t last) {
        work(bodies_, std::span<const std::uint32_t>(bodies_.awake).subspan(first, last - first));
    });
}

void World::solve(Real dt, Crew& crew) {
    if (settings_.strategy == Strategy::Propagation) {
        contacts_.lookAtAll(); // it foresees contacts within the step
        propagation_.solve(bodies_, contacts_.contacts(), joints_,
                           {settings_, tolerances_, dt, stepCount_});
        contacts_.noteManifolds();
        contactVisits_ = propagation_.visits();
        return;
    }
    impacts_.solve(bodies_, contacts_, softStep_.blocks(), {settings_, tolerances_, dt, crew});
    softStep_.solve(bodies_, contacts_, joints_, {settings_, tolerances_, dt, crew});
    contactVisits_ = softStep_.visits();
}

/// Bodies that have left the region wait, and those that it has reached go on.
void World::findAwake() {
    if (region_) {
        for (const std::uint32_t body : bodies_.awake) {
            if (bodies_.ids.aliveAt(body) && !overlap(*region_, boundsOfBody(bodies_, body))) {
                placeInRegion(body);
            }
        }
    }
    if (!bodies_.awakeStale) {
        joints_.findBusy(bodies_, false);
        return;
    }
    wereAwake_.assign(bodies_.awake.begin(), bodies_.awake.end());
    refreshAwake(bodies_);
    joints_.findBusy(bodies_, true);
    if (rest_.anyResting() || region_) {
        switched_.clear();
        std::set_symmetric_difference(wereAwake_.begin(), wereAwake_.end(), bodies_.awake.begin(),
                                      bodies_.awake.end(), std::back_inserter(switched_));
        for (const std::uint32_t body : switched_) {
            contacts_.activityChanged(body);
        }
    }
}

void World::freezeUnsoundForces() {
    for (const std::uint32_t body : bodies_.awake) {
        if (!isSound(bodies_.acceleration[body])) {
            freeze(bodies_, body);
            frozen_.push_back(bodies_.idAt(body));
            contacts_.bodiesChanged(); // what froze is a piece of ground now
            softStep_.blocks().startAnew();
        }
    }
}

bool World::allSound(Crew& crew) const {
    // Nearly always all are slow, which four numbers at a time can tell; isSound judges moves like
    // speeds. Two components below a half make a length below the whole.
    const Real slow = kHighestSpeed * std::min(tolerances_.unit(), Real(1)) / 2;
    const Four bound{slow, slow, slow, 0}; // the last number is no speed
    std::uint8_t fast = 0;
    crew.forEach(bodies_.awake.size(), kBodiesAPiece, [&](std::size_t first, std::size_t last) {
        auto within = bound == bound;
        for (std::size_t k = first; k < last; ++k) {
            const Motion& motion = bodies_.motion[bodies_.awake[k]];
            within &= (speeds(motion) <= bound) & (speeds(motion) >= -bound) &
                      (moves(motion) <= bound) & (moves(motion) >= -bound);
        }
        if ((within[0] & within[1] & within[2]) == 0) {
            Crew::mark(fast);
        }
    });
    return fast == 0 || std::all_of(bodies_.awake.begin(), bodies_.awake.end(), [&](auto body) {
               return isSound(bodies_.motion[body], tolerances_.unit());
           });
}

/// What a body that became unsound did to its neighbours within the step cannot be told apart any
/// more, so they stop with it, but are free to go on from there.
void World::freezeUnsoundMotion() {
    const std::size_t before = frozen_.size();
    for (const std::uint32_t body : bodies_.awake) {
        Motion& motion = bodies_.motion[body];
        if (isSound(motion, tolerances_.unit())) {
            continue;
        }
        if (isFinite(motion.velocity) && std::isfinite(motion.angularVelocity)) {
            freeze(bodies_, body); // too fast by itself
        }
        motion.stand();
        const BodyId id = bodies_.idAt(body);
        if (std::find(frozen_.begin(), frozen_.end(), id) == frozen_.end()) {
            frozen_.push_back(id);
        }
    }
    if (frozen_.size() > before) {
        for (Motion& motion : bodies_.motion) { // of what stands too: 0 times infinity is no number
            if (!isSound(motion, tolerances_.unit())) {
                motion.stand();
            }
        }
        fetchContacts();
        contacts_.forgetUnsound(bodies_, tolerances_);
        joints_.forgetUnsound();
        contacts_.bodiesChanged();
        bodies_.awakeStale = true;
    }
}

void World::breakJoints(Real dt) {
    const std::span<const BrokenJoint> broken = joints_.endStep(dt);
    broken_.assign(broken.begin(), broken.end());
    if (!broken_.empty()) {
        contacts_.setApart(joints_.apart());
    }
}

/// Sums up the contacts of the step, and brings kColliding up to date: only those bodies for which
/// it changes are touched.
void World::recordCollisions(Crew& crew) {
    contacts_.sumUp(softStep_.blocks().touched(), tolerances_, crew);
    for (const std::uint32_t body : contacts_.touchChanges()) {
        Flags& flags = bodies_.filter[body].flags;
        flags = contacts_.isTouched(body) ? flags | kColliding : flags & ~kColliding;
    }
    contacts_.clearTouchChanges();
}

} // namespace kodo::inline KODO_PRECISION
