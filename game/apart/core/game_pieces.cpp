// SPDX-License-Identifier: MIT
// Pieces of broken blocks, and removal of bodies that left the field or expired.
#include <apart/core/field.hpp>
#include <apart/core/game.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

namespace {

/// Direction of the velocity; down below kHaltSpeed.
Vec2 headingOf(Vec2 velocity) {
    return length(velocity) < kHaltSpeed ? Vec2{0, -1} : normalize(velocity);
}

double energyOf(const kodo::Mass& mass, const PieceMotion& motion) {
    return static_cast<double>(
        (mass.mass * lengthSquared(motion.velocity) + mass.inertia * motion.spin * motion.spin) /
        2);
}

/// Angular momentum (N m s) about the origin, of a body with its centre of mass at `center` (m).
double turnOf(const kodo::Mass& mass, const PieceMotion& motion, Vec2 center) {
    return static_cast<double>(mass.mass * cross(center, motion.velocity) +
                               mass.inertia * motion.spin);
}

} // namespace

void Game::breakBlock(std::size_t index, Vec2 point, Vec2 impact) {
    const BodyId body = detach(index);
    const Block block = blocks_[index];
    const kodo::Transform frame = frameOf(block);
    const PieceMotion carried{world_[body].velocity(), world_[body].angularVelocity()};
    const kodo::Mass weight{world_[body].mass(), {}, world_[body].inertia()};
    const kodo::Shape shape = shapeOfBlock(world_[body], block.part, block.ownsBody());
    world_.remove(body);
    if (world_.contains(block.pin)) {
        world_.remove(block.pin);
    }
    blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(index));
    std::int32_t points = 0;
    if (block.support == Support::Standing && block.counts()) {
        points = addToCollapse(block, frame.position);
        --blocksLeft_;
        ++combo_;
    } else if (block.counts()) {
        --blocksLeft_;
        ++combo_;
        points = pointsOf(block.kind) * std::min(combo_, kMostCombo);
        score_ += points;
    }
    const std::size_t place = events_.size();
    events_.emplace_back(Broke{.block = body,
                               .key = block.key,
                               .stuff = block.kind.stuff,
                               .power = block.kind.power,
                               .point = point,
                               .center = frame.position,
                               .impulse = length(impact),
                               .combo = combo_,
                               .points = points});
    const Vec2 local = toLocal(frame, point);
    const kodo::Aabb extent = extentOf(shape);
    const Vec2 hit{std::clamp(local.x, extent.lower.x, extent.upper.x),
                   std::clamp(local.y, extent.lower.y, extent.upper.y)};
    // The velocity of a dynamic block already contains the whole impulse.
    const bool mounted = block.support == Support::Mounted || block.support == Support::Boss;
    const Vec2 taken = mounted ? unrotate(frame.rotation, impact) : Vec2{};
    ledger_.breakWork -= energyOf(weight, carried);
    ledger_.mountTurn += turnOf(weight, carried, frame.position);
    std::get<Broke>(events_[place]).shards = addPieces(block, shape, {frame, carried}, hit, taken);
}

int Game::addPieces(const Block& block, const kodo::Shape& shape, const Carried& before, Vec2 hit,
                    Vec2 impact) {
    const kodo::Transform& frame = before.frame;
    const PieceMotion& carried = before.motion;
    const std::vector<Piece> pieces =
        piecesOf(block.kind, shape, hit, mixKeys(seed_, block.key, 2));
    const bool rubble = block.support == Support::Fallen;
    const std::uint32_t born = rubble ? tick_ + kRubbleTicks - kShardTicks : tick_;
    std::vector<kodo::Mass> masses;
    kodo::Mass whole{};
    for (const Piece& piece : pieces) {
        masses.push_back(piece.mass);
        whole = masses.size() == 1 ? piece.mass : combine(whole, piece.mass);
    }
    const Vec2 impulse = impulseOnPieces(impact, block.strengthLeft, whole.mass);
    std::vector<PieceMotion> motions = motionOfPieces(masses, hit, impulse, kBurstSpeed);
    const Vec2 borne = frame.rotation * (impact - impulse);
    ledger_.mountImpulseX += static_cast<double>(borne.x);
    ledger_.mountImpulseY += static_cast<double>(borne.y);
    ledger_.mountTurn += static_cast<double>(cross(frame * hit, borne)) -
                         turnOf(whole, carried, frame * whole.center);
    int shards = 0;
    int balls = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        PieceMotion& motion = motions[i];
        const Vec2 arm = frame.rotation * masses[i].center;
        const Vec2 off = arm - frame.rotation * whole.center;
        motion.velocity =
            frame.rotation * motion.velocity + carried.velocity + cross(carried.spin, off);
        motion.spin += carried.spin;
        ledger_.breakWork += energyOf(masses[i], motion);
        Piece piece = pieces[i];
        if (piece.role == Role::Ball && balls_.size() >= kMostBalls) {
            piece.role = Role::Shard;
        }
        if (piece.role == Role::Ball) {
            const BodyId ball = addBall(world_, frame.position + arm, ballKind());
            world_[ball].setVelocity(motion.velocity);
            world_[ball].setAngularVelocity(motion.spin);
            balls_.push_back({ball, headingOf(motion.velocity), false, ballKind()});
            ++balls;
            continue;
        }
        const BodyId body = world_.add(pieceDef(piece, motion, frame));
        if (piece.role == Role::Part) {
            parts_.push_back({body, block.kind.power, PartState::Loose, tick_, {}, frame.position});
            events_.emplace_back(Released{body, block.kind.power, frame.position});
        } else {
            const Real strength = shardStrength(block.kind.stuff, world_[body].area());
            shards_.push_back({body, block.kind.stuff, born, strength});
            ++shards;
        }
    }
    if (balls > 0) {
        events_.emplace_back(BallSplit{frame.position, balls});
    }
    return shards;
}

