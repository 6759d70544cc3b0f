// SPDX-License-Identifier: MIT
#include <worlds/judges.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace worlds {

using namespace kodo;

namespace {

constexpr int kCrushedSteps = 20;   // after which a body that was crushed has parted
constexpr int kBeyondSteps = 8;     // after which a body that went too far has passed through
constexpr Real kDepth = Real(0.05); // m; beyond a surface without thickness

bool isSolid(const BodyView& body) {
    return (body.flags() & (kSensor | kDisabled)) == 0;
}

Vec2 middleOf(const BodyView& body) {
    return body.massFrame() * body.part(0).convex.middle;
}

/// Where a point (m, in the frame of a segment's body) is against the segment.
struct Beside {
    Real along = 0; // m, from vertex 0
    Real above = 0; // m, to the left; the front of a one-sided segment
    Real span = 0;  // m, length of the segment

    bool within(Real end) const { return along > end && along < span - end; }
};
Beside beside(const ConvexShape& line, Vec2 point) {
    const Vec2 way = line.vertices[1] - line.vertices[0];
    const Real span = length(way);
    const Vec2 arm = point - line.vertices[0];
    return {dot(way, arm) / span, cross(way, arm) / span, span};
}

} // namespace

void PathJudge::restart(const World& world) {
    places_.clear();
    entered_.clear();
    inFront_.clear();
    beyond_.clear();
    steps_.clear();
    jointed_.clear();
    for (const BodyId id : world.bodies()) {
        places_[id] = {world[id].massFrame(), middleOf(world[id])};
    }
    for (const JointId id : world.joints()) {
        const JointDef& def = world.joint(id);
        jointed_.insert({firstBody(def), secondBody(def)});
        jointed_.insert({secondBody(def), firstBody(def)});
    }
}

/// A body between a moving wall and a fixed one is crushed: it must go somewhere.
void PathJudge::findPressed(const World& world) {
    enum : unsigned { kByFixed = 1, kByMoving = 2 };
    std::map<BodyId, unsigned> pressed;
    std::vector<std::pair<BodyId, BodyId>> links;
    for (const CollisionRecord& record : world.collisions()) {
        if (world.contains(record.a) && world.contains(record.b)) {
            links.push_back({record.a, record.b});
        }
    }
    links.insert(links.end(), jointed_.begin(), jointed_.end());
    for (std::size_t round = 0; round < 10; ++round) {
        for (const auto& link : links) {
            const BodyId one = link.first;
            const BodyId other = link.second;
            if (!world.contains(one) || !world.contains(other)) {
                continue;
            }
            const auto by = [&](BodyId id) {
                const BodyType type = world[id].type();
                return type == BodyType::Dynamic  ? pressed[id]
                       : type == BodyType::Static ? unsigned(kByFixed)
                                                  : unsigned(kByMoving);
            };
            const unsigned all = by(one) | by(other);
            pressed[one] |= all;
            pressed[other] |= all;
        }
    }
    for (auto& entry : pressed_) {
        --entry.second;
    }
    for (const auto& entry : pressed) {
        if (entry.second == (kByFixed | kByMoving)) {
            pressed_[entry.first] = kCrushedSteps;
        }
    }
}

/// A cell of bent ground, which lies below all bodies at the start. Others end in mid-air: a body
/// beyond an end may pass.
bool PathJudge::passesOneSided(const ConvexShape& convex, const Path& path, const Key& key) {
    const Beside now = beside(convex, path.to);
    if (convex.before != Vec2{} || convex.after != Vec2{}) {
        return lasts(key, now.within(0) && now.above < -kDepth);
    }
    if (!now.within(path.reach)) {
        inFront_.erase(key);
    } else if (now.above > path.reach) {
        inFront_.insert(key);
    }
    return lasts(key, inFront_.count(key) > 0 && now.above < -kDepth);
}

/// From one side of a segment to the other, by more than kDepth.
bool PathJudge::passesLine(const ConvexShape& convex, const Path& path, const Key& key) {
    const Beside last = beside(convex, path.from);
    const Beside now = beside(convex, path.to);
    if ((last.above > 0) != (now.above > 0)) {
        const Real share = last.above / (last.above - now.above);
        const Real along = last.along + share * (now.along - last.along);
        const bool hits = along > kDepth && along < now.span - kDepth;
        const bool returns = beyond_.erase(key) > 0;
        if (hits && !returns) {
            beyond_.insert(key);
        }
    }
    return lasts(key, beyond_.count(key) > 0 && std::abs(now.above) > kDepth);
}

bool PathJudge::passesSolid(const ConvexShape& convex, const Path& path, const Key& key) {
    if (convex.isPlane()) {
        return lasts(key, dot(convex.normals[0], path.to - convex.vertices[0]) < -kDepth);
    }
    if (convex.isLine()) {
        return passesLine(convex, path, key);
    }
    const bool startsInside = kodo::contains(convex, {}, path.from);
    const bool endsInside = kodo::contains(convex, {}, path.to);
    if (!startsInside) {
        entered_.erase(key);
        if (const auto hit = rayCast(convex, {}, Ray{path.from, path.to})) {
            entered_[key] = hit->normal;
        }
    }
    const auto found = entered_.find(key);
    if (!endsInside && found != entered_.end()) {
        const auto left = rayCast(convex, {}, Ray{path.to, path.from});
        if (left && dot(left->normal, found->second) < Real(-0.9) && beyond_.erase(key) == 0) {
            beyond_.insert(key);
        }
        entered_.erase(key);
    }
    return lasts(key, beyond_.count(key) > 0);
}

bool PathJudge::lasts(const Key& key, bool beyond) {
    if (!beyond) {
        steps_.erase(key);
        return false;
    }
    return ++steps_[key] == kBeyondSteps;
}

bool PathJudge::passes(const BodyView& obstacle, std::size_t part, const Path& path,
                       const Key& key) {
    const ConvexShape& convex = obstacle.part(part).convex;
    if (!path.resting) {
        return false;
    }
    return convex.oneSided ? passesOneSided(convex, path, key) : passesSolid(convex, path, key);
}

std::optional<std::string> PathJudge::afterStep(const World& world) {
    findPressed(world);
    std::optional<std::string> found;
    const std::vector<BodyId> ids = world.bodies();
    for (const BodyId id : ids) {
        const BodyView body = world[id];
        if (body.type() != BodyType::Dynamic || !isSolid(body)) {
            continue;
        }
        const auto crushed = pressed_.find(id);
        const bool counts = crushed == pressed_.end() || crushed->second <= 0;
        for (const BodyId other : ids) {
            const BodyView obstacle = world[other];
            if (other == id || !isSolid(obstacle) || jointed_.count({id, other}) > 0) {
                continue;
            }
            const Place& last = places_[other];
            const Transform& now = obstacle.massFrame();
            Path path{toLocal(last.frame, places_[id].middle), toLocal(now, middleOf(body)),
                      body.part(0).convex.boundingRadius, true};
            const Real turned = std::abs((now.rotation * last.frame.rotation.inverse()).angle());
            path.resting = turned < Real(0.2);
            for (std::size_t part = 0; part < obstacle.partCount(); ++part) {
                if (passes(obstacle, part, path, {id, other, part}) && counts && !found) {
                    std::ostringstream text;
                    text << "body " << id.index << " passes through body " << other.index << " at ("
                         << middleOf(body).x << ", " << middleOf(body).y << ")";
                    found = text.str();
                }
            }
        }
    }
    for (const BodyId id : ids) {
        places_[id] = {world[id].massFrame(), middleOf(world[id])};
    }
    return found;
}

} // namespace worlds
