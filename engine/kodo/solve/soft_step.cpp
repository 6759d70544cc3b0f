// SPDX-License-Identifier: MIT
#include <kodo/base/prefetch.hpp>
#include <kodo/bodies/integrate.hpp>
#include <kodo/solve/soft_step.hpp>

#include <algorithm>
#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

constexpr std::size_t kNewcomersAPiece = 128;
constexpr std::size_t kMany = 8; // one of so many: then what all have is cleared as a whole
// Springs swing through so much of a cycle in a substep at most. With a quarter of one in contacts
// piles shake for long, and creep apart; with a fifth they come to rest.
constexpr Real kMostCycles = Real(0.21);
constexpr Real kMostJointCycles = Real(0.25);

/// Of a contact that pushes: a row is needed once the bodies are near enough to touch within the
/// step. Those that bounce must not be braked before they touch, or they would lose the speed they
/// bounce with.
bool needsRow(const Bodies& bodies, const ContactHead& head, bool restitution, Real slop) {
    // What rests is woken by a touch, not by what comes near.
    if (bodies.anyRests && (bodies.resting(head.bodyA) || bodies.resting(head.bodyB))) {
        return false;
    }
    return !(head.bounces && restitution) || head.separation[0] <= slop;
}

/// Does the head of a contact that is kept tell what the contact does?
[[maybe_unused]] bool isKept(const Contact& contact, const ContactHead& head) {
    return contact.isKept() && contact.row.index == head.row;
}

} // namespace

/// Nobody is touched yet but by joints.
void SoftStep::clearMarks(const Bodies& bodies, const JointSet& joints) {
    holds_.resize(bodies.size());
    near_.resize(bodies.size());
    touched_.resize(bodies.size());
    crowd_.resize(bodies.size());
    anyDeep_ = 0;
    const bool most = kMany * bodies.awake.size() > bodies.size();
    if (std::exchange(crowded_, std::uint8_t{0}) != 0 || most) { // also what takes no part any more
        std::fill(crowd_.begin(), crowd_.end(), std::uint16_t{0});
    }
    if (most) {
        std::fill(near_.begin(), near_.end(), std::uint8_t{0});
        std::fill(touched_.begin(), touched_.end(), std::uint8_t{0});
    } else {
        for (const std::uint32_t body : bodies.awake) {
            near_[body] = 0;
            touched_[body] = 0;
            crowd_[body] = 0;
        }
    }
    joints.forEachBusy([&](const JointSet::Joint& joint) {
        touched_[firstBody(joint.def).index] = 1;
        touched_[secondBody(joint.def).index] = 1;
    });
}

/// Takes a contact into the solver that keep() will not do for. Those that need another lane are
/// listed.
void SoftStep::takeAnew(const Bodies& bodies, ContactSet& contactSet, std::uint32_t place,
                        bool friction, std::vector<std::uint32_t>& newcomers) {
    Contact& contact = contactSet.contacts()[place];
    if (!friction) {
        contact.friction = 0; // kept from when there was some
    }
    if (blocks_.take(bodies, contact)) {
        contactSet.noteRow(place);
    } else {
        newcomers.push_back(place);
    }
}

/// Takes a contact out of the solver.
void SoftStep::giveUpRow(const Bodies& bodies, ContactSet& contactSet, std::uint32_t place) {
    Contact& contact = contactSet.contacts()[place];
    blocks_.reclaim(contact, bodies);
    contact.row = {};
    contact.carried = false;
    contactSet.noteRow(place);
}

/// Before the contacts of a step are collected.
void SoftStep::beginCollecting(const Bodies& bodies, ContactSet& contactSet, const JointSet& joints,
                               const Step& step) {
    const std::uint32_t shares = step.crew.shares();
    const bool shared = shares > 1 && blocks_.worthSharing();
    if (blocks_.countDisorder() || (shared && blocks_.shares() != shares)) {
        blocks_.dealAnew(bodies, contactSet, shared ? shares : 1);
    }
    blocks_.begin(bodies, contactSet.contacts(), step.settings.has(Feature::Friction),
                  step.settings.has(Feature::RollingResistance));
    clearMarks(bodies, joints);
    newcomers_.clear();
}

