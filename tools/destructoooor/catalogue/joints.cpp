// SPDX-License-Identifier: MIT
#include "parts.hpp"

namespace destructoooor {

namespace {

constexpr std::string_view kJoints = "Joints";

/// Links of a chain from a post to the right, each 1 m long; returns them.
Ids hangLinks(kodo::World& world, Vec2 from, int count) {
    Ids ids{addAnchor(world, from)};
    for (int i = 0; i < count; ++i) {
        ids.push_back(addBox(world, from + Vec2{Real(i) + 0.5_r, 0}, 1, 0.2_r));
        pin(world, ids[ids.size() - 2], ids.back(), from + Vec2{Real(i), 0});
    }
    return ids;
}

Ids buildPendulum(kodo::World& world) {
    const BodyId post = addAnchor(world, {0, 12});
    // 10 m of rod at 0.1 rad.
    const Vec2 bob = Vec2{0, 12} + 10 * Vec2{std::sin(0.1_r), -std::cos(0.1_r)};
    const BodyId ball = addBall(world, bob, 0.5_r);
    tie(world, post, {0, 12}, ball, bob, {.length = 10, .limits = kodo::Range{10, 10}});
    return {ball};
}

bool swungBack(const kodo::World& world, const Ids& ids) {
    return isNear(world[ids[0]].center().x, 10 * std::sin(0.1_r), 0.03_r);
}

Ids buildDoublePendulum(kodo::World& world) {
    const Ids ids = hangLinks(world, {0, 7}, 2);
    meetNothing(world, ids.back()); // it swings through the post
    return ids;
}

Ids buildChain(kodo::World& world) {
    return hangLinks(world, {0, 13}, 10);
}

bool chainHolds(const kodo::World& world, const Ids& ids) {
    for (std::size_t i = 2; i < ids.size(); ++i) {
        const Vec2 end = world[ids[i - 1]].transform() * Vec2{0.5_r, 0};
        const Vec2 start = world[ids[i]].transform() * Vec2{-0.5_r, 0};
        if (!isNear(end, start, 0.01_r)) {
            return false;
        }
    }
    return true;
}

Ids buildWreckingBall(kodo::World& world) {
    addGround(world);
    Ids links = hangLinks(world, {-7, 10}, 7);
    const BodyId ball = addBall(world, {0.9_r, 10}, 0.9_r, {.density = 8});
    pin(world, links.back(), ball, {0, 10});
    links.push_back(ball);
    for (int i = 0; i < 24; ++i) {
        addBox(world, {-3 + Real(i % 3), 0.5_r + Real(i / 3)}, 1, 1);
    }
    return links;
}

Ids buildBridge(kodo::World& world) {
    constexpr int kPlanks = 20;
    Ids ids{addBox(world, {-11, 4.9_r}, 2, 1, {.type = kodo::BodyType::Static})};
    for (int i = 0; i < kPlanks; ++i) {
        ids.push_back(addBox(world, {Real(i) - 9.5_r, 5.25_r}, 1, 0.25_r, {.density = 2}));
        pin(world, ids[ids.size() - 2], ids.back(), {Real(i) - 10, 5.25_r});
    }
    ids.push_back(addBox(world, {11, 4.9_r}, 2, 1, {.type = kodo::BodyType::Static}));
    pin(world, ids[ids.size() - 2], ids.back(), {10, 5.25_r});
    for (int i = 0; i < 5; ++i) {
        addBox(world, {Real(i) - 2, 6.5_r}, 0.9_r, 0.9_r, {.density = 5});
    }
    return ids;
}

bool bridgeHolds(const kodo::World& world, const Ids& ids) {
    return chainHolds(world, {ids.begin(), ids.end() - 1}) && world[ids[10]].center().y > 1;
}

Ids buildHeavyRope(kodo::World& world) {
    const BodyId post = addAnchor(world, {0, 13});
    const BodyId light = addBall(world, {0, 9}, 0.3_r);
    const BodyId heavy = addBall(world, {0, 5}, 1, {.density = 90});
    tie(world, post, {0, 13}, light, {0, 9}, rope(4));
    tie(world, light, {0, 9}, heavy, {0, 5}, rope(4));
    return {heavy};
}

Ids buildSprings(kodo::World& world) {
    Ids ids;
    for (int i = 0; i < 4; ++i) {
        const Real x = 4 * Real(i) - 6;
        const BodyId post = addAnchor(world, {x, 12});
        ids.push_back(addBall(world, {x, 7}, 0.5_r));
        tie(world, post, {x, 12}, ids.back(), {x, 7},
            {.length = 5, .hertz = 0.5_r * Real(i + 1), .damping = 0});
    }
    return ids;
}

bool springsSwing(const kodo::World& world, const Ids& ids) {
    // After 2 s each spring has made a whole number of periods and is where it began.
    return std::all_of(ids.begin(), ids.end(),
                       [&](BodyId id) { return isNear(world[id].center().y, 7, 0.12_r); });
}

Ids buildDamping(kodo::World& world) {
    Ids ids;
    const Real dampings[] = {0, 0.1_r, 0.5_r, 1};
    for (int i = 0; i < 4; ++i) {
        const Real x = 4 * Real(i) - 6;
        const BodyId post = addAnchor(world, {x, 12});
        ids.push_back(addBall(world, {x, 7}, 0.5_r));
        tie(world, post, {x, 12}, ids.back(), {x, 7},
            {.length = 5, .hertz = 1, .damping = dampings[i]});
    }
    return ids;
}

Ids buildFan(kodo::World& world) {
    const BodyId post = addAnchor(world, {0, 7});
    const BodyId fan = addBox(world, {0, 7}, 10, 0.5_r);
    kodo::RevoluteJoint motor{.ends = endsAt(world, post, fan, {0, 7})};
    motor.motorSpeed = 3;
    motor.motorTorque = 500;
    world.add(motor);
    for (int i = 0; i < 30; ++i) {
        addBall(world, {Real(i % 10) - 4.5_r, 10 + Real(i / 10)}, 0.3_r, {.density = 0.1_r});
    }
    return {fan};
}

Ids buildSlider(kodo::World& world) {
    const BodyId rail = addAnchor(world, {0, 7});
    Ids ids;
    const Real angles[] = {0.3_r, 0.8_r, 1.3_r};
    for (const Real angle : angles) {
        const kodo::Rot turn = kodo::Rot::fromAngle(angle);
        const BodyId cart = addBox(world, {0, 7}, 1, 0.5_r, {.rotation = turn});
        kodo::PrismaticJoint joint{.ends = endsAt(world, rail, cart, {0, 7})};
        joint.axis = turn.xAxis();
        joint.reference = angle;
        joint.limits = kodo::Range{-6, 6};
        world.add(joint);
        ids.push_back(cart);
    }
    for (const BodyId id : ids) {
        meetNothing(world, id); // the carts pass each other
    }
    return ids;
}

Ids buildBreaking(kodo::World& world) {
    addGround(world);
    Ids ids{addAnchor(world, {-9, 7})};
    for (int i = 0; i < 8; ++i) {
        ids.push_back(addBox(world, {2 * Real(i) - 8, 7}, 2, 0.3_r, {.density = 2}));
        kodo::RevoluteJoint joint{
            .ends = endsAt(world, ids[ids.size() - 2], ids.back(), {2 * Real(i) - 9, 7})};
        joint.ends.breakForce = 450;
        world.add(joint);
    }
    const BodyId end = addAnchor(world, {7, 7});
    pin(world, ids.back(), end, {7, 7});
    addBall(world, {0, 12}, 1, {.density = 15});
    return ids;
}

Ids buildHold(kodo::World& world) {
    const BodyId post = addAnchor(world, {0, 7});
    const BodyId held = addBox(world, {5, 9}, 2, 2);
    kodo::MotorJoint motor{.ends = {.a = post, .b = held, .anchorA = {3, 0}}};
    motor.force = 200;
    motor.torque = 200;
    motor.hertz = 2;
    world.add(motor);
    addBall(world, {3, 13}, 0.7_r);
    return {held};
}

const Scene kJointScenes[] = {
    {kJoints, "Pendulum", "How long does a pendulum of 10 m take?",
     "2 pi sqrt(l / g) = 6.29 s: then it is back.", buildPendulum, 6.2871_r, swungBack},
    {kJoints, "Double pendulum", "Does chaos keep its energy?", "Within 2 % in ten seconds.",
     buildDoublePendulum, 10,
     [](const kodo::World& world, const Ids&) {
         const Real start = 0.4_r * 10 * 7; // two links of 0.2 kg at 7 m
         return isNear(energyOf(world, 10), start, 0.02_r * 0.4_r * 10 * 2);
     }},
    {kJoints, "Chain", "Do ten links hold together while they swing?",
     "No gap reaches a hundredth of a link.", buildChain, 6, chainHolds},
    {kJoints, "Wrecking ball",
     "Does a chain of light links hold a ball of a hundred times their mass?",
     "It holds, and the tower does not.", buildWreckingBall, 5,
     [](const kodo::World& world, const Ids& ids) {
         return chainHolds(world, {ids.begin(), ids.end() - 1}) && deepestOverlap(world) < 0.02_r;
     }},
    {kJoints, "Bridge", "Does a bridge of twenty planks carry five boxes?",
     "It sags and holds; no gap reaches a hundredth of a plank.", buildBridge, 8, bridgeHolds},
    {kJoints, "Thousandfold on a rope",
     "Does a rope over a light knot hold a thousand times its mass?", "It stays 8 m long.",
     buildHeavyRope, 6,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids[0]].center().y, 5, 0.1_r);
     }},
    {kJoints, "Springs", "Do springs of 0.5, 1, 1.5 and 2 Hz keep time?",
     "After two seconds all are back where they began.", buildSprings, 2, springsSwing},
    {kJoints, "Damping", "What does a damping ratio of 0, 0.1, 0.5 and 1 do?",
     "With 1 the ball comes to rest without swinging; with 0 it swings on.", buildDamping, 6,
     [](const kodo::World& world, const Ids& ids) {
         return kodo::length(world[ids[3]].velocity()) < 0.01_r &&
                kodo::length(world[ids[2]].velocity()) < 0.01_r;
     }},
    {kJoints, "Fan", "Does a motor keep 3 rad/s under load?", "It does, within its torque.",
     buildFan, 4,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids[0]].angularVelocity(), 3, 0.1_r);
     }},
    {kJoints, "Rails", "Where do carts on three inclined rails stop?",
     "At the lower limits, 6 m from the middle.", buildSlider, 5,
     [](const kodo::World& world, const Ids& ids) {
         return std::all_of(ids.begin(), ids.end(), [&](BodyId id) {
             return isNear(kodo::length(world[id].center() - Vec2{0, 7}), 6, 0.05_r);
         });
     }},
    {kJoints, "Breaking bridge", "Which pin breaks when a ball of 47 kg lands?",
     "At least one of those near the posts; the bridge falls.", buildBreaking, 4,
     [](const kodo::World& world, const Ids&) { return world.joints().size() < 9; }},
    {kJoints, "Held in the air", "Does a motor joint hold a box where it is told?",
     "It swings in to 3 m beside the post, also after the ball has hit it.", buildHold, 8,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids[0]].center(), {3, 7}, 0.4_r);
     }},
};

} // namespace

std::span<const Scene> jointScenes() {
    return kJointScenes;
}

} // namespace destructoooor
