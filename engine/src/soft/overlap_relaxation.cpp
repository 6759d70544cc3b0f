// SPDX-License-Identifier: MIT
#include "soft/overlap_relaxation.hpp"

#include "base/assert.hpp"

#include <algorithm>
#include <bit>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Mask of the lanes with a body that can be moved.
unsigned pushed(const BlockUse& use) {
    return use.movesA | use.movesB;
}

/// Calls work(lane, bodyA, bodyB) for the lanes of a mask. In place of a locked body, work gets the
/// other one.
template <typename Work>
void forPairs(const ContactBlock& block, const BlockUse& use, unsigned lanes, Work work) {
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::uint8_t>(std::countr_zero(lanes));
        KODO_ASSERT((pushed(use) >> lane & 1) != 0);
        const std::uint32_t a = bodyOfPlace(block.a[lane]);
        const std::uint32_t b = bodyOfPlace(block.b[lane]);
        work(lane, (use.movesA >> lane & 1) != 0 ? a : b, (use.movesB >> lane & 1) != 0 ? b : a);
    }
}

unsigned deeperLanes(const ContactBlock& block, Real separation) {
    unsigned lanes = 0;
    for (unsigned lane = 0; lane < ContactBlock::kContacts; ++lane) {
        const Real own = block.points[0].separation[lane]; // the deepest point
        lanes |= (own < separation ? 1u : 0u) << lane;
    }
    return lanes;
}

/// Sets the normal impulses of a contact back, and the velocities of its bodies accordingly.
void takeBack(ContactBlock& block, std::size_t lane, const std::array<Real, 2>& before,
              BodyVelocity* motion) {
    BodyVelocity& a = motion[bodyOfPlace(block.a[lane])];
    BodyVelocity& b = motion[bodyOfPlace(block.b[lane])];
    const Vec2 normal{block.normalX[lane], block.normalY[lane]};
    for (std::size_t i = 0; i < before.size(); ++i) {
        ContactBlock::Point& point = block.points[i];
        const Real change = before[i] - point.impulse[lane];
        point.impulse[lane] = before[i];
        if (!a.locked()) { // see applyImpulse()
            a.velocity -= a.invMass * change * normal;
            a.angularVelocity -= a.invInertia * change * point.leverA[lane];
        }
        if (!b.locked()) {
            b.velocity += b.invMass * change * normal;
            b.angularVelocity += b.invInertia * change * point.leverB[lane];
        }
    }
}

void copyPoint(const ContactBlock::Point& from, std::size_t lane, ContactBlock::Point& to,
               std::size_t toLane) {
    to.leverA[toLane] = from.leverA[lane];
    to.leverB[toLane] = from.leverB[lane];
    to.mass[toLane] = from.mass[lane];
    to.separation[toLane] = from.separation[lane];
}

} // namespace

/// Number of passes: two for one deep contact, and one more for each further one. A large crowd
/// shares the push speed and has many contacts, so fewer passes suffice.
int OverlapRelaxation::passesOf(const Cluster& cluster) {
    return std::min({1 + cluster.deepContacts, kMostPasses, 1 + kLargeCrowd / cluster.crowd});
}

void OverlapRelaxation::clear() {
    for (const std::uint32_t body : joined_) {
        sets_.drop(body);
    }
    joined_.clear();
    copied_.clear();
    pushes_.clear();
    crowded_.clear();
    blocks_.clear();
    use_.clear();
    parts_.clear();
    order_.clear();
    passes_ = 0;
    visits_ = 0;
}

void OverlapRelaxation::makeRoom(const Bodies& bodies) {
    sets_.reserve(bodies.record.capacity() + 1);
    sets_.resize(bodies.size() + 1);
    resizeByBody(clusters_, bodies);
}

void OverlapRelaxation::begin(std::size_t bodies) {
    clear();
    sets_.resize(bodies + 1);
    clusters_.resize(bodies);
    joined_.reserve(kBlocks * ContactBlock::kContacts);
    copied_.reserve(kBlocks * ContactBlock::kContacts);
    blocks_.reserve(kBlocks);
    use_.reserve(kBlocks);
    parts_.reserve(kBlocks);
}