void Game::breakShard(std::size_t index, Vec2 point, Real impulse) {
    const Shard shard = shards_[index];
    const kodo::BodyView body = world_[shard.body];
    const kodo::Part& whole = body.part(0);
    const auto* polygon = std::get_if<kodo::Polygon>(&whole.primitive);
    if (polygon == nullptr) {
        return;
    }
    const kodo::Transform frame{body.position(), body.rotation()};
    std::vector<kodo::Polygon> pieces =
        fracture(*polygon, toLocal(frame, point), Pattern::Halves, shardLimits(),
                 mixKeys(seed_, tick_, shard.body.index));
    if (pieces.size() < 2) {
        shards_[index].strengthLeft = std::numeric_limits<Real>::max(); // too small to break
        return;
    }
    kodo::BodyDef def{.position = frame.position,
                      .rotation = frame.rotation,
                      .angularVelocity = body.angularVelocity(),
                      .material = kShardMaterial,
                      .density = whole.density,
                      .flags = flagsOf(Role::Shard) | kFalls};
    events_.emplace_back(ShardBroke{.shard = shard.body,
                                    .stuff = shard.stuff,
                                    .point = point,
                                    .impulse = impulse,
                                    .pieces = static_cast<int>(pieces.size())});
    std::vector<Vec2> velocities; // m/s, of the whole at the centres of the pieces
    for (const kodo::Polygon& piece : pieces) {
        velocities.push_back(body.velocityAt(frame * massOf(piece, Real(1)).center));
    }
    world_.remove(shard.body);
    shards_.erase(shards_.begin() + static_cast<std::ptrdiff_t>(index));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Real strength = shardStrength(shard.stuff, areaOf(pieces[i]));
        def.velocity = velocities[i];
        def.shape = std::move(pieces[i]);
        shards_.push_back({world_.add(def), shard.stuff, shard.bornTick, strength});
    }
}

void Game::removeGone() {
    removeGoneBalls();
    removeGoneBlocks();
    removeGoneParts();
    removeGoneShards();
}

void Game::removeGoneBalls() {
    for (std::size_t i = 0; i < balls_.size();) {
        const Vec2 place = world_[balls_[i].body].position();
        if (place.y >= -kLostDepth && !isGone(place)) {
            ++i;
            continue;
        }
        world_.remove(balls_[i].body);
        balls_.erase(balls_.begin() + static_cast<std::ptrdiff_t>(i));
        if (result_ == Result::Playing) {
            events_.emplace_back(BallLost{place, static_cast<int>(balls_.size())});
        }
    }
}

void Game::removeGoneParts() {
    for (std::size_t i = 0; i < parts_.size();) {
        const Part& part = parts_[i];
        const Vec2 place = world_[part.body].center();
        const bool old = part.state == PartState::Loose && tick_ - part.sinceTick > kPartTicks;
        if (!old && !isGone(place)) {
            ++i;
            continue;
        }
        if (part.state == PartState::Launched) {
            events_.emplace_back(Spent{place, false});
        }
        ledger_.removedMass += static_cast<double>(world_[part.body].mass());
        world_.remove(part.body);
        parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

void Game::removeGoneShards() {
    const auto drop = [&](std::size_t i) {
        ledger_.removedMass += static_cast<double>(world_[shards_[i].body].mass());
        world_.remove(shards_[i].body);
        shards_.erase(shards_.begin() + static_cast<std::ptrdiff_t>(i));
    };
    std::vector<BodyId> crushed;
    for (const kodo::CollisionRecord& hit : world_.collisions()) {
        if (hit.separation < -kCrushed) {
            crushed.insert(crushed.end(), {hit.a, hit.b});
        }
    }
    for (std::size_t i = 0; i < shards_.size();) {
        const BodyId body = shards_[i].body;
        const bool old = tick_ - shards_[i].bornTick > kShardTicks;
        const bool dust = std::find(crushed.begin(), crushed.end(), body) != crushed.end();
        if (old || dust || isGone(world_[body].center())) {
            drop(i);
        } else {
            ++i;
        }
    }
    // Above the limit, the shard with the least mass times remaining ticks is removed first.
    while (shards_.size() > kMostShards) {
        std::size_t least = 0;
        Real leastWorth = 0;
        for (std::size_t i = 0; i < shards_.size(); ++i) {
            const std::uint32_t left = kShardTicks - (tick_ - shards_[i].bornTick);
            const Real worth = world_[shards_[i].body].mass() * static_cast<Real>(left);
            if (i == 0 || worth < leastWorth) {
                least = i;
                leastWorth = worth;
            }
        }
        drop(least);
    }
}

void Game::letGoOfParts() {
    for (Part& part : parts_) {
        if (part.state == PartState::Stuck) {
            part.state = PartState::Loose;
            part.sinceTick = tick_;
            kodo::BodyRef body = world_[part.body];
            body.setType(kodo::BodyType::Dynamic);
            body.setFlags(flagsOf(Role::Part) | kFalls);
            body.setMaterial(kShardMaterial);
        }
    }
}

} // namespace apart
