// SPDX-License-Identifier: MIT
// The ledger accounts for momentum and energy of fracture, forces and kicks.
#include <support/draws.hpp>
#include <support/random_numbers.hpp>

#include <algorithm>
#include <cmath>

#include "game_access.hpp"

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;

constexpr int kBreaksInPlay = support::draws(100000);

kodo::BasicVec2<double> inDouble(Vec2 v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

/// Sums over bodies about the origin, in double: only the bodies' own floats round.
struct Sums {
    double mass = 0;
    double x = 0; // kg m/s
    double y = 0;
    double moment = 0;
    double kinetic = 0;
    double potential = 0;

    void add(const kodo::BodyView& body) {
        const double m = static_cast<double>(body.mass());
        const auto place = inDouble(body.center());
        const auto velocity = inDouble(body.velocity());
        const double spin = static_cast<double>(body.angularVelocity());
        const double inertia = static_cast<double>(body.inertia());
        mass += m;
        x += m * velocity.x;
        y += m * velocity.y;
        moment += m * cross(place, velocity) + inertia * spin;
        kinetic += (m * lengthSquared(velocity) + inertia * spin * spin) / 2;
        potential += m * static_cast<double>(kGravity) * place.y;
    }
};

/// Sums over everything that came off blocks.
Sums piecesOf(const Game& game, std::size_t balls) {
    Sums sums;
    for (const Shard& shard : game.shards()) {
        sums.add(game.world()[shard.body]);
    }
    for (const Part& part : game.parts()) {
        sums.add(game.world()[part.body]);
    }
    for (std::size_t i = balls; i < game.balls().size(); ++i) {
        sums.add(game.world()[game.balls()[i].body]);
    }
    return sums;
}

Vec2 onTheRim(support::RandomNumbers& random, Vec2 center) {
    const Real along = random.between(-0.5, 0.5);
    const Real side = random.below(2) == 0 ? Real(-0.5) : Real(0.5);
    return center + (random.below(3) == 0 ? Vec2{side * kCellWidth, along * kCellHeight}
                                          : Vec2{along * kCellWidth, side * kCellHeight});
}

/// Breaks a random block; in every second case a loose, moving one. The change of the sums must
/// equal the change of the ledger.
void breakOne(Game& game, support::RandomNumbers& random) {
    const std::size_t index = random.below(static_cast<std::uint32_t>(game.blocks().size()));
    const bool loose = random.below(2) == 0;
    kodo::BodyRef body = GameTestAccess::world(game)[game.blocks()[index].body];
    if (loose) {
        GameTestAccess::letGo(game, index);
        body.setVelocity(random.point(10));
        body.setAngularVelocity(random.between(-8, 8));
    }
    Sums before = piecesOf(game, 1);
    const double mass = before.mass;
    before.add(body);
    if (!loose) { // a mounted block is static: infinite inertia, at rest
        before = piecesOf(game, 1);
    }
    const Vec2 impact = random.point(40);
    const Vec2 point = onTheRim(random, body.position());
    const Real strength = game.blocks()[index].strengthLeft;
    const Real whole = densityOf(game.blocks()[index].kind) * kCellWidth * kCellHeight;
    const Ledger booked = game.ledger();
    GameTestAccess::breakBlock(game, index, point, impact);
    const Sums after = piecesOf(game, 1);
    const Ledger& now = game.ledger();

    EXPECT_GT(after.mass - mass, 0.99 * static_cast<double>(whole));
    const double tookX = now.mountImpulseX - booked.mountImpulseX;
    const double tookY = now.mountImpulseY - booked.mountImpulseY;
    const Vec2 taken = loose ? Vec2{} : impact; // a loose block has already received the impulse
    // Sums of up to 500 floats of about 10 N s, 400 N m s and 100 J, each rounded by half an ulp.
    // Merged corners cost up to 1e-5 of a piece.
    EXPECT_NEAR(after.x - before.x + tookX, static_cast<double>(taken.x), 4e-4);
    EXPECT_NEAR(after.y - before.y + tookY, static_cast<double>(taken.y), 4e-4);
    EXPECT_NEAR(after.moment - before.moment + now.mountTurn - booked.mountTurn,
                static_cast<double>(cross(point, taken)), 8e-3);
    EXPECT_NEAR(after.kinetic - before.kinetic, now.breakWork - booked.breakWork, 8e-3);
    const double least = static_cast<double>(std::min(length(taken), strength)) - 1e-4;
    EXPECT_GE(std::sqrt(tookX * tookX + tookY * tookY), loose ? 0 : least);
}

TEST(Ledger, BooksTheMomentumAndEnergyOfBreaks) {
    constexpr std::uint64_t kPlaySeed = 77;
    support::RandomNumbers random(kPlaySeed);
    const Level level = levelOf("gwbsgwbsgwbsgwb\nWLSgwbsWLSgwbsW\n");
    int breaks = 0;
    for (std::uint32_t seed = 0; breaks < kBreaksInPlay && !HasFailure(); ++seed) {
        Game game(level, seed);
        for (int i = 0; i < 25 && !HasFailure(); ++i, ++breaks) {
            SCOPED_TRACE("seed 77, game " + std::to_string(seed) + ", break " + std::to_string(i));
            breakOne(game, random);
        }
    }
}

TEST(Ledger, BalancesIfPiecesOnlyGrazeEachOther) {
    for (const Force force : {Force::None, Force::Pull, Force::Push}) {
        Input input;
        input.force = force;
        for (std::uint32_t seed = 1; seed <= 40 && !HasFailure(); ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Game game(levelOf("g..............\n" + emptyRows(4) + ".......b.......\n"), seed);
            GameTestAccess::countHit(game);
            const Vec2 block = game.world()[game.blocks()[1].body].position();
            GameTestAccess::breakBlock(game, 1, {0, 24});
            for (int tick = 0; tick < 30; ++tick) {
                game.tick(input);
            }
            const Sums sums = piecesOf(game, 1);
            const Ledger& ledger = game.ledger();
            const double start = sums.mass * static_cast<double>(kGravity * block.y);
            const double works = ledger.breakWork + ledger.fieldWork;
            // Of about 100 J. Pieces that touch move by substeps: they fall less far than a free
            // body, by g h / 2 times the time, which is up to 0.045 J a tick. The largest blow
            // between two of them takes 0.14 J. The smallest work, the tension of the block, is
            // 1.5 J.
            EXPECT_NEAR(sums.kinetic + sums.potential - start, works, 0.2);
            EXPECT_EQ(ledger.fieldWork != 0, force != Force::None);
        }
    }
}

TEST(Ledger, BooksTheWorkOfBumpersAndServo) {
    const Level level = levelWith("g..............\n" + emptyRows(6) + ".......o.......\n", "o",
                                  "obstruction = \"bumper\"\nsize = 400\nspeed = 5000");
    Game game(level, 1, Mode::Pure); // a ball that waits keeps its speed
    const kodo::BodyId ball = GameTestAccess::shoot(game, {Real(0.1), 8}, {0, 9});
    const auto energy = [&] {
        Sums sums;
        sums.add(game.world()[ball]);
        return sums.kinetic;
    };
    const double start = energy();
    ASSERT_TRUE(playUntil<Bumped>(game, {}, 120));
    EXPECT_GT(game.ledger().kickWork, 50); // 1 kg, from 12 to 17 m/s
    for (int tick = 0; tick < 20; ++tick) {
        game.tick({});
    }
    EXPECT_LT(game.ledger().servoWork, 0);
    // Of 150 J; the bounce itself is lossless to 1e-6.
    EXPECT_NEAR(energy() - start, game.ledger().servoWork + game.ledger().kickWork, 2e-3);
}

} // namespace