/// Joins the clusters of two bodies that overlap deeply.
void OverlapRelaxation::join(std::uint32_t bodyA, std::uint32_t bodyB,
                             std::span<const std::uint16_t> crowd) {
    for (const std::uint32_t body : {bodyA, bodyB}) {
        if (!sets_.contains(body)) {
            sets_.makeSet(body);
            joined_.push_back(body);
            clusters_[body] = {0, std::max(1, int{crowd[body]})};
        }
    }
    const auto [root, other] = sets_.join(bodyA, bodyB);
    Cluster& cluster = clusters_[root];
    if (other != root) {
        cluster.deepContacts += clusters_[other].deepContacts;
        cluster.crowd = std::max(cluster.crowd, clusters_[other].crowd);
    }
    ++cluster.deepContacts;
}

void OverlapRelaxation::findClusters(const Contacts& contacts) {
    const ContactPassArguments& all = contacts.all;
    for (std::size_t k = 0; k < all.count; ++k) {
        const ContactBlock& block = all.blocks[all.order[k]];
        const BlockUse& use = all.use[all.order[k]];
        forPairs(
            block, use, deeperLanes(block, contacts.deepBelow) & pushed(use),
            [&](std::uint8_t, std::uint32_t a, std::uint32_t b) { join(a, b, contacts.crowd); });
    }
}

/// Mask of the lanes whose movable bodies are in clusters.
unsigned OverlapRelaxation::inClusters(const ContactBlock& block, const BlockUse& use) const {
    unsigned a = 0;
    unsigned b = 0;
    for (unsigned lane = 0; lane < ContactBlock::kContacts; ++lane) {
        a |= (sets_.contains(bodyOfPlace(block.a[lane])) ? 1u : 0u) << lane;
        b |= (sets_.contains(bodyOfPlace(block.b[lane])) ? 1u : 0u) << lane;
    }
    const unsigned movesA = use.movesA;
    const unsigned movesB = use.movesB;
    return (a | ~movesA) & (b | ~movesB) & pushed(use);
}

/// Calls work(lane, passes, in a crowd) for the contacts of a block within one cluster, and counts
/// their visits.
template <typename Work>
void OverlapRelaxation::forTogether(const ContactBlock& block, const BlockUse& use, Work work) {
    forPairs(block, use, inClusters(block, use),
             [&](std::uint8_t lane, std::uint32_t a, std::uint32_t b) {
                 const std::uint32_t root = sets_.rootOf(a);
                 if (root == sets_.rootOf(b)) {
                     const int passes = passesOf(clusters_[root]);
                     visits_ += static_cast<std::size_t>(passes);
                     work(lane, passes, isCrowd(clusters_[root]));
                 }
             });
}

void OverlapRelaxation::addPart(std::uint32_t block, bool isCopy, int passes) {
    parts_.push_back({block, isCopy, static_cast<std::uint8_t>(passes)});
    passes_ = std::max(passes_, passes);
}

/// Adds a block of copies. Its empty lanes refer to the spare body.
std::uint32_t OverlapRelaxation::openBlock(bool twoPoints, int passes) {
    const auto i = static_cast<std::uint32_t>(blocks_.size());
    ContactBlock& block = blocks_.emplace_back();
    const std::uint32_t spare = velocityOffset(static_cast<std::uint32_t>(clusters_.size()));
    std::fill_n(block.a, ContactBlock::kContacts, spare);
    std::fill_n(block.b, ContactBlock::kContacts, spare);
    use_.emplace_back().twoPoints = twoPoints;
    addPart(i, true, passes);
    return i;
}

/// Copies all that a pass does not change.
void OverlapRelaxation::copyLane(const ContactPassArguments& all, const Copied& copied) {
    const ContactBlock& from = all.blocks[copied.block];
    ContactBlock& to = blocks_[copied.copyBlock];
    const std::size_t lane = copied.lane;
    const std::size_t toLane = copied.copyLane;
    to.a[toLane] = from.a[lane];
    to.b[toLane] = from.b[lane];
    to.normalX[toLane] = from.normalX[lane];
    to.normalY[toLane] = from.normalY[lane];
    copyPoint(from.points[0], lane, to.points[0], toLane);
    copyPoint(from.points[1], lane, to.points[1], toLane);
    const auto moves = [&](std::uint8_t lanes) {
        return static_cast<std::uint8_t>((lanes >> lane & 1) << toLane);
    };
    use_[copied.copyBlock].movesA |= moves(all.use[copied.block].movesA);
    use_[copied.copyBlock].movesB |= moves(all.use[copied.block].movesB);
}