/// Besides the blocks: which bodies are held by something, and which are crowded. A body in the
/// middle of a heap is pushed by all of it, and those behind push on; together they must not exceed
/// the speed that one of them may push with, or the heap would burst.
void SoftStep::collect(const Bodies& bodies, ContactSet& contactSet, const JointSet& joints,
                       const Step& step) {
    const std::span<const std::uint32_t> live = contactSet.live();
    beginCollecting(bodies, contactSet, joints, step);
    found_.gather(
        step.crew, live.size(), kNewcomersAPiece, newcomers_,
        [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& newcomers) {
            forPieces(first, last, kNewcomersAPiece, [&](auto from, auto to) {
                collectPiece({bodies, contactSet, step}, live.subspan(from, to - from), newcomers);
            });
        });
}

/// First those that are kept, by their heads alone, and then the others, if anything has changed.
void SoftStep::collectPiece(const Collecting& run, std::span<const std::uint32_t> places,
                            std::vector<std::uint32_t>& newcomers) {
    const Bodies& bodies = run.bodies;
    ContactSet& contactSet = run.contactSet;
    const Step& step = run.step;
    const std::span<Contact> contacts = contactSet.contacts();
    // copies, since a byte that is written may be in one of the others
    const ContactHead* const headOf = contactSet.heads().data();
    const bool friction = step.settings.has(Feature::Friction);
    const bool restitution = step.settings.has(Feature::Restitution);
    const bool keeps = friction && blocks_.keepsLanes();
    const Real slop = step.tolerances.slop;
    Places<kNewcomersAPiece> asked;
    for (const std::uint32_t place : places) {
        const ContactHead& head = headOf[place];
        if (keeps && head.kept && needsRow(bodies, head, restitution, slop)) {
            KODO_ASSERT(isKept(contacts[place], head));
            blocks_.keep(head.row);
            noteHold(bodies, head, slop, step.crew);
        } else if (!keeps || head.meets || head.row != ContactRow::kNone) {
            asked.add(place);
        }
    }
    visitAhead<4>(asked.list(), contacts, [&](std::uint32_t place) {
        if (needsRow(bodies, headOf[place], restitution, slop) && contacts[place].responds()) {
            takeAnew(bodies, contactSet, place, friction, newcomers);
            noteHold(bodies, headOf[place], slop, step.crew);
        } else {
            giveUpRow(bodies, contactSet, place);
        }
    });
}

/// Its two bodies are held, or have somebody near.
void SoftStep::noteHold(const Bodies& bodies, const ContactHead& head, Real slop,
                        const Crew& crew) {
    const Real separation = head.separation[0];
    std::uint8_t* const marks = separation <= slop ? touched_.data() : near_.data();
    Crew::mark(marks[head.bodyA]);
    Crew::mark(marks[head.bodyB]);
    if (separation < -4 * slop) {
        noteCrowd(bodies, head, crew);
    }
    if (separation < Settling::deepBelow(slop)) {
        Crew::mark(anyDeep_);
    }
}

/// Counts two that overlap by more than four slops for each other.
void SoftStep::noteCrowd(const Bodies& bodies, const ContactHead& head, const Crew& crew) {
    for (const std::uint32_t body : {head.bodyA, head.bodyB}) {
        if (bodies.locked(body)) {
            continue;
        }
        const auto count = static_cast<std::uint16_t>(crew.count(crowd_[body]) + 1);
        if (count > ContactBlocks::kNeighbours) {
            Crew::mark(crowded_);
        }
    }
}

/// Lists the bodies of joints that are not lent, each once.
void SoftStep::findJointed(const JointSet& joints) {
    jointed_.clear();
    joints.forEachOwn([&](const JointSet::Joint& joint) {
        jointed_.push_back(firstBody(joint.def).index);
        jointed_.push_back(secondBody(joint.def).index);
    });
    std::sort(jointed_.begin(), jointed_.end()); // total order: equal numbers are the same
    jointed_.erase(std::unique(jointed_.begin(), jointed_.end()), jointed_.end());
    fromJoints_.resize(jointed_.size());
    beforeJoints_.resize(jointed_.size());
}

/// Whether no contact needs a row; none has one then.
bool SoftStep::noneNeedsRow(const Bodies& bodies, ContactSet& contactSet,
                            const StepSettings& settings, const Tolerances& tolerances) {
    for (const std::uint32_t place : contactSet.live()) {
        if (contactSet.contacts()[place].responds() &&
            needsRow(bodies, contactSet.heads()[place], settings.has(Feature::Restitution),
                     tolerances.slop)) {
            return false;
        }
        giveUpRow(bodies, contactSet, place);
    }
    return true;
}

