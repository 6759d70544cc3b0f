// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <support/random_numbers.hpp>

#include "contacts/contact_set.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

namespace kodo {
namespace {

constexpr Tolerances kUsual = Tolerances::forUnit(1);

/// Bodies with all changes that a World permits between two steps.
class Crowd {
public:
    explicit Crowd(std::uint64_t seed) : random_(seed) {
        for (int i = 0; i < 20; ++i) {
            add();
        }
    }

    void change() {
        switch (random_.below(7)) {
        case 0:
        case 1:
            add();
            break;
        case 2:
            remove(any());
            break;
        case 3: // teleport
            touch([&](std::uint32_t body) {
                bodies_.pose[body].position = place();
                bodies_.teleported(body);
            });
            break;
        case 4: // other flags
            touch([&](std::uint32_t body) { bodies_.filter[body].flags ^= 1u; });
            break;
        case 5: // other parts
            touch([&](std::uint32_t body) { setGeometry(bodies_, body, geometry()); });
            break;
        default:
            rest(any());
        }
    }
    void updatePairs() {
        if (refreshAwake(bodies_)) {
            contacts_.candidates().moveToTrees(bodies_, bodies_.changes.toggled);
        }
        contacts_.updatePairs(bodies_, {}, kUsual, Real(1) / 60, team_);
        noteStart(bodies_);
        clearArrivals(bodies_);
    }
    /// The lists that changes bring up to date are those of a look at all bodies.
    void expectAllBodies() const {
        std::vector<std::uint32_t> awake;
        std::size_t thin = 0;
        for (std::uint32_t body = 0; body < bodies_.size(); ++body) {
            if (bodies_.ids.aliveAt(body)) {
                EXPECT_EQ(bodies_.start[body], bodies_.pose[body].position) << body;
                thin += bodies_.extent[body].thin();
            }
            if (bodies_.ids.aliveAt(body) && bodies_.active(body)) {
                awake.push_back(body);
            }
            EXPECT_EQ(bodies_.hasArrived[body] + bodies_.hasTeleported[body], 0) << body;
        }
        EXPECT_EQ(bodies_.awake, awake);
        EXPECT_EQ(bodies_.thin, thin);
    }
    /// Moves bodies by less than the slack of their bounds, which therefore stay valid for bodies
    /// that fall asleep.
    void move() {
        for (const std::uint32_t body : bodies_.awake) {
            bodies_.pose[body].position += random_.point(static_cast<double>(kUsual.margin) / 2);
        }
    }

