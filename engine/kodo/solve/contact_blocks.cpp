// SPDX-License-Identifier: MIT
#include <kodo/base/refill.hpp>
#include <kodo/solve/contact_blocks.hpp>

#include <algorithm>
#include <bit>
#include <limits>

namespace kodo::inline KODO_PRECISION {
namespace {

// So many bodies may overlap one deeply before their pushes are shared out: no more fit around it.
constexpr int kNeighbours = 7;

Real effectiveMass(const Motion& a, const Motion& b, Real leverA, Real leverB) {
    const Real k =
        a.invMass + b.invMass + a.invInertia * leverA * leverA + b.invInertia * leverB * leverB;
    return k > 0 ? 1 / k : 0; // 0: neither can give way
}

struct PointValues {
    Real leverA = 0;
    Real leverB = 0;
    Real mass = 0;
    Real separation = 0;
    Real impulse = 0;
};

void writePoint(ContactBlock::Point& point, std::size_t lane, const PointValues& values) {
    point.leverA[lane] = values.leverA;
    point.leverB[lane] = values.leverB;
    point.mass[lane] = values.mass;
    point.separation[lane] = values.separation;
    point.impulse[lane] = values.impulse;
    point.largest[lane] = 0;
}

bool immovable(const Motion& motion) {
    return motion.invMass == 0 && motion.invInertia == 0;
}

} // namespace

void ContactBlocks::clear(const Bodies& bodies) {
    if (!rows_.empty()) {
        counts_.fill(0);
    }
    rows_.clear();
    colours_.resize(bodies.size());
    for (const std::uint32_t body : bodies.awake) {
        colours_[body] = 0;
    }
}

void ContactBlocks::add(const Bodies& bodies, const Contact& contact, std::uint32_t place) {
    const std::uint32_t a = contact.key.bodyA;
    const std::uint32_t b = contact.key.bodyB;
    const Motion& motionA = bodies.motion[a];
    const Motion& motionB = bodies.motion[b];
    const bool onLocked = motionA.invMass == 0 || motionB.invMass == 0;
    constexpr std::uint64_t kFree = (std::uint64_t{1} << kFreeColours) - 1;
    const std::uint64_t taken = (immovable(motionA) ? 0 : colours_[a]) |
                                (immovable(motionB) ? 0 : colours_[b]) |
                                (onLocked ? kFree : ~kFree);
    std::uint32_t group = static_cast<std::uint32_t>(std::countr_one(taken));
    if (group < kColours) {
        colours_[a] |= std::uint64_t{1} << group;
        colours_[b] |= std::uint64_t{1} << group;
        group += onLocked ? 1 : 0;
    } else {
        group = onLocked ? kGroups - 1 : kFreeColours;
    }
    rows_.push_back({place, 2 * group + (contact.manifold.count == 2 ? 1u : 0u)});
    ++counts_[rows_.back().slot];
}

/// Turns groups into slots. A colour starts a new block; those without one get a block each.
void ContactBlocks::placeRows(std::span<const Contact> contacts) {
    std::array<std::uint32_t, 2 * kGroups> next;
    std::uint32_t slot = 0;
    for (std::size_t group = 0; group < kGroups; ++group) {
        const bool single = group == kFreeColours || group == kGroups - 1;
        const std::uint32_t each = single ? ContactBlock::kContacts : 1;
        for (const std::size_t points : {2 * group, 2 * group + 1}) {
            next[points] = slot;
            slot += each * counts_[points];
        }
        slot = (slot + ContactBlock::kContacts - 1) / ContactBlock::kContacts *
               ContactBlock::kContacts;
    }
    const std::size_t blocks = slot / ContactBlock::kContacts;
    // For as many as the rows there is room for may need, in the colours of a pile.
    constexpr std::size_t kColoursOfPile = 16;
    blocks_.reserve(rows_.capacity() / ContactBlock::kContacts + kColoursOfPile);
    use_.reserve(blocks_.capacity());
    blocks_.resize(blocks);
    refill(use_, blocks, BlockUse{});
    for (Row& row : rows_) {
        const std::uint32_t group = row.slot / 2;
        const bool single = group == kFreeColours || group == kGroups - 1;
        std::uint32_t& place = next[row.slot];
        row.slot = place;
        place += single ? ContactBlock::kContacts : 1;
        BlockUse& use = use_[row.slot / ContactBlock::kContacts];
        use.twoPoints = use.twoPoints || contacts[row.contact].manifold.count == 2;
        use.onLocked = group > kFreeColours;
        ++use.contacts;
    }
}

void ContactBlocks::arrange(const Bodies& bodies, std::span<const Contact> contacts,
                            std::span<const std::uint16_t> crowd, Real pushSpeed, bool rolling) {
    rolling_.clear();
    if (rows_.empty()) {
        blocks_.clear();
        return;
    }
    placeRows(contacts);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (use_[i].contacts < ContactBlock::kContacts) {
            blocks_[i] = {};
            std::fill_n(blocks_[i].a, ContactBlock::kContacts, bodies.spare());
            std::fill_n(blocks_[i].b, ContactBlock::kContacts, bodies.spare());
        }
    }
    for (const Row& row : rows_) {
        const Contact& contact = contacts[row.contact];
        const int crowded = std::max(crowd[contact.key.bodyA], crowd[contact.key.bodyB]);
        fill(bodies, contact, row.slot,
             pushSpeed / static_cast<Real>(std::max(1, crowded - kNeighbours)));
        if (rolling) {
            addRolling(bodies, contact, row.slot);
        }
    }
}

