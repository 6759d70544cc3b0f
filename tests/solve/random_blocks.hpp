// SPDX-License-Identifier: MIT
#pragma once

#include <support/random_numbers.hpp>

#include <vector>

#include "lanes/contact_block.hpp"

namespace kodo {

inline constexpr int kContacts = ContactBlock::kContacts;
inline constexpr std::size_t kBlocks = 40;

/// Blocks of contacts between independent pairs of bodies: with and without rolling resistance,
/// static friction above the kinetic one, and surface speeds; with one or two points, separated or
/// deep, some with a locked body.
struct RandomBlocks {
    std::vector<BodyVelocity> motion;
    std::vector<Extent> extent;
    std::vector<ContactBlock> blocks = std::vector<ContactBlock>(kBlocks);
    std::vector<SurfaceBlock> surfaces;
    std::vector<BlockUse> use = std::vector<BlockUse>(kBlocks);
    std::vector<std::uint32_t> order;

    explicit RandomBlocks(std::uint64_t seed) {
        support::RandomNumbers random(seed);
        for (std::size_t i = 0; i < kBlocks; ++i) {
            order.push_back(static_cast<std::uint32_t>(i));
            use[i].rareFriction = hasStiction(i) || isBelt(i);
            use[i].twoPoints = random.below(2) == 0;
            use[i].onLocked = random.below(4) == 0;
            use[i].movesA = use[i].onLocked ? 0 : 0xff;
            use[i].movesB = 0xff;
            if (random.below(3) == 0 || isBelt(i)) {
                use[i].surface = static_cast<std::int32_t>(surfaces.size());
                surfaces.emplace_back();
            }
            for (std::size_t lane = 0; lane < kContacts; ++lane) {
                fill(random, i, lane);
            }
        }
    }

    static bool hasStiction(std::size_t block) { return block % 8 == 7; }
    static bool isBelt(std::size_t block) { return block % 8 == 3; }

    std::uint32_t addBody(support::RandomNumbers& random, bool locked) {
        BodyVelocity body;
        body.velocity = random.point(5);
        body.angularVelocity = random.between(-3, 3);
        body.invMass = locked ? 0 : random.between(0.1, 4);
        body.deltaPosition = random.point(0.01);
        body.deltaAngle = random.between(-0.01, 0.01);
        body.invInertia = locked ? 0 : random.between(0.1, 9);
        motion.push_back(body);
        extent.push_back({random.between(0.1, 2), 0});
        return static_cast<std::uint32_t>(motion.size() - 1);
    }

    void fill(support::RandomNumbers& random, std::size_t i, std::size_t lane) {
        ContactBlock& block = blocks[i];
        block.a[lane] = velocityOffset(addBody(random, use[i].onLocked));
        block.b[lane] = velocityOffset(addBody(random, false));
        const Rot normal = random.rotation();
        block.normalX[lane] = normal.c;
        block.normalY[lane] = normal.s;
        for (std::size_t k = 0; k < (use[i].twoPoints ? 2u : 1u); ++k) {
            ContactBlock::Point& point = block.points[k];
            point.leverA[lane] = random.between(-0.5, 0.5);
            point.leverB[lane] = random.between(-0.5, 0.5);
            point.mass[lane] = random.between(0.1, 2);
            point.separation[lane] = random.between(-0.03, 0.02);
            point.impulse[lane] = random.below(3) == 0 ? 0 : random.between(0, 2);
        }
        block.tangentLeverA[lane] = random.between(-0.5, 0.5);
        block.tangentLeverB[lane] = random.between(-0.5, 0.5);
        block.tangentMass[lane] = random.between(0.1, 2);
        block.friction[lane] = random.between(-1, 1);
        block.staticFriction[lane] = random.between(0, 1);
        const Real share = hasStiction(i) ? Real(0.8) : Real(1);
        block.kineticFriction[lane] = share * block.staticFriction[lane];
        block.pushSpeed[lane] = 3;
        if (use[i].surface >= 0) {
            SurfaceBlock& own = surfaces[static_cast<std::size_t>(use[i].surface)];
            own.rollingLever[lane] = random.between(0, 0.1);
            own.rollingMass[lane] = random.between(0.1, 2);
            own.speed[lane] = isBelt(i) ? random.between(-2, 2) : Real(0);
            block.rolling[lane] = random.between(-0.1, 0.1);
        }
    }

    ContactPassArguments pass() {
        const Real h = Real(1) / 240;
        PassSettings settings{Softness::from(60, 10, h), Softness::from(120, 10, h), 1 / h, true,
                              1};
        settings.pushSpeed = 12; // blocks push by up to 3: as in a crowd
        return {blocks.data(), surfaces.data(), use.data(), order.data(),
                kBlocks,       motion.data(),   settings};
    }

    /// Runs two substeps, and advances to the next step.
    void run(const ContactPasses& passes) {
        ContactPassArguments pass = this->pass();
        for (int substep = 0; substep < 2; ++substep) {
            pass.settings.kept = substep == 0 ? Real(0) : Real(1);
            passes.warmStart(pass);
            passes.solve(pass);
            passes.relax(pass);
        }
        passes.advance(
            {blocks.data(), use.data(), order.data(), kBlocks, motion.data(), extent.data()});
    }
};

} // namespace kodo