    /// Parts that are near each other and may collide have a contact, in order and with correct
    /// indices. Parts whose grown bounds do not overlap have none.
    void expectAllPairs() {
        const PartBounds& bounds = contacts_.candidates().bounds();
        std::set<std::pair<std::uint32_t, std::uint32_t>> there;
        ContactKey last;
        std::map<std::uint32_t, std::multiset<std::uint32_t>> ofBody;
        contacts_.store().forEachInOrder([&](std::uint32_t slot) {
            const Contact& contact = contacts_.contacts()[slot];
            ofBody[contact.key.bodyA].insert(slot);
            ofBody[contact.key.bodyB].insert(slot);
            EXPECT_TRUE(there.empty() || last < contact.key);
            last = contact.key;
            const auto& [bodyA, partA, bodyB, partB] = contact.key;
            EXPECT_TRUE(bodies_.ids.aliveAt(bodyA) && bodies_.ids.aliveAt(bodyB));
            EXPECT_EQ(contact.a, bodies_.idAt(bodyA));
            EXPECT_EQ(contact.b, bodies_.idAt(bodyB));
            there.emplace(bounds.indexOf(bodyA, partA), bounds.indexOf(bodyB, partB));
        });
        for (std::uint32_t body = 0; body < bodies_.size(); ++body) {
            std::multiset<std::uint32_t> listed;
            contacts_.store().lists().forEach(body,
                                              [&](std::uint32_t slot) { listed.insert(slot); });
            EXPECT_EQ(listed, ofBody[body]) << "body " << body;
        }
        std::set<std::pair<std::uint32_t, std::uint32_t>> headed;
        for (const ContactSummary& summary : contacts_.summaries()) {
            EXPECT_EQ(bounds.part(summary.proxies.first).body, summary.bodyA);
            EXPECT_EQ(bounds.part(summary.proxies.second).body, summary.bodyB);
            headed.emplace(summary.proxies.first, summary.proxies.second);
        }
        EXPECT_EQ(there, headed);
        std::size_t used = 0;
        for (std::uint32_t i = 0; i < bounds.size(); ++i) {
            if (!bounds.isUsed(i)) {
                continue;
            }
            ++used;
            const PartBounds::Part& part = bounds.part(i);
            EXPECT_EQ(bounds.indexOf(part.body, part.part), i);
            const ConvexShape& outline = bodies_.convex(part.body, part.part);
            const Transform& pose = bodies_.pose[part.body];
            for (const Vec2 vertex : outline.vertices) {
                const Octagon corner = Octagon::of(pose * vertex, outline.radius);
                EXPECT_TRUE(bounds.grown()[i].contains(corner));
            }
            for (std::uint32_t k = 0; k < i; ++k) {
                if (!bounds.isUsed(k)) {
                    continue;
                }
                const PartBounds::Part& other = bounds.part(k);
                const bool near = collide(bodies_.convex(other.body, other.part),
                                          bodies_.pose[other.body], outline, pose, kUsual.margin, 0)
                                      .count > 0;
                const bool found = there.contains({k, i}) || there.contains({i, k});
                EXPECT_FALSE(near && mayMeet(k, i) && !found) << k << " " << i;
                EXPECT_FALSE(found && !overlap(bounds.grown()[i], bounds.grown()[k]));
            }
        }
        EXPECT_EQ(bounds.usedCount(), used);
    }

private:
    BodyDef def() {
        BodyDef def{.shape = Circle{Real(0.5)}, .position = place()};
        if (random_.below(2) == 0) {
            def.shape = Compound{{Box{1, Real(0.25)}, Circle{Real(0.25), {Real(0.75), 0}}}};
        } else if (random_.below(4) == 0) {
            def.shape = Polygon{{{0, 0}, {1, 0}, {1, 1}, {Real(0.5), Real(1.5)}, {0, 1}}};
        }
        return def;
    }
    std::shared_ptr<const BodyGeometry> geometry() { return makeGeometry(partsOf(def())); }
    Vec2 place() { return random_.point(6); }
    std::uint32_t any() {
        std::uint32_t body = 0;
        do {
            body = static_cast<std::uint32_t>(random_.below(bodies_.size()));
        } while (!bodies_.ids.aliveAt(body));
        return body;
    }
    void add() {
        const BodyDef made = def();
        contacts_.bodyChanged(addBody(bodies_, made, makeGeometry(partsOf(made))).index);
        ++count_;
    }
    void remove(std::uint32_t body) {
        if (count_ < 5) {
            return;
        }
        contacts_.drop(body, bodies_);
        removeBody(bodies_, body);
        --count_;
    }
    template <typename Change>
    void touch(Change change) {
        const std::uint32_t body = any();
        contacts_.drop(body, bodies_); // parts may be removed
        change(body);
        contacts_.bodyChanged(body);
    }
    /// Toggles sleep.
    void rest(std::uint32_t body) {
        bodies_.filter[body].flags ^= kAsleep;
        bodies_.noteActivity(body);
        contacts_.activityChanged(body);
    }
    bool mayMeet(std::uint32_t i, std::uint32_t k) const {
        const std::uint32_t a = contacts_.candidates().bounds().part(i).body;
        const std::uint32_t b = contacts_.candidates().bounds().part(k).body;
        return a != b && (bodies_.active(a) || bodies_.active(b)) &&
               shouldCollide(bodies_.filter[a], bodies_.filter[b]);
    }

    support::RandomNumbers random_;
    Bodies bodies_;
    ContactSet contacts_;
    WorkerTeam team_{nullptr};
    int count_ = 0;
};

// Bodies are added, removed and teleported. They get other parts and flags, fall asleep and wake.
// Only their pairs are searched again, but none is missing.
TEST(ContactSet, HasAllPairsAfterAnyChangeOfBodies) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Crowd crowd(seed);
        for (std::uint64_t step = 0; step < 60 && !testing::Test::HasFailure(); ++step) {
            SCOPED_TRACE(testing::Message() << "step " << step);
            for (std::uint64_t change = 0; change < (seed + step) % 4; ++change) {
                crowd.change();
            }
            crowd.updatePairs();
            crowd.expectAllPairs();
            crowd.expectAllBodies();
            crowd.move();
        }
    }
}

} // namespace
} // namespace kodo