void ContactBlocks::fill(const Bodies& bodies, const Contact& contact, std::uint32_t slot,
                         Real pushSpeed) {
    ContactBlock& block = blocks_[slot / ContactBlock::kContacts];
    const std::size_t lane = slot % ContactBlock::kContacts;
    const Motion& a = bodies.motion[contact.key.bodyA];
    const Motion& b = bodies.motion[contact.key.bodyB];
    const Manifold& manifold = contact.manifold;
    const Vec2 n = manifold.normal;
    block.a[lane] = contact.key.bodyA;
    block.b[lane] = contact.key.bodyB;
    block.normalX[lane] = n.x;
    block.normalY[lane] = n.y;
    const auto setPoint = [&](std::size_t i) {
        const ManifoldPoint& p = manifold.points[i];
        if (isBlocked(a, p.armA, b, p.armB, n)) {
            writePoint(block.points[i], lane, {.separation = p.separation});
            return;
        }
        const Real leverA = cross(p.armA, n);
        const Real leverB = cross(p.armB, n);
        writePoint(block.points[i], lane,
                   {leverA, leverB, effectiveMass(a, b, leverA, leverB), p.separation,
                    contact.impulse[i].normal});
    };
    setPoint(0);
    Vec2 meanA = manifold.points[0].armA;
    Vec2 meanB = manifold.points[0].armB;
    if (manifold.count == 2) {
        setPoint(1);
        meanA = Real(0.5) * (meanA + manifold.points[1].armA);
        meanB = Real(0.5) * (meanB + manifold.points[1].armB);
    } else {
        writePoint(block.points[1], lane, {});
    }
    block.tangentLeverA[lane] = cross(meanA, perp(n));
    block.tangentLeverB[lane] = cross(meanB, perp(n));
    block.tangentMass[lane] =
        effectiveMass(a, b, block.tangentLeverA[lane], block.tangentLeverB[lane]);
    block.friction[lane] = contact.friction;
    block.staticFriction[lane] = contact.material.staticFriction;
    block.kineticFriction[lane] = contact.material.kineticFriction;
    block.pushSpeed[lane] = pushSpeed;
    block.total[lane] = 0;
}

/// A rolling body is braked with a torque of at most resistance * radius * normal force, where the
/// radius is the distance from its centre to the contact [Thesis06, 4.3.3].
void ContactBlocks::addRolling(const Bodies& bodies, const Contact& contact, std::uint32_t slot) {
    const Motion& a = bodies.motion[contact.key.bodyA];
    const Motion& b = bodies.motion[contact.key.bodyB];
    const Real freedom = a.invInertia + b.invInertia;
    if (contact.material.rollingResistance == 0 || freedom == 0) {
        return;
    }
    std::int32_t& place = use_[slot / ContactBlock::kContacts].rolling;
    if (place < 0) {
        place = static_cast<std::int32_t>(rolling_.size());
        rolling_.emplace_back();
    }
    RollingBlock& block = rolling_[static_cast<std::size_t>(place)];
    const std::size_t lane = slot % ContactBlock::kContacts;
    const ManifoldPoint& p = contact.manifold.points[0];
    const Real radiusA = a.invInertia > 0 ? length(p.armA) : std::numeric_limits<Real>::max();
    const Real radiusB = b.invInertia > 0 ? length(p.armB) : std::numeric_limits<Real>::max();
    block.lever[lane] = contact.material.rollingResistance * std::min(radiusA, radiusB);
    block.mass[lane] = 1 / freedom;
    block.impulse[lane] = contact.rolling;
}

ContactPassArguments ContactBlocks::pass(Bodies& bodies, const PassSettings& settings) {
    return {blocks_.data(), rolling_.data(),      use_.data(),
            blocks_.size(), bodies.motion.data(), settings};
}

void ContactBlocks::store(std::span<Contact> contacts) const {
    for (const Row& row : rows_) {
        Contact& contact = contacts[row.contact];
        const ContactBlock& block = blocks_[row.slot / ContactBlock::kContacts];
        const std::size_t lane = row.slot % ContactBlock::kContacts;
        for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
            contact.impulse[i].normal = block.points[i].impulse[lane];
            contact.impulse[i].largest = block.points[i].largest[lane];
        }
        contact.carried = true;
        contact.friction = block.friction[lane];
        contact.total = block.total[lane];
        const std::int32_t rolling = use_[row.slot / ContactBlock::kContacts].rolling;
        contact.rolling =
            rolling < 0 ? Real(0) : rolling_[static_cast<std::size_t>(rolling)].impulse[lane];
    }
}

} // namespace kodo::inline KODO_PRECISION
