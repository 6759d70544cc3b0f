// SPDX-License-Identifier: MIT
// Scenes of users: what a file says is what is played, and each mistake has its line.
#include <kodo/real.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>

#include "scene_reader.hpp"

namespace crosscheck {
namespace {

const std::string kGood = R"(title = "A thrown box"
seconds = 0.5
rate = 240
gravity = [0, -8]

[[body]]
name = "floor"
type = "static"
box = [20, 1]
position = [0, -5]

[[body]]
name = "box"
parts = [{ box = [1, 0.5] }, { circle = 0.25, at = [1, 0] }]
position = [0, 2]
angle = 0.5
velocity = [3, 4]
spin = 2
density = 7
upright = false

[[body]]
name = "wheel"
polygon = [[0, 0], [1, 0], [0, 1]]
position = [9, 2]

[[joint]]
kind = "revolute"
a = "floor"
b = "wheel"
at = [9, 2]
motor_speed = 3
motor_torque = 1e5

[[compare]]
what = "spin"
body = "wheel"
exact = 3
tolerance = 1e-3

[[compare]]
what = "highest"
body = "box"
time = 0.25

[[compare]]
what = "touch"
a = "floor"
b = "box"
tolerance = 0

[[compare]]
what = "energy"
)";

apart::Read<CrossScene> read(const std::string& text) {
    return readScene(text, "scene.toml");
}

TEST(OwnScene, WhatTheFileSaysIsPlayed) {
    const auto result = read(kGood);
    ASSERT_TRUE(std::holds_alternative<CrossScene>(result))
        << std::get<apart::FileProblem>(result).text();
    const CrossScene& scene = std::get<CrossScene>(result);
    EXPECT_EQ(scene.title, "A thrown box");
    ASSERT_EQ(scene.def.bodies.size(), 3u);
    EXPECT_TRUE(scene.def.bodies[0].locked);
    const scenes::BodyDef& box = scene.def.bodies[1];
    EXPECT_EQ(box.parts.size(), 2u);
    // Where the engine has no double, a file is read in float.
    EXPECT_NEAR(box.rotation.s, std::sin(0.5), sizeof(kodo::Real) == 8 ? 1e-15 : 1e-7);
    EXPECT_EQ(box.spin, 2);
    EXPECT_EQ(box.density, 7);
    EXPECT_EQ(scene.drawn, (std::vector<std::size_t>{1, 2}));

    const Played played = play(scene, *KODO_PRECISION::makeKodo(scene.def, Profile::Balanced));
    ASSERT_EQ(played.frames.size(), 121u);
    EXPECT_NEAR(played.times.back(), 0.5, 1e-9);
    ASSERT_EQ(played.values.size(), scene.figures.size());
    EXPECT_NEAR(played.values[0], 3, 1e-3); // the motor
    const double center = 2 + std::sin(0.5) * massOf(box).center.x;
    EXPECT_NEAR(played.values[1], center + 4 * 0.25 - 4 * 0.25 * 0.25, 1e-3); // v t - g t^2 / 2
    EXPECT_EQ(played.values[2], -1);                                          // never
    EXPECT_EQ(scene.figures[0].rule, Rule::KodoExact);
    EXPECT_EQ(scene.figures[1].rule, Rule::Show);
    EXPECT_EQ(scene.figures[2].rule, Rule::Agree);
    EXPECT_EQ(scene.figures[1].what, "highest of box at 0.25 s");
}

TEST(OwnScene, TheExampleHoldsInEachProfile) {
    const auto text = apart::readTextFile(CROSS_EXAMPLE, 10'000);
    const auto result = read(std::get<std::string>(text));
    ASSERT_TRUE(std::holds_alternative<CrossScene>(result))
        << std::get<apart::FileProblem>(result).text();
    const CrossScene& scene = std::get<CrossScene>(result);
    const Played box2d = play(scene, *makeBox2d(scene.def));
    for (const Profile profile : {Profile::Balanced, Profile::Accurate, Profile::Thesis}) {
        const Played kodo = play(scene, *KODO_PRECISION::makeKodo(scene.def, profile));
        for (std::size_t i = 0; i < scene.figures.size(); ++i) {
            EXPECT_TRUE(holds(scene.figures[i], {profile, sizeof(kodo::Real) == sizeof(double)},
                              kodo.values[i], box2d.values[i]))
                << scene.figures[i].what << ": " << kodo.values[i] << ", " << box2d.values[i];
        }
    }
}

struct Mistake {
    std::string good; // replaced, once
    std::string bad;
    std::string told; // line and reason
};

class OwnSceneMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(OwnSceneMistakes, AreToldWithLineAndKey) {
    std::string text = kGood;
    const std::size_t at = text.find(GetParam().good);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, GetParam().good.size(), GetParam().bad);
    const auto result = read(text);
    ASSERT_TRUE(std::holds_alternative<apart::FileProblem>(result));
    EXPECT_EQ(std::get<apart::FileProblem>(result).text(), "scene.toml:" + GetParam().told);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, OwnSceneMistakes,
    testing::Values(
        Mistake{"seconds = 0.5", "seconds = 0", "2: seconds must be a number from 0.1 to 120"},
        Mistake{"seconds = 0.5\n", "", "1: the key seconds is missing"},
        Mistake{"rate = 240", "rate = \"fast\"", "3: rate must be a number from 10 to 1000"},
        Mistake{"gravity = [0, -8]", "gravity = -8", "4: gravity must be two numbers, as [1, 2]"},
        Mistake{"density", "densty", "19: unknown key body.densty"},
        Mistake{"[[body]]\nname = \"box\"", "[[body]]\nname = \"floor\"",
                "13: name floor is that of another body"},
        Mistake{"box = [20, 1]", "box = [20, 0.01]",
                "9: a shape must be at least 0.05 wide, for Box2D"},
        Mistake{"box = [20, 1]", "box = [20, 1]\ncircle = 1",
                "6: one of box, circle, polygon, capsule, segment, plane and point is needed"},
        Mistake{
            "[1, 0], [0, 1]]", "[0, 1], [1, 0]]",
            "24: polygon: corners: go clockwise: give them counter-clockwise, or use convexHull()"},
        Mistake{"[1, 0], [0, 1]]", "[1, 0]]",
                "24: polygon: corners: must be from 3 to 1024 points, but there are 2"},
        Mistake{"[0, 1]]", "[0, 0.01]]", "24: a shape must be at least 0.05 wide, for Box2D"},
        Mistake{"type = \"static\"", "type = \"fixed\"",
                "8: type must be one of dynamic, kinematic, static"},
        Mistake{"type = \"static\"", "type = \"static\"\nspin = 1",
                "9: spin has no use in a static body"},
        Mistake{"b = \"wheel\"", "b = \"whell\"",
                "30: b must be the name of a body; there is no whell"},
        Mistake{"b = \"wheel\"", "b = \"floor\"", "27: a and b must be two bodies"},
        Mistake{"kind = \"revolute\"", "kind = \"hinge\"",
                "28: kind must be one of revolute, fixed, distance, prismatic, motor, mouse, "
                "wheel, pulley, gear, filter, rope"},
        Mistake{"density = 7", "linear_damping = 7", "12: damping is not played in Box2D 2.4.1"},
        Mistake{"kind = \"revolute\"", "kind = \"wheel\"",
                "27: this kind of joint is not played in Box2D 2.4.1"},
        Mistake{"kind = \"revolute\"", "kind = \"fixed\"",
                "32: motor_speed has no use in a joint of kind fixed"},
        Mistake{"motor_torque = 1e5\n", "", "27: the key motor_torque is missing"},
        Mistake{"body = \"wheel\"\nexact", "body = \"wheel\"\nreason = \"so\"\nexcat",
                "39: unknown key compare.excat"},
        Mistake{"exact = 3\ntolerance = 1e-3", "exact = 3", "35: the key tolerance is missing"},
        Mistake{"time = 0.25", "time = 0.75", "44: time must be a number from 0 to 0.5"},
        Mistake{"what = \"energy\"", "what = \"energy\"\nbody = \"box\"",
                "54: body has no use in a comparison of energy"},
        Mistake{"position = [0, 2]", "position = [0, 2",
                "16: Error while parsing array: expected comma or closing ']', saw 'a'"}),
    [](const auto& given) { return "Number" + std::to_string(given.index); });

TEST(OwnScene, AllMistakesOfAFileAreTold) {
    std::string text = kGood;
    text.replace(text.find("rate = 240"), 10, "rate = 24000");
    text.replace(text.find("b = \"wheel\""), 11, "b = \"whell\"");
    const auto result = read(text);
    EXPECT_EQ(std::get<apart::FileProblem>(result).texts().size(), 2u);
    for (const std::string empty : {"", "seconds = 1\n", "seconds = 1\nbody = 3\n"}) {
        EXPECT_TRUE(std::holds_alternative<apart::FileProblem>(read(empty))) << empty;
    }
}

} // namespace
} // namespace crosscheck
