// SPDX-License-Identifier: MIT
#include <worlds/judges.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace worlds {

using namespace kodo;

namespace {

/// True for a body that causes no records itself. One that is locked, or locked without rotation,
/// is as good as static: its contact with a sleeping body sleeps too.
bool isStill(const World& world, BodyId id) {
    if (!world.contains(id)) {
        return false;
    }
    const Flags locks =
        world.settings().has(Feature::Rotation) ? kLockMove | kLockRotate : kLockMove;
    const Flags flags = world[id].flags();
    return (flags & (kAsleep | kOutside | kFrozen)) != 0 || (flags & locks) == locks ||
           world[id].type() != BodyType::Dynamic;
}

std::string pairText(const char* what, BodyId a, BodyId b) {
    std::ostringstream text;
    text << "bodies " << a.index << " and " << b.index << ": " << what;
    return text.str();
}

} // namespace

std::optional<std::string> TouchJudge::afterStep(const World& world) {
    std::set<Key> seen;
    for (const CollisionRecord& record : world.collisions()) {
        const Key key{record.a, record.partA, record.b, record.partB};
        const bool isOpen = open_.count(key) > 0;
        if (isOpen == (record.phase == TouchPhase::Begin)) {
            return pairText(isOpen ? "begins twice" : "persists or ends without a begin", record.a,
                            record.b);
        }
        if ((record.pointCount == 0) != (record.phase == TouchPhase::End)) {
            return pairText("wrong number of points", record.a, record.b);
        }
        if (!(record.maxImpulse >= 0) || !std::isfinite(record.totalImpulse)) {
            return pairText("impulse is no number >= 0", record.a, record.b);
        }
        seen.insert(key);
        if (record.phase == TouchPhase::End) {
            open_.erase(key);
        } else {
            open_.insert(key);
        }
    }
    for (const Key& key : open_) {
        const BodyId a = std::get<0>(key);
        const BodyId b = std::get<2>(key);
        if (seen.count(key) == 0 && !(isStill(world, a) && isStill(world, b))) {
            return pairText("touched, and has no record", a, b);
        }
    }
    return std::nullopt;
}

std::optional<std::string> judgeSleep(const World& world) {
    for (const BodyId id : world.bodies()) {
        const BodyView body = world[id];
        const bool moves = body.type() == BodyType::Kinematic &&
                           (body.velocity() != Vec2{} || body.angularVelocity() != 0);
        if (moves || (body.type() == BodyType::Dynamic && !body.isAsleep())) {
            return std::nullopt;
        }
    }
    World awake = world;
    StepSettings settings = awake.settings();
    settings.leaveOut |= Feature::Sleep;
    awake.setSettings(settings);
    for (int step = 0; step < 60; ++step) {
        awake.step(Real(1) / 60);
    }
    for (const BodyId id : world.bodies()) {
        const Real moved = length(awake[id].center() - world[id].center());
        const Real turned =
            std::abs((awake[id].rotation() * world[id].rotation().inverse()).angle());
        if (moved > Real(0.05) || turned > Real(0.1)) {
            std::ostringstream text;
            text << "body " << id.index << " sleeps, but would move " << moved << " m and "
                 << turned << " rad in a second";
            return text.str();
        }
    }
    return std::nullopt;
}

std::optional<std::string> judgeNumbers(const World& world) {
    for (const BodyId id : world.bodies()) {
        const BodyView body = world[id];
        const Rot q = body.rotation();
        const Vec2 p = body.position();
        const Vec2 v = body.velocity();
        const bool finite = std::isfinite(p.x + p.y) && std::isfinite(v.x + v.y) &&
                            std::isfinite(body.angularVelocity());
        if (!finite || !(std::abs(q.c * q.c + q.s * q.s - 1) < Real(1e-4))) {
            return "body " + std::to_string(id.index) + " has a number that is not sound";
        }
    }
    return world.frozenBodies().empty() ? std::nullopt : std::optional<std::string>("frozen body");
}

} // namespace worlds
