// SPDX-License-Identifier: MIT
// Pieces of broken blocks, and removal of bodies that left the field or expired.
#include <apart/core/field.hpp>
#include <apart/core/game_rules.hpp>
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

/// A block at the moment it breaks.
struct Carried {
    kodo::Transform frame;
    PieceMotion motion;
    Vec2 hit;    // m, in the frame of the block
    Vec2 impact; // N s, likewise
};

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

/// A block of a building that is down crumbles: it makes few pieces.
BlockKind kindNow(const GameState& game, const Block& block) {
    BlockKind kind = block.kind;
    kind.pattern = game.counts.isDown() ? Pattern::Halves : kind.pattern;
    return kind;
}

} // namespace

static int addPieces(GameState& game, const Block& block, const kodo::Shape& shape,
                     const Carried& before);
static std::int32_t countBroken(GameState& game, const Block& block, Vec2 place);
static void removeGoneBalls(GameState& game);
static void removeGoneParts(GameState& game);
static void removeGoneShards(GameState& game);

void breakBlock(GameState& game, std::size_t index, Vec2 point, Vec2 impact) {
    const BodyId body = detach(game, index);
    land(game, game.blocks[index]);
    const Block block = game.blocks[index];
    const kodo::Transform frame = game.frameOf(block);
    const PieceMotion carried{game.world[body].velocity(), game.world[body].angularVelocity()};
    const kodo::Mass weight{game.world[body].mass(), {}, game.world[body].inertia()};
    const kodo::Shape shape = shapeOfBlock(game.world[body], block.part, block.ownsBody());
    game.world.remove(body);
    if (game.world.contains(block.pin)) {
        game.world.remove(block.pin);
    }
    game.blocks.erase(game.blocks.begin() + static_cast<std::ptrdiff_t>(index));
    const std::int32_t points = block.counts() ? countBroken(game, block, frame.position) : 0;
    game.counts.score += points;
    const std::size_t place = game.events.size();
    game.events.emplace_back(Broke{.block = body,
                                   .key = block.key,
                                   .stuff = block.kind.stuff,
                                   .power = block.kind.power,
                                   .point = point,
                                   .center = frame.position,
                                   .impulse = length(impact),
                                   .combo = game.counts.combo,
                                   .points = points});
    const Vec2 local = toLocal(frame, point);
    const kodo::Aabb extent = extentOf(shape);
    const Vec2 hit{std::clamp(local.x, extent.lower.x, extent.upper.x),
                   std::clamp(local.y, extent.lower.y, extent.upper.y)};
    // The velocity of a dynamic block already contains the whole impulse.
    const bool mounted = block.support == Support::Mounted || block.support == Support::Boss;
    const Vec2 taken = mounted ? unrotate(frame.rotation, impact) : Vec2{};
    game.ledger.breakWork -= energyOf(weight, carried);
    game.ledger.mountTurn += turnOf(weight, carried, frame.position);
    std::get<Broke>(game.events[place]).shards =
        addPieces(game, block, shape, {frame, carried, hit, taken});
}

/// Counts a block that broke as cleared. Returns its points.
std::int32_t countBroken(GameState& game, const Block& block, Vec2 place) {
    --game.counts.blocksLeft;
    if (game.counts.hits == 0) {
        return 0; // before the first serve
    }
    if (block.support == Support::Standing) {
        const std::int32_t points = addToCollapse(game, block);
        ++game.buildings.collapse.landed;
        game.buildings.collapse.sum += place;
        ++game.counts.combo;
        return points;
    }
    ++game.counts.combo;
    return pointsOf(block.kind) *
           (game.counts.isDown() ? 1 : std::min(game.counts.combo, kMostCombo));
}

int addPieces(GameState& game, const Block& block, const kodo::Shape& shape,
              const Carried& before) {
    const Vec2 impact = before.impact;
    const kodo::Transform& frame = before.frame;
    const PieceMotion& carried = before.motion;
    const std::vector<Piece> pieces =
        piecesOf(kindNow(game, block), shape, before.hit, mixKeys(game.origin.seed, block.key, 2));
    const bool rubble = block.support == Support::Fallen || game.counts.isDown();
    const std::uint32_t born = rubble ? game.tick + kRubbleTicks - kShardTicks : game.tick;
    std::vector<kodo::Mass> masses;
    kodo::Mass whole{};
    for (const Piece& piece : pieces) {
        masses.push_back(piece.mass);
        whole = masses.size() == 1 ? piece.mass : combine(whole, piece.mass);
    }
    const Vec2 impulse = impulseOnPieces(impact, block.strengthLeft, whole.mass);
    std::vector<PieceMotion> motions = motionOfPieces(masses, before.hit, impulse, kBurstSpeed);
    const Vec2 borne = frame.rotation * (impact - impulse);
    game.ledger.mountImpulseX += static_cast<double>(borne.x);
    game.ledger.mountImpulseY += static_cast<double>(borne.y);
    game.ledger.mountTurn += static_cast<double>(cross(frame * before.hit, borne)) -
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
        game.ledger.breakWork += energyOf(masses[i], motion);
        Piece piece = pieces[i];
        if (piece.role == Role::Ball && game.balls.size() >= kMostBalls) {
            piece.role = Role::Shard;
        }
        if (piece.role == Role::Ball) {
            const BodyId ball = addBall(game.world, frame.position + arm, game.ballKind());
            game.world[ball].setVelocity(motion.velocity);
            game.world[ball].setAngularVelocity(motion.spin);
            game.balls.push_back({ball, headingOf(motion.velocity), false, false, game.ballKind()});
            ++balls;
            continue;
        }
        const BodyId body = game.world.add(pieceDef(piece, motion, frame));
        if (piece.role == Role::Part) {
            game.parts.push_back(
                {body, block.kind.power, PartState::Loose, game.tick, {}, frame.position});
            game.events.emplace_back(Released{body, block.kind.power, frame.position});
        } else {
            const Real strength = shardStrength(block.kind.stuff, game.world[body].area());
            game.shards.push_back({body, block.kind.stuff, born, strength});
            ++shards;
        }
    }
    if (balls > 0) {
        game.events.emplace_back(BallSplit{frame.position, balls});
    }
    return shards;
}

