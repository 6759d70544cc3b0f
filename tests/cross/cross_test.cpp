// SPDX-License-Identifier: MIT
// Judges every scene of the book: profiles of Kodo beside Box2D 2.4.1 and the closed forms.
// `tools/crosscheck` shows the same scenes as a page.
#include <kodo/real.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <set>
#include <string>

#include "cross_scene.hpp"

namespace crosscheck {
namespace {

constexpr bool kIsDouble = sizeof(kodo::Real) == sizeof(double);

std::string line(const Figure& figure, double kodo, double box2d, double tolerance) {
    char text[200];
    std::snprintf(text, sizeof text, "%-40s %14.7g %14.7g %14.7g %14.4g %s",
                  (figure.what + " [" + figure.unit + "]").c_str(), kodo, box2d, figure.exact,
                  tolerance, figure.reason.c_str());
    return text;
}

class CrossScenes : public testing::TestWithParam<std::size_t> {
protected:
    void judge(Profile profile) {
        const CrossScene& scene = sceneBook()[GetParam()];
        const Played kodo = play(scene, *KODO_PRECISION::makeKodo(scene.def, profile));
        const Played box2d = play(scene, *makeBox2d(scene.def, scene.bounceThreshold));
        ASSERT_EQ(kodo.values.size(), scene.figures.size());
        for (std::size_t i = 0; i < scene.figures.size(); ++i) {
            const Figure& figure = scene.figures[i];
            const double tolerance = toleranceOf(figure, {profile, kIsDouble});
            EXPECT_TRUE(holds(figure, {profile, kIsDouble}, kodo.values[i], box2d.values[i]))
                << "                                         Kodo          Box2D    closed form"
                << "      tolerance\n"
                << line(figure, kodo.values[i], box2d.values[i], tolerance);
            EXPECT_TRUE(figure.rule != Rule::Exact || box2dHolds(figure, false, box2d.values[i]))
                << line(figure, kodo.values[i], box2d.values[i], toleranceOfBox2d(figure, false));
        }
    }
};

TEST_P(CrossScenes, BalancedAgrees) {
    judge(Profile::Balanced);
}

TEST_P(CrossScenes, AccurateAgrees) {
    judge(Profile::Accurate);
}

TEST_P(CrossScenes, ThesisAgrees) {
    judge(Profile::Thesis);
}

TEST_P(CrossScenes, ThesisWithoutShockAgrees) {
    judge(Profile::ThesisWithoutShock);
}

INSTANTIATE_TEST_SUITE_P(Book, CrossScenes, testing::Range(std::size_t{0}, sceneBook().size()),
                         [](const auto& given) { return sceneBook()[given.param].name; });

TEST(CrossBook, EveryJudgedFigureStatesTheReasonOfItsTolerance) {
    std::set<std::string> names;
    for (const CrossScene& scene : sceneBook()) {
        EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
        EXPECT_FALSE(scene.drawn.empty()) << scene.name;
        for (const Figure& figure : scene.figures) {
            EXPECT_TRUE(figure.rule == Rule::Show || !figure.reason.empty())
                << scene.name << ": " << figure.what;
            for (const auto& own : {figure.accurate, figure.thesis, figure.withShock,
                                    figure.withoutShock, figure.box2d, figure.box2d3}) {
                EXPECT_TRUE(!own || !own->reason.empty()) << scene.name << ": " << figure.what;
            }
        }
    }
}

TEST(CrossBook, EachFigureWithAClosedFormHasItsMeasuredErrors) {
    for (const CrossScene& scene : sceneBook()) {
        std::set<std::string> figures;
        for (const Figure& figure : scene.figures) {
            EXPECT_TRUE(figures.insert(figure.what).second) << scene.name << ": " << figure.what;
            EXPECT_EQ(figure.rule == Rule::Exact || figure.rule == Rule::KodoExact,
                      figure.errors.has_value())
                << scene.name << ": " << figure.what << "; tools/crosscheck --errors measures";
        }
    }
}

TEST(CrossBook, KodosToleranceIsTenTimesItsErrorWhereLessThanStated) {
    Figure figure{"", "m", Rule::Exact, 2, 0.1, "stated"};
    figure.errors = Errors{1e-3, 1e-5, 0, 0, 1, 1, 1e-9, 1e-9};
    EXPECT_DOUBLE_EQ(toleranceOf(figure, {Profile::Balanced, false}), 1e-2);
    EXPECT_DOUBLE_EQ(toleranceOf(figure, {Profile::Balanced, true}), 1e-4);
    EXPECT_DOUBLE_EQ(toleranceOf(figure, {Profile::Accurate, false}), 8e-6) << "rounding";
    EXPECT_DOUBLE_EQ(toleranceOf(figure, {Profile::Accurate, true}), 2e-12) << "rounding";
    EXPECT_DOUBLE_EQ(toleranceOf(figure, {Profile::Thesis, false}), 0.1) << "never wider";
    figure.thesis = Own{-1, "it falls"};
    EXPECT_LT(toleranceOf(figure, {Profile::Thesis, false}), 0) << "not judged";
    EXPECT_FALSE(holds(figure, {Profile::Balanced, true}, 2.001, 2));
    EXPECT_TRUE(holds(figure, {Profile::Balanced, false}, 2.001, 2));
    EXPECT_TRUE(box2dHolds(figure, true, 2.09));
    figure.box2d3 = Own{0.01, "its slop"};
    EXPECT_FALSE(box2dHolds(figure, true, 2.09));
    EXPECT_TRUE(box2dHolds(figure, false, 2.09));
}

/// Two boxes of which the left one is heavy by its size: the centre of mass is not the frame.
CrossScene thrownPair() {
    CrossScene scene{"", "", "", "", {"thrown", scenes::kDown, {}}};
    scenes::BodyDef body = scenes::box(2, 1, {3, 4});
    body.parts.push_back(scenes::Box{1, 1, {1.5, 0}});
    body.rotation = scenes::turnedBy(0.5);
    body.velocity = {1, 2};
    body.spin = 4;
    scene.def.bodies = {body};
    scene.drawn = {0};
    return scene;
}

TEST(CrossFilm, FramesTellThePlaceOfThePartsBeforeAndAfterASplit) {
    CrossScene scene = thrownPair();
    scene.measure = [](Engine& engine) -> std::vector<double> {
        run(engine, 2 * kDt);
        engine.split(0, 1);
        run(engine, kDt);
        return {};
    };
    const Played played = play(scene, *KODO_PRECISION::makeKodo(scene.def, Profile::Balanced));
    ASSERT_EQ(played.frames.size(), 4u);
    EXPECT_NEAR(played.times[3], 3 * kDt, 1e-12);
    EXPECT_NEAR(played.frames[0][0].position.x, 3, 1e-6);
    EXPECT_NEAR(played.frames[0][0].position.y, 4, 1e-6);
    EXPECT_NEAR(played.frames[0][0].angle, 2 * std::atan(0.5), 1e-6);
    EXPECT_EQ(played.frames[2].size(), 1u);
    ASSERT_EQ(played.frames[3].size(), 2u);
    ASSERT_EQ(played.splits.size(), 1u);
    EXPECT_EQ(played.splits[0].frame, 3u);
    EXPECT_EQ(played.splits[0].part, 1u);
    // The pieces still have nearly one frame: each part moves on with the velocity of the whole.
    const Place& whole = played.frames[3][0];
    const Place& piece = played.frames[3][1];
    EXPECT_NEAR(piece.angle, whole.angle, 1e-6);
    EXPECT_LT(sizeOf(piece.position - whole.position), 4 * 4 * 1.5 * kDt * kDt); // w^2 r t^2
}

TEST(CrossFilm, PartingTimeIsThatOfTheFirstPointThatIsFarther) {
    const CrossScene scene = thrownPair();
    const double reach = reachOf(scene.def.bodies[0]);
    EXPECT_NEAR(reach, std::sqrt(4 + 0.25), 1e-12);
    Played one;
    one.times = {0, 1, 2};
    one.frames = {{Place{}}, {Place{{1, 0}, 3.1}}, {Place{{2, 0}, -3.1}}};
    Played other = one;
    EXPECT_FALSE(partingTime(scene, one, other, 0.1));
    other.frames[2][0].position.y = 0.11;
    EXPECT_EQ(partingTime(scene, one, other, 0.1), 2);
    EXPECT_FALSE(partingTime(scene, one, other, 0.12));
    other.frames[1][0].angle = 3.1 + 0.12 / reach - 2 * kPi; // the same turn, and a little more
    EXPECT_EQ(partingTime(scene, one, other, 0.1), 1);
    other.frames.resize(1); // it ends before
    EXPECT_FALSE(partingTime(scene, one, other, 0.1));
}

} // namespace
} // namespace crosscheck
