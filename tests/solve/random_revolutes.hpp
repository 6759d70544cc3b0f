// SPDX-License-Identifier: MIT
#pragma once

#include <support/random_numbers.hpp>

#include "joints/joint_rows.hpp"

#include <vector>

#include "lanes/contact_block.hpp"
#include "soft/revolute_block.hpp"

namespace kodo {

inline constexpr std::size_t kPinBlocks = 40;
inline constexpr auto kPinLanes = static_cast<std::size_t>(RevoluteBlock::kJoints);

/// Blocks of revolute joints between independent pairs of bodies. Some bodies are locked, some can
/// not rotate, some have rotated far. Some lanes are empty: both bodies are the first
/// BodyVelocity. Every second block has motors and limits if `angular`.
struct RandomPins {
    static constexpr Real kStep = Real(1) / 300; // s

    std::vector<BodyVelocity> motion = std::vector<BodyVelocity>(1);
    std::vector<RevoluteBlock> blocks = std::vector<RevoluteBlock>(kPinBlocks);
    std::vector<RevoluteUse> use = std::vector<RevoluteUse>(kPinBlocks);
    std::vector<RevoluteAngles> angles;

    explicit RandomPins(std::uint64_t seed, bool angular = false) {
        support::RandomNumbers random(seed);
        for (std::size_t i = 0; i < kPinBlocks; ++i) {
            if (angular && i % 2 == 0) {
                use[i].angles = static_cast<std::uint32_t>(angles.size());
                angles.emplace_back();
            }
            const std::size_t lanes = i % 3 == 0 ? kPinLanes - 1 - i % 5 : kPinLanes;
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                fill(random, i, lane);
                if (use[i].angles != RevoluteUse::kNoAngles) {
                    fillAngles(random, angles[use[i].angles], lane);
                }
            }
        }
    }

    std::uint32_t addBody(support::RandomNumbers& random) {
        const std::size_t kind = random.below(6); // 0: locked, 1: cannot rotate
        BodyVelocity body;
        body.velocity = kind == 0 ? Vec2{} : random.point(5);
        body.angularVelocity = kind < 2 ? 0 : random.between(-9, 9);
        body.invMass = kind == 0 ? 0 : random.between(0.1, 4);
        body.deltaPosition = random.point(0.01);
        body.deltaAngle = random.between(-1, 1) * (random.below(4) == 0 ? 100 : Real(0.1));
        body.invInertia = kind < 2 ? 0 : random.between(0.1, 9);
        motion.push_back(body);
        return static_cast<std::uint32_t>(motion.size() - 1);
    }

    void fill(support::RandomNumbers& random, std::size_t i, std::size_t lane) {
        RevoluteBlock& block = blocks[i];
        const std::uint32_t a = addBody(random);
        const std::uint32_t b = addBody(random);
        block.a[lane] = velocityOffset(a);
        block.b[lane] = velocityOffset(b);
        set(block.startA, lane, random.point(1));
        set(block.startB, lane, random.point(1));
        set(block.between, lane, random.point(0.1));
        set(block.impulse, lane, random.point(1));
        block.mass[lane] = motion[a].invMass + motion[b].invMass;
        block.inertiaA[lane] = motion[a].invInertia;
        block.inertiaB[lane] = motion[b].invInertia;
        const auto bit = [&](std::uint32_t body) {
            return static_cast<std::uint8_t>((motion[body].locked() ? 0 : 1) << lane);
        };
        use[i].movesA |= bit(a);
        use[i].movesB |= bit(b);
    }

    /// Some joints have no motor, some no limits; some limits are exceeded.
    static void fillAngles(support::RandomNumbers& random, RevoluteAngles& angles,
                           std::size_t lane) {
        const bool motor = random.below(3) > 0;
        const bool limits = random.below(3) > 0;
        angles.start[lane] = random.between(-1, 1);
        angles.lower[lane] = limits ? random.between(-1.5, 0.2) : -RevoluteAngles::kFarAngle;
        angles.upper[lane] = limits ? random.between(0.2, 1.5) : RevoluteAngles::kFarAngle;
        angles.below[lane] = limits ? random.between(0, 0.1) : 0;
        angles.above[lane] = limits ? random.between(0, 0.1) : 0;
        angles.speed[lane] = random.between(-9, 9);
        angles.torque[lane] = motor ? random.between(0, 30) : 0;
        angles.motor[lane] = motor ? random.between(-0.1, 0.1) : 0;
    }

    void run(RevolutePasses::Pass pass, const Softness& soft) {
        pass({blocks.data(), use.data(), angles.data(), blocks.size(), motion.data(), kStep, soft});
    }
    void runAll(const RevolutePasses& passes) {
        const Softness soft = Softness::from(60, 2, kStep);
        for (const RevolutePasses::Pass pass :
             {passes.rotate, passes.warmStart, passes.solve, passes.rotate, passes.relax}) {
            run(pass, soft);
        }
    }

    /// Calls visit(a, b, block, lane) for each lane.
    template <typename Visit>
    void forEach(Visit visit) const {
        for (const RevoluteBlock& block : blocks) {
            for (std::size_t lane = 0; lane < kPinLanes; ++lane) {
                visit(bodyOfPlace(block.a[lane]), bodyOfPlace(block.b[lane]), block, lane);
            }
        }
    }

    static void set(RevoluteBlock::Both& to, std::size_t lane, Vec2 v) {
        to.x[lane] = v.x;
        to.y[lane] = v.y;
    }
    static Vec2 get(const RevoluteBlock::Both& from, std::size_t lane) {
        return {from.x[lane], from.y[lane]};
    }
};

} // namespace kodo