void breakShard(GameState& game, std::size_t index, Vec2 point, Real impulse) {
    const Shard shard = game.shards[index];
    const kodo::BodyView body = game.world[shard.body];
    const kodo::Part& whole = body.part(0);
    const auto* polygon = std::get_if<kodo::Polygon>(&whole.primitive);
    if (polygon == nullptr) {
        return;
    }
    const kodo::Transform frame{body.position(), body.rotation()};
    std::vector<kodo::Polygon> pieces =
        fracture(*polygon, toLocal(frame, point), Pattern::Halves, shardLimits(),
                 mixKeys(game.origin.seed, game.tick, shard.body.index));
    if (pieces.size() < 2) {
        game.shards[index].strengthLeft = std::numeric_limits<Real>::max(); // too small to break
        return;
    }
    kodo::BodyDef def{.position = frame.position,
                      .rotation = frame.rotation,
                      .angularVelocity = body.angularVelocity(),
                      .material = kShardMaterial,
                      .density = whole.density,
                      .flags = flagsOf(Role::Shard) | kFalls};
    game.events.emplace_back(ShardBroke{.shard = shard.body,
                                        .stuff = shard.stuff,
                                        .point = point,
                                        .impulse = impulse,
                                        .pieces = static_cast<int>(pieces.size())});
    std::vector<Vec2> velocities; // m/s, of the whole at the centres of the pieces
    for (const kodo::Polygon& piece : pieces) {
        velocities.push_back(body.velocityAt(frame * massOf(piece, Real(1)).center));
    }
    game.world.remove(shard.body);
    game.shards.erase(game.shards.begin() + static_cast<std::ptrdiff_t>(index));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Real strength = shardStrength(shard.stuff, areaOf(pieces[i]));
        def.velocity = velocities[i];
        def.shape = std::move(pieces[i]);
        game.shards.push_back({game.world.add(def), shard.stuff, shard.bornTick, strength});
    }
}

void removeGone(GameState& game) {
    removeGoneBalls(game);
    removeGoneBlocks(game);
    removeGoneParts(game);
    removeGoneShards(game);
    forgetLinks(game);
}

void removeGoneBalls(GameState& game) {
    for (std::size_t i = 0; i < game.balls.size();) {
        const Vec2 place = game.world[game.balls[i].body].position();
        if (place.y >= -kLostDepth && !isGone(place)) {
            ++i;
            continue;
        }
        game.world.remove(game.balls[i].body);
        game.balls.erase(game.balls.begin() + static_cast<std::ptrdiff_t>(i));
        if (game.result == Result::Playing) {
            game.events.emplace_back(BallLost{place, static_cast<int>(game.balls.size())});
        }
    }
}

void removeGoneParts(GameState& game) {
    for (std::size_t i = 0; i < game.parts.size();) {
        const Part& part = game.parts[i];
        const Vec2 place = game.world[part.body].center();
        const bool old = part.state == PartState::Loose && game.tick - part.sinceTick > kPartTicks;
        if (!old && !isGone(place)) {
            ++i;
            continue;
        }
        if (part.state == PartState::Launched) {
            game.events.emplace_back(Spent{place, false});
        }
        game.ledger.removedMass += static_cast<double>(game.world[part.body].mass());
        game.world.remove(part.body);
        game.parts.erase(game.parts.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

void removeGoneShards(GameState& game) {
    const auto drop = [&](std::size_t i) {
        game.ledger.removedMass += static_cast<double>(game.world[game.shards[i].body].mass());
        game.world.remove(game.shards[i].body);
        game.shards.erase(game.shards.begin() + static_cast<std::ptrdiff_t>(i));
    };
    std::vector<BodyId> crushed;
    for (const kodo::CollisionRecord& hit : game.world.collisions()) {
        if (hit.separation < -kCrushed) {
            crushed.insert(crushed.end(), {hit.a, hit.b});
        }
    }
    for (std::size_t i = 0; i < game.shards.size();) {
        const BodyId body = game.shards[i].body;
        const bool old = game.tick - game.shards[i].bornTick > kShardTicks;
        const bool dust = std::find(crushed.begin(), crushed.end(), body) != crushed.end();
        if (old || dust || isGone(game.world[body].center())) {
            drop(i);
        } else {
            ++i;
        }
    }
    // Above the limit, the shard with the least mass times remaining ticks is removed first.
    while (game.shards.size() > kMostShards) {
        std::size_t least = 0;
        Real leastWorth = 0;
        for (std::size_t i = 0; i < game.shards.size(); ++i) {
            const std::uint32_t left = kShardTicks - (game.tick - game.shards[i].bornTick);
            const Real worth = game.world[game.shards[i].body].mass() * static_cast<Real>(left);
            if (i == 0 || worth < leastWorth) {
                least = i;
                leastWorth = worth;
            }
        }
        drop(least);
    }
}

} // namespace apart
