// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <worlds/ordinary.hpp>

#include <functional>

namespace worlds {
namespace {

using Vec = kodo::BasicVec2<double>;

// Three scenes of each family. Of 1,900 scenes 12.5 % have faults (engine/docs/worlds.md); chance
// allows 9 of 57.
TEST(OrdinaryScenes, HaveFaultsInAtMostTheShareThatIsReachedToday) {
    const std::uint64_t count = 3 * ordinaryFamilies().size();
    int faulty = 0;
    int inGround = 0;
    std::string list;
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        const Recipe recipe = ordinaryRecipe(seed);
        const OrdinaryRun run = runOrdinary(recipe, *ordinaryInKodo(recipe));
        faulty += run.faults.empty() ? 0 : 1;
        for (const Finding& fault : run.faults) {
            inGround += fault.judge == "ground" ? 1 : 0;
            list += "\nseed " + std::to_string(seed) + ", " + fault.judge + ": " + fault.text;
        }
    }
    EXPECT_LE(faulty, 9) << list;
    EXPECT_EQ(inGround, 0) << list;
}

TEST(OrdinaryScenes, AreRestoredFromTheirText) {
    for (std::uint64_t seed = 0; seed < ordinaryFamilies().size(); ++seed) {
        const std::string text = toText(ordinaryRecipe(seed));
        const std::optional<Recipe> read = fromText(text);
        ASSERT_TRUE(read) << seed;
        EXPECT_EQ(toText(*read), text) << seed;
    }
}

using Motions = std::vector<Motion>;
using Move = std::function<void(Motions&, int step)>;

/// Bodies that move as they are told.
class ToldEngine final : public OrdinaryEngine {
public:
    ToldEngine(const Recipe& recipe, Move move) : move_(std::move(move)) {
        for (const kodo::BodyDef& def : recipe.bodies) {
            motions_.push_back({toDouble(def.position), toDouble(def.rotation), {}, 0});
        }
    }
    void step() override { move_(motions_, step_++); }
    Motion motion(std::size_t body) const override { return motions_[body]; }

private:
    Move move_;
    Motions motions_;
    int step_ = 0;
};

constexpr std::size_t kLink = 1; // hangs from the ground by its upper end, at (0, 2.5)
constexpr std::size_t kBox = 2;  // stands on it

using Names = std::vector<std::string>;

/// The judges that object when link and box, 0.2 m by 1 m, move so for 2 s at 60 Hz.
Names judgesOf(const Move& move) {
    constexpr auto kWide = kodo::Real(0.2);
    constexpr auto kHalf = kodo::Real(0.5);
    Recipe recipe;
    recipe.world.gravity = {0, -10};
    recipe.steps = 120;
    recipe.rests = true;
    recipe.bodies = {
        {.shape = kodo::Box{10, 2}, .position = {0, -1}, .type = kodo::BodyType::Static},
        {.shape = kodo::Box{kWide, 1}, .position = {0, 2}},
        {.shape = kodo::Box{kWide, 1}, .position = {3, kHalf}},
    };
    kodo::RevoluteJoint pin{.ends = {{0, 1, 0}, {1, 1, 0}}, .limits = kodo::Range{-1, 1}};
    pin.ends.anchorA = {0, 3 + kHalf};
    pin.ends.anchorB = {0, kHalf};
    recipe.joints = {pin};
    ToldEngine engine(recipe, move);
    Names names;
    for (const Finding& fault : runOrdinary(recipe, engine).faults) {
        names.push_back(fault.judge);
    }
    return names;
}

TEST(OrdinaryJudges, AcceptWhatStandsStill) {
    EXPECT_EQ(judgesOf([](Motions&, int) {}), Names{});
}

// The scale is the weight of both times 1 m, 4 J; 2 % of it are 0.08 J, which the box of 0.2 kg has
// at 0.894 m/s.
TEST(OrdinaryJudges, ObjectToEnergyThatNothingPutIn) {
    EXPECT_EQ(judgesOf([](Motions& all, int) { all[kBox].velocity.x = 0.90; }), Names{"energy"});
    EXPECT_EQ(judgesOf([](Motions& all, int) { all[kBox].velocity.x = 0.89; }), Names{});
}

// 5 % of the diagonal of the link are 51.0 mm, and 0.25 s are 15 steps.
TEST(OrdinaryJudges, ObjectToAGapThatLasts) {
    const auto open = [](double gap, int steps) {
        return [=](Motions& all, int step) {
            all[kLink].position.y = step >= 20 && step < 20 + steps ? 2 - gap : 2;
        };
    };
    EXPECT_EQ(judgesOf(open(0.0515, 17)), Names{"gap"});
    EXPECT_EQ(judgesOf(open(0.0515, 14)), Names{});
    EXPECT_EQ(judgesOf(open(0.0505, 17)), Names{});
}

TEST(OrdinaryJudges, ObjectToALimitThatIsPassedByATenthOfARadian) {
    const auto turn = [](double angle) {
        return [=](Motions& all, int step) {
            Motion& link = all[kLink];
            link.rotation = kodo::BasicRot<double>::fromAngle(step < 40 ? angle : 0);
            link.position = Vec{0, 2.5} - link.rotation * Vec{0, 0.5};
            const double risen = link.position.y - 2; // its weight is lifted: that is taken out
            all[kBox].position.y = step < 40 ? 0.5 - risen : 0.5;
        };
    };
    EXPECT_EQ(judgesOf(turn(1.11)), Names{"limit"});
    EXPECT_EQ(judgesOf(turn(-1.11)), Names{"limit"});
    EXPECT_EQ(judgesOf(turn(1.09)), Names{});
}

TEST(OrdinaryJudges, ObjectToACentreInTheGround) {
    const auto sink = [](double height) {
        return [=](Motions& all, int step) { all[kBox].position.y = step == 50 ? height : 0.5; };
    };
    EXPECT_EQ(judgesOf(sink(-0.01)), Names{"ground"});
    EXPECT_EQ(judgesOf(sink(0.01)), Names{});
}

TEST(OrdinaryJudges, ObjectToMotionInTheLastSecond) {
    const auto creep = [](double speed) {
        return [=](Motions& all, int step) { all[kBox].position.x = 3 + speed * step / 60; };
    };
    EXPECT_EQ(judgesOf(creep(0.06)), Names{"rest"});
    EXPECT_EQ(judgesOf(creep(0.04)), Names{});
}

// To and fro with each step for half a second; to one side alone is no jitter.
TEST(OrdinaryJudges, ObjectToJitter) {
    const auto shake = [](double speed, int period) {
        return [=](Motions& all, int step) {
            all[kBox].velocity.x = step < 90 && step % period == 0 ? speed : -speed;
        };
    };
    EXPECT_EQ(judgesOf(shake(0.06, 2)), Names{"jitter"});
    EXPECT_EQ(judgesOf(shake(0.04, 2)), Names{});
    EXPECT_EQ(judgesOf(shake(0.06, 4)), Names{});
}

TEST(OrdinaryJudges, ObjectToNumbersThatAreNotFinite) {
    EXPECT_EQ(judgesOf([](Motions& all, int step) { all[kBox].spin = step / 0.0; }),
              Names{"numbers"});
}

} // namespace
} // namespace worlds
