// SPDX-License-Identifier: MIT
// What becomes of broken blocks and of the things that leave the field.
#include <apart/core/field.hpp>
#include <apart/core/game.hpp>
#include <apart/core/governor.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

namespace {

// What is this far (m) outside the field has left it for good.
constexpr Real kGone = Real(1.5);

bool isGone(Vec2 place) {
    return place.y < -kGone || place.y > kFieldHeight + kGone ||
           place.x < -kFieldWidth / 2 - kGone || place.x > kFieldWidth / 2 + kGone;
}

/// Down for what stands still.
Vec2 headingOf(Vec2 velocity) {
    return length(velocity) < kHaltSpeed ? Vec2{0, -1} : normalize(velocity);
}

} // namespace

void Game::breakBlock(std::size_t index, Vec2 point, Vec2 blow) {
    const Block block = blocks_[index];
    const Vec2 center = world_[block.body].position();
    world_.remove(block.body);
    blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(index));
    --blocksLeft_;
    ++combo_;
    const std::int32_t worth = kPoints[static_cast<std::size_t>(block.kind.stuff)] +
                               (block.kind.power == Power::None ? 0 : kPowerPoints);
    const std::int32_t points = worth * std::min(combo_, kMostCombo);
    score_ += points;

    const std::size_t place = events_.size();
    events_.emplace_back(Broke{.block = block.body,
                               .stuff = block.kind.stuff,
                               .power = block.kind.power,
                               .point = point,
                               .center = center,
                               .impulse = length(blow),
                               .combo = combo_,
                               .points = points});
    std::get<Broke>(events_[place]).shards = addPieces(block, center, point, blow);
}

int Game::addPieces(const Block& block, Vec2 center, Vec2 point, Vec2 blow) {
    const Vec2 hit{std::clamp(point.x - center.x, -kCellWidth / 2, kCellWidth / 2),
                   std::clamp(point.y - center.y, -kCellHeight / 2, kCellHeight / 2)};
    const std::vector<Piece> pieces = piecesOf(block.kind, hit, mixKeys(seed_, block.key, 2));
    std::vector<kodo::Mass> masses;
    Real mass = 0;
    for (const Piece& piece : pieces) {
        masses.push_back(piece.mass);
        mass += piece.mass.mass;
    }
    const Vec2 impulse = impulseOnPieces(blow, block.strengthLeft, mass);
    const std::vector<PieceMotion> motions = motionOfPieces(masses, hit, impulse, kBurstSpeed);
    int shards = 0;
    int balls = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        Piece piece = pieces[i];
        if (piece.role == Role::Ball && balls_.size() >= kMostBalls) {
            piece.role = Role::Shard;
        }
        const BodyId body = world_.add(pieceDef(piece, motions[i], center));
        switch (piece.role) {
        case Role::Ball:
            balls_.push_back({body, headingOf(motions[i].velocity), false});
            ++balls;
            break;
        case Role::Part:
            parts_.push_back({body, block.kind.power, PartState::Loose, tick_, {}});
            events_.emplace_back(Released{body, block.kind.power, center});
            break;
        default:
            shards_.push_back({body, block.kind.stuff, tick_});
            ++shards;
            break;
        }
    }
    if (balls > 0) {
        events_.emplace_back(BallSplit{center, balls});
    }
    return shards;
}

void Game::knockOff(std::size_t weld) {
    // A new paddle, with all the parts but one.
    std::vector<kodo::Part> parts;
    for (std::size_t i = 0; i < world_[paddle_].partCount(); ++i) {
        parts.push_back(world_[paddle_].part(i));
    }
    const Vec2 place = world_[paddle_].position();
    const Real speed = world_[paddle_].velocity().x;
    world_.remove(paddle_);
    paddle_ = world_.add(paddleDef(place.x));
    for (std::size_t i = 1; i < parts.size(); ++i) {
        kodo::BodyDef def{
            .shape = std::visit([](const auto& p) -> kodo::Shape { return p; }, parts[i].primitive),
            .position = place,
            .material = kShardMaterial,
            .density = parts[i].density,
            .flags = flagsOf(Role::Shard) | kFalls};
        const BodyId body = world_.add(def);
        if (i - 1 != weld) {
            world_.weld(paddle_, body);
            continue;
        }
        const Vec2 away = normalize(world_[body].center() - place);
        world_[body].setVelocity(Vec2{speed, 0} + kKnockOffSpeed * away);
        shards_.push_back({body, Stuff::Steel, tick_});
        events_.emplace_back(
            KnockedOff{body, welds_[weld].lastPoint, welds_[weld].lastImpulse, weldedParts() - 1});
    }
    world_[paddle_].setMaterial(kPaddleMaterial);
    world_[paddle_].setVelocity({speed, 0});
    welds_.erase(welds_.begin() + static_cast<std::ptrdiff_t>(weld));
}

void Game::govern() {
    std::vector<Vec2> normals; // towards the ball
    for (Ball& ball : balls_) {
        if (ball.riding) {
            continue;
        }
        normals.clear();
        bool touching = false; // also where it leaves an overlap, faster than what pushed it
        bool rubble = false;
        for (const kodo::CollisionRecord& hit : world_.collisions()) {
            if (!hit.involves(ball.body)) {
                continue;
            }
            touching = touching || hit.maxImpulse > 0 || hit.separation < 0;
            if (hit.maxImpulse > 0) {
                normals.push_back(hit.b == ball.body ? hit.normal : -hit.normal);
                rubble = rubble || isRubble(hit.other(ball.body));
            }
        }
        kodo::BodyRef body = world_[ball.body];
        const Vec2 velocity = body.velocity();
        Vec2 next = velocity;
        if (!touching) {
            next = held(velocity, ball.heading, ballSpeed());
        } else if (!normals.empty()) {
            next = rubble ? throwOff(velocity, ball.heading, normals, ballSpeed()) : velocity;
            next = turnedFromFlat(next, normals);
        }
        if (next != velocity) {
            body.setVelocity(next);
        }
        if (length(next) >= kHaltSpeed) {
            ball.heading = normalize(next);
        }
    }
}

bool Game::isRubble(BodyId body) const {
    if (!world_.contains(body)) {
        return false;
    }
    const Role role = roleOf(world_[body].flags());
    return role == Role::Shard || role == Role::Part;
}

void Game::sweepOut() {
    sweepBalls();
    sweepParts();
    sweepShards();
}

void Game::sweepBalls() {
    for (std::size_t i = 0; i < balls_.size();) {
        const Vec2 place = world_[balls_[i].body].position();
        if (!isGone(place)) {
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

void Game::sweepParts() {
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
        world_.remove(part.body);
        parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

void Game::sweepShards() {
    const auto drop = [&](std::size_t i) {
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
    // Too many: the light and the old go first.
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
            body.setFlags(flagsOf(Role::Part) | kFalls);
            body.setMaterial(kShardMaterial);
        }
    }
}

} // namespace apart
