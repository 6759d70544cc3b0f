// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/joints/joint_rows.hpp>
#include <kodo/solve/contact_block.hpp>
#include <kodo/solve/pin_block.hpp>
#include <support/random_numbers.hpp>

#include <vector>

namespace kodo {

inline constexpr std::size_t kPinBlocks = 40;
inline constexpr auto kPinLanes = static_cast<std::size_t>(PinBlock::kPins);

/// Blocks of pins between bodies of their own. Some bodies cannot be pushed, some can only turn,
/// some have turned far. Some lanes have no pin, and lie between the first Motion and itself.
struct RandomPins {
    static constexpr Real kStep = Real(1) / 300; // s

    std::vector<Motion> motion = std::vector<Motion>(1);
    std::vector<PinBlock> blocks = std::vector<PinBlock>(kPinBlocks);
    std::vector<PinUse> use = std::vector<PinUse>(kPinBlocks);

    explicit RandomPins(std::uint64_t seed) {
        support::RandomNumbers random(seed);
        for (std::size_t i = 0; i < kPinBlocks; ++i) {
            const std::size_t lanes = i % 3 == 0 ? kPinLanes - 1 - i % 5 : kPinLanes;
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                fill(random, i, lane);
            }
        }
    }

    std::uint32_t addBody(support::RandomNumbers& random) {
        const std::size_t kind = random.below(6); // 0: locked, 1: turns only, 2: cannot turn
        Motion body;
        body.velocity = kind < 2 ? Vec2{} : random.point(5);
        body.angularVelocity = kind == 0 || kind == 2 ? 0 : random.between(-9, 9);
        body.invMass = kind < 2 ? 0 : random.between(0.1, 4);
        body.move = random.point(0.01);
        body.turn = random.between(-1, 1) * (random.below(4) == 0 ? 100 : Real(0.1));
        body.invInertia = kind == 0 || kind == 2 ? 0 : random.between(0.1, 9);
        motion.push_back(body);
        return static_cast<std::uint32_t>(motion.size() - 1);
    }

    void fill(support::RandomNumbers& random, std::size_t i, std::size_t lane) {
        PinBlock& block = blocks[i];
        const std::uint32_t a = addBody(random);
        const std::uint32_t b = addBody(random);
        block.a[lane] = placeOfMotion(a);
        block.b[lane] = placeOfMotion(b);
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

    void run(PinPasses::Pass pass, const Softness& soft) {
        pass({blocks.data(), use.data(), blocks.size(), motion.data(), kStep, soft});
    }
    void runAll(const PinPasses& passes) {
        const Softness soft = Softness::from(60, 2, kStep);
        for (const PinPasses::Pass pass :
             {passes.turn, passes.warmStart, passes.solve, passes.turn, passes.relax}) {
            run(pass, soft);
        }
    }

    /// Calls visit(a, b, block, lane) for each pin.
    template <typename Visit>
    void forEach(Visit visit) const {
        for (const PinBlock& block : blocks) {
            for (std::size_t lane = 0; lane < kPinLanes; ++lane) {
                visit(bodyOfPlace(block.a[lane]), bodyOfPlace(block.b[lane]), block, lane);
            }
        }
    }

    static void set(PinBlock::Both& to, std::size_t lane, Vec2 v) {
        to.x[lane] = v.x;
        to.y[lane] = v.y;
    }
    static Vec2 get(const PinBlock::Both& from, std::size_t lane) {
        return {from.x[lane], from.y[lane]};
    }
};

} // namespace kodo