/// Bodies that nothing can push go all their way at once, so that their flight does not depend on
/// the substeps, not even by a rounding. The others are listed.
void SoftStep::moveFree(Bodies& bodies, Real dt) {
    free_.resize(bodies.awake.size());
    bound_.resize(bodies.awake.size());
    std::size_t free = 0;
    std::size_t bound = 0;
    for (const std::uint32_t body : bodies.awake) {
        const Hold near = near_[body] != 0 ? Hold::Near : Hold::Free;
        const Hold hold = touched_[body] != 0 ? Hold::Touched : near;
        holds_[body] = hold;
        free_[free] = bound_[bound] = body; // only one of the two goes on to the next
        free += hold == Hold::Free ? 1 : 0;
        bound += hold == Hold::Free ? 0 : 1;
    }
    free_.resize(free);
    bound_.resize(bound);
    moveFreely(bodies, free_, dt);
}

void SoftStep::solve(Bodies& bodies, ContactSet& contactSet, JointSet& joints, const Step& step) {
    if (joints.busyCount() == 0 &&
        noneNeedsRow(bodies, contactSet, step.settings, step.tolerances)) {
        if (blocks_.size() > 0) {
            blocks_.releaseAll(bodies);
        }
        moveFreely(bodies, bodies.awake, step.dt);
        visits_ = 0;
    } else {
        solveHeld(bodies, contactSet, joints, step);
    }
}

/// What solve() does where something may hold some bodies.
void SoftStep::solveHeld(Bodies& bodies, ContactSet& contactSet, JointSet& joints,
                         const Step& step) {
    const auto& [settings, tolerances, dt, crew] = step;
    const Real whole = dt / static_cast<Real>(settings.substeps);
    const int parts = refinement(bodies, contactSet,
                                 std::min(settings.contactHertz, kMostCycles / whole), tolerances);
    const Real h = whole / static_cast<Real>(parts);
    blocks_.refine(parts, contactSet.contacts(), bodies);
    collect(bodies, contactSet, joints, step);
    blocks_.arrange(bodies, contactSet.contacts(), newcomers_,
                    crowded_ != 0 ? std::span<const std::uint16_t>(crowd_)
                                  : std::span<const std::uint16_t>(),
                    settings.pushSpeed * tolerances.slop * Tolerances::kSlopsPerUnit);
    for (const std::uint32_t place : newcomers_) {
        contactSet.noteRow(place);
    }
    const Real hertz = std::min(settings.contactHertz * static_cast<Real>(parts), kMostCycles / h);
    const ContactPassArguments pass =
        blocks_.pass(bodies, {Softness::from(hertz, settings.contactDamping, h),
                              Softness::from(2 * hertz, settings.contactDamping, h), 1 / h,
                              settings.has(Feature::Friction), 1});
    if (anyDeep_ != 0) {
        settling_.find({pass, blocks_.colours(), Settling::deepBelow(tolerances.slop), crowd_});
    } else {
        settling_.clear();
    }
    const Real jointHertz = std::min(settings.jointHertz, kMostJointCycles / h);
    JointPass jointPass{h, Softness::from(jointHertz, settings.jointDamping, h)};
    joints.beginStep(bodies);
    joints.scaleImpulses(1 / static_cast<Real>(parts));
    pins_.begin(bodies, joints);
    findJointed(joints);
    moveFree(bodies, dt);
    const int substeps = parts * settings.substeps;
    Crew nobody;
    const bool helped = blocks_.worthSharing() && blocks_.shares() == crew.shares();
    Substeps run{bodies, joints, pass, jointPass, helped ? crew : nobody};
    if (!run.crew.alone()) {
        shares_.deal({blocks_, pass, contactSet.contacts(), newcomers_, bound_, bodies.size()},
                     run.crew);
    }
    runSubsteps(run, substeps);
    pins_.end(joints);
    joints.scaleImpulses(static_cast<Real>(parts));
    blocks_.noteTouching(tolerances.slop, crew);
    visits_ = (2 * blocks_.size() + settling_.visits()) * static_cast<std::size_t>(substeps);
}

} // namespace kodo::inline KODO_PRECISION
