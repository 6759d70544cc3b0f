// SPDX-License-Identifier: MIT
#include <kodo/bodies/integrate.hpp>
#include <kodo/solve/soft_step.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

constexpr std::size_t kNewcomersAPiece = 128;
constexpr std::size_t kMany = 8;        // one of so many: then what all have is cleared as a whole
constexpr std::uint32_t kDealtFor = 64; // steps with help, until lanes are dealt out anew
// Overlaps of more than so many slops are deep, as when bodies are put on one place. The speed that
// their pushes give is taken out again by more passes, two for one of them and one more for each
// further one, up to so many: over all contacts where one of eight is deep or there are not many,
// else over those alone, although what they push may push on others.
// In a large crowd the push is shared out, and there are many contacts: fewer passes will do.
constexpr Real kDeep = 8;
constexpr int kSomeDeep = 8;
constexpr int kNotMany = 256;
constexpr int kMostSettling = 10;
constexpr int kLargeCrowd = 600; // of passes times bodies

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

/// How many passes more settle so many deep contacts; `crowd` is the most that overlap one body.
int settlingOf(int deep, int crowd) {
    if (deep == 0) {
        return 0;
    }
    return std::min({1 + deep, kMostSettling, 1 + kLargeCrowd / crowd});
}

} // namespace

/// Nobody is touched yet but by joints.
void SoftStep::clearMarks(const Bodies& bodies, const JointSet& joints) {
    holds_.resize(bodies.size());
    near_.resize(bodies.size());
    touched_.resize(bodies.size());
    crowd_.resize(bodies.size());
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
    if (shares > 1 && blocks_.worthSharing() &&
        (blocks_.shares() != shares || ++helped_ >= kDealtFor ||
         blocks_.size() > dealt_ + dealt_ / 4)) {
        helped_ = 0;
        dealt_ = blocks_.size();
        blocks_.dealAnew(bodies, contactSet, shares);
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
    const std::span<Contact> contacts = contactSet.contacts();
    const std::span<const ContactHead> heads = contactSet.heads();
    const std::span<const std::uint32_t> live = contactSet.live();
    Crew& crew = step.crew;
    const bool friction = step.settings.has(Feature::Friction);
    const bool withRestitution = step.settings.has(Feature::Restitution);
    beginCollecting(bodies, contactSet, joints, step);
    const bool keepsLanes = friction && blocks_.keepsLanes();
    std::uint16_t most = 1; // that overlap one body
    int deep = 0;
    int rows = 0;
    found_.gather(crew, live.size(), kNewcomersAPiece, newcomers_,
                  [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& newcomers) {
                      // copies, since a byte that is written may be in one of the others
                      const bool keeps = keepsLanes;
                      const bool restitution = withRestitution;
                      const Real slop = step.tolerances.slop;
                      const ContactHead* const headOf = heads.data();
                      const std::uint32_t* const placeOf = live.data();
                      std::uint8_t* const touched = touched_.data();
                      std::uint8_t* const near = near_.data();
                      int ownDeep = 0;
                      int ownRows = 0;
                      for (std::size_t i = first; i < last; ++i) {
                          const std::uint32_t place = placeOf[i];
                          const ContactHead& head = headOf[place];
                          if (keeps && !head.meets && head.row == ContactRow::kNone) {
                              continue; // as before
                          }
                          const bool needed = needsRow(bodies, head, restitution, slop);
                          if (keeps && head.kept && needed) {
                              KODO_ASSERT(isKept(contacts[place], head));
                              blocks_.keep(head.row);
                          } else if (!needed || !contacts[place].responds()) {
                              giveUpRow(bodies, contactSet, place);
                              continue;
                          } else {
                              takeAnew(bodies, contactSet, place, friction, newcomers);
                          }
                          const Real separation = head.separation[0];
                          std::uint8_t* const marks = separation <= slop ? touched : near;
                          Crew::mark(marks[head.bodyA]);
                          Crew::mark(marks[head.bodyB]);
                          if (separation < -4 * slop) {
                              noteCrowd(bodies, head, most, crew);
                          }
                          ownDeep += separation < -kDeep * slop ? 1 : 0;
                          ++ownRows;
                      }
                      crew.count(deep, ownDeep);
                      crew.count(rows, ownRows);
                  });
    settling_ = settlingOf(deep, most);
    settlesAll_ = kSomeDeep * deep >= rows || rows <= kNotMany;
}

/// Counts two that overlap deeply for each other. `most` is the largest count so far.
void SoftStep::noteCrowd(const Bodies& bodies, const ContactHead& head, std::uint16_t& most,
                         const Crew& crew) {
    for (const std::uint32_t body : {head.bodyA, head.bodyB}) {
        if (bodies.locked(body)) {
            continue;
        }
        const auto count = static_cast<std::uint16_t>(crew.count(crowd_[body]) + 1);
        Crew::raise(most, count);
        if (count > ContactBlocks::kNeighbours) {
            Crew::mark(crowded_);
        }
    }
}

/// Lists the bodies of joints, each once.
void SoftStep::findJointed(const JointSet& joints) {
    jointed_.clear();
    joints.forEachBusy([&](const JointSet::Joint& joint) {
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
    const auto hertzOf = [](Real hertz, Real h) { return std::min(hertz, Real(0.25) / h); };
    const int parts =
        refinement(bodies, contactSet, hertzOf(settings.contactHertz, whole), tolerances);
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
    const bool some = settling_ > 0 && !settlesAll_;
    const Real settleBelow = some ? -kDeep * tolerances.slop : std::numeric_limits<Real>::max();
    const std::size_t settled = some ? blocks_.listDeeper(settleBelow, deep_) : blocks_.size();
    const Real hertz = hertzOf(settings.contactHertz * static_cast<Real>(parts), h);
    const ContactPassArguments pass =
        blocks_.pass(bodies, {Softness::from(hertz, settings.contactDamping, h),
                              Softness::from(2 * hertz, settings.contactDamping, h), 1 / h,
                              settings.has(Feature::Friction), 1, settleBelow});
    JointPass jointPass{h,
                        Softness::from(hertzOf(settings.jointHertz, h), settings.jointDamping, h)};
    joints.beginStep();
    joints.scaleImpulses(1 / static_cast<Real>(parts));
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
    joints.scaleImpulses(static_cast<Real>(parts));
    blocks_.noteTouching(tolerances.slop, crew);
    visits_ = blocks_.size() * static_cast<std::size_t>(substeps * 2) +
              settled * static_cast<std::size_t>(substeps * settling_);
}

} // namespace kodo::inline KODO_PRECISION