void OverlapRelaxation::copyLanes(const ContactPassArguments& all, std::uint32_t block,
                                  Open& open) {
    const BlockUse& use = all.use[block];
    forTogether(all.blocks[block], use, [&](std::uint8_t lane, int passes, bool crowd) {
        if (crowd) {
            pushes_.push_back({block, lane, {}});
        }
        std::uint32_t& at = open[use.twoPoints ? 1 : 0][static_cast<std::size_t>(passes)];
        if (at == kNone) {
            at = openBlock(use.twoPoints, passes);
        }
        const Copied copied{block, at, lane,
                            static_cast<std::uint8_t>(std::popcount(pushed(use_[at])))};
        copied_.push_back(copied);
        copyLane(all, copied);
        if (copied.copyLane + 1 == ContactBlock::kContacts) {
            at = kNone;
        }
    });
}

void OverlapRelaxation::find(const Contacts& contacts) {
    begin(contacts.crowd.size());
    findClusters(contacts);
    const ContactPassArguments& all = contacts.all;
    const std::uint32_t* next = all.order;
    for (const PassOrder::Colour& colour : contacts.colours) {
        Open open;
        for (auto& blocks : open) {
            blocks.fill(kNone);
        }
        for (const std::uint32_t* const end = next + colour.count; next != end; ++next) {
            if (colour.oneByOne) {
                int most = 0;
                forTogether(all.blocks[*next], all.use[*next],
                            [&](std::uint8_t lane, int passes, bool crowd) {
                                most = std::max(most, passes);
                                if (crowd) {
                                    pushes_.push_back({*next, lane, {}});
                                }
                            });
                if (most > 0) {
                    addPart(*next, false, most);
                }
            } else {
                copyLanes(all, *next, open);
            }
        }
    }
    KODO_ASSERT(next == all.order + all.count);
    for (const std::uint32_t body : joined_) {
        if (isCrowd(clusters_[sets_.rootOf(body)])) {
            crowded_.push_back(body);
        }
    }
    order_.reserve(parts_.capacity());
}

void OverlapRelaxation::notePushes(const ContactPassArguments& all) {
    for (Push& push : pushes_) {
        const ContactBlock& block = all.blocks[push.block];
        push.before = {block.points[0].impulse[push.lane], block.points[1].impulse[push.lane]};
    }
}

void OverlapRelaxation::takeBackPushes(const ContactPassArguments& all, Real h, Real pushSpeed) {
    velocities_.clear();
    angularVelocities_.clear();
    for (const std::uint32_t body : crowded_) {
        velocities_.push_back(all.motion[body].velocity);
        angularVelocities_.push_back(all.motion[body].angularVelocity);
    }
    for (const Push& push : pushes_) {
        ContactBlock& block = all.blocks[push.block];
        takeBack(block, push.lane, push.before, all.motion);
    }
    for (std::size_t k = 0; k < crowded_.size(); ++k) {
        BodyVelocity& motion = all.motion[crowded_[k]];
        const Vec2 pushed = velocities_[k] - motion.velocity;
        if (const Real speed = length(pushed); speed > pushSpeed) {
            const Real excess = h * (1 - pushSpeed / speed);
            motion.deltaPosition -= excess * pushed;
            motion.deltaAngle -= excess * (angularVelocities_[k] - motion.angularVelocity);
        }
    }
}

/// Runs one pass, on alternating runs of copies and original blocks.
void OverlapRelaxation::pass(const ContactPassArguments& all, int number) {
    for (auto part = parts_.begin(); part != parts_.end();) {
        const bool copies = part->isCopy;
        order_.clear();
        for (; part != parts_.end() && part->isCopy == copies; ++part) {
            if (number < part->passes) {
                order_.push_back(part->block);
            }
        }
        ContactPassArguments some = all;
        some.blocks = copies ? blocks_.data() : all.blocks;
        some.use = copies ? use_.data() : all.use;
        some.order = order_.data();
        some.count = order_.size();
        some.far = !copies && all.far;
        ContactPasses::best().relaxNormal(some);
    }
}

/// Calls work(original, copy) for the impulses of all copied contacts.
template <typename Work>
void OverlapRelaxation::forImpulses(const ContactPassArguments& all, Work work) {
    for (const Copied& copied : copied_) {
        for (int point = 0; point < 2; ++point) {
            work(all.blocks[copied.block].points[point].impulse[copied.lane],
                 blocks_[copied.copyBlock].points[point].impulse[copied.copyLane]);
        }
    }
}

void OverlapRelaxation::run(const ContactPassArguments& all) {
    forImpulses(all, [](Real own, Real& copy) { copy = own; });
    for (int number = 0; number < passes_; ++number) {
        pass(all, number);
    }
    forImpulses(all, [](Real& own, Real copy) { own = copy; });
}

} // namespace KODO_PRECISION
} // namespace kodo
