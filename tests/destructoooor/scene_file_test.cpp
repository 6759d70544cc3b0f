// SPDX-License-Identifier: MIT
// Scenes as text: what is written is what is read, and each mistake has its line.
#include <catalogue/parts.hpp>
#include <gtest/gtest.h>
#include <scene_files/scene_file.hpp>

#include <filesystem>
#include <fstream>
#include <sandbox.hpp>
#include <string>

namespace {

using namespace destructoooor;

kodo::World worldOf(const std::string& text) {
    const auto read = scene_files::readScene(text, "scene.toml");
    if (const auto* problem = std::get_if<apart::FileProblem>(&read)) {
        ADD_FAILURE() << problem->text() << "\n" << text;
        return kodo::World{};
    }
    return scene_files::worldOf(std::get<scene_files::SceneFile>(read));
}
std::string textOf(const kodo::World& world) {
    return scene_files::sceneText(world, {.title = "One"});
}

/// Largest distance (m) between the centres of the bodies of two Worlds, in the order of their ids.
Real distanceOf(const kodo::World& one, const kodo::World& other) {
    const std::vector<BodyId> a = one.bodies();
    const std::vector<BodyId> b = other.bodies();
    EXPECT_EQ(a.size(), b.size());
    Real largest = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        largest = std::max(largest, kodo::length(one[a[i]].center() - other[b[i]].center()));
    }
    return largest;
}

class EveryText : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryText, GivesTheSameTextAndTheSameSteps) {
    const Scene& scene = catalogue()[GetParam()];
    SCOPED_TRACE(scene.name);
    kodo::World world = stage(scene).world;
    const std::string text = textOf(world);
    kodo::World read = worldOf(text);
    EXPECT_EQ(textOf(read), text);
    EXPECT_EQ(read.settings(), world.settings());
    EXPECT_EQ(read.joints().size(), world.joints().size());
    EXPECT_EQ(scene_files::notHeld(world), "");
    for (int i = 0; i < 120; ++i) {
        world.step(kStepSeconds);
        read.step(kStepSeconds);
    }
    EXPECT_EQ(distanceOf(world, read), 0);
}

// Impulses are not held, and a rotation is rounded once. Overlap is then pushed out as of new
// contacts: 3 m/s at most.
TEST_P(EveryText, OfASceneInMotionStaysAndGoesOnNearly) {
    kodo::World world = stage(catalogue()[GetParam()]).world;
    for (int i = 0; i < 90; ++i) {
        world.step(kStepSeconds);
    }
    kodo::World read = worldOf(textOf(world));
    const std::string text = textOf(read);
    EXPECT_EQ(textOf(worldOf(text)), text);
    EXPECT_LT(distanceOf(world, read), 1e-5) << catalogue()[GetParam()].name;
    world.step(kStepSeconds);
    read.step(kStepSeconds);
    EXPECT_LT(distanceOf(world, read), 0.05) << catalogue()[GetParam()].name; // m
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryText, testing::Range(std::size_t{0}, catalogue().size()));

TEST(SceneFile, HoldsEachShapeSurfaceAndFilter) {
    kodo::World world({.gravity = {1, -3}});
    world.add({.shape = kodo::Plane{{0, 1}, -2}, .type = kodo::BodyType::Static});
    world.add({.shape = kodo::Chain{.points = {{0, 0}, {4, 0}, {4, 4}}, .closed = true},
               .type = kodo::BodyType::Static});
    world.add({.shape = kodo::Segment{{0, 0}, {1, 0}, false, 0.25_r}});
    world.add({.shape = kodo::Point{}, .position = {3, 3}, .velocity = {-0.0_r, 1}});
    kodo::BodyDef box{.shape = kodo::Box{1, 2, {0.3_r, 0}, kodo::Rot::fromAngle(0.4_r), 0.1_r},
                      .position = {0.1_r, 7},
                      .rotation = kodo::Rot::fromAngle(2),
                      .angularVelocity = 3,
                      .mass = kodo::MassDef{5, Vec2{0.1_r, 0.2_r}, 9_r},
                      .linearDamping = 0.5_r,
                      .angularDamping = 0.25_r,
                      .gravityScale = -2,
                      .continuousMode = kodo::ContinuousMode::Static,
                      .flags = kodo::category(3) | kodo::category(47) | kodo::kMatchAny |
                               kodo::kNeverSleep | kodo::kLockRotate,
                      .required = kodo::category(20) | kodo::kDefaultCategory,
                      .group = -4};
    box.material = {0.9_r, 0.5_r, 0.25_r, 0.125_r, -2, kodo::MixRule::Maximum, kodo::MixRule::Mean};
    world.add(box);
    const BodyId two =
        world.add({.shape = kodo::Compound{{kodo::Circle{1}, kodo::Circle{1, {2, 0}},
                                            kodo::Polygon{{{0, 0}, {1, 0}, {0, 1}}}}},
                   .position = {-9, 4}});
    kodo::Part part = std::as_const(world)[two].part(1);
    part.material.restitution = 0.5_r;
    part.density = 4;
    part.filter = kodo::CollisionFilter{kodo::kSensor | kodo::category(1), 0, 7};
    world[two].setPart(1, part);

    const std::string text = textOf(world);
    const kodo::World read = worldOf(text);
    EXPECT_EQ(textOf(read), text);
    const std::vector<BodyId> ids = world.bodies();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const kodo::BodyView a = std::as_const(world)[ids[i]];
        const kodo::BodyView b = read[read.bodies()[i]];
        EXPECT_EQ(a.flags(), b.flags()) << i;
        EXPECT_EQ(a.required(), b.required()) << i;
        EXPECT_EQ(a.group(), b.group()) << i;
        EXPECT_EQ(a.mass(), b.mass()) << i;
        EXPECT_EQ(a.inertia(), b.inertia()) << i;
        EXPECT_EQ(a.velocity(), b.velocity()) << i;
        EXPECT_EQ(a.gravityScale(), b.gravityScale()) << i;
        EXPECT_EQ(a.continuousMode(), b.continuousMode()) << i;
        ASSERT_EQ(a.partCount(), b.partCount()) << i;
        for (std::size_t k = 0; k < a.partCount(); ++k) {
            EXPECT_EQ(a.part(k).primitive, b.part(k).primitive) << i;
            EXPECT_EQ(a.part(k).material, b.part(k).material) << i;
            EXPECT_EQ(a.part(k).density, b.part(k).density) << i;
            EXPECT_EQ(a.part(k).filter.has_value(), b.part(k).filter.has_value()) << i;
        }
    }
}

TEST(SceneFile, HoldsEachKindOfJointAndField) {
    kodo::World world;
    const BodyId a = world.add({.position = {-2, 0}, .rotation = kodo::Rot::fromAngle(1)});
    const BodyId b = world.add({.position = {2, 0}});
    const kodo::JointEnds ends{.a = a,
                               .b = b,
                               .anchorA = {0.1_r, 0.2_r},
                               .anchorB = {0.3_r, 0.4_r},
                               .breakForce = 50,
                               .collide = true};
    world.add(kodo::RevoluteJoint{.ends = ends,
                                  .reference = 0.5_r,
                                  .limits = kodo::Range{-1, 2},
                                  .motorTorque = 3,
                                  .target = 0.25_r,
                                  .hertz = 2,
                                  .damping = 1,
                                  .ratchet = 0.125_r});
    world.add(kodo::FixedJoint{.ends = ends, .hertz = 5});
    world.add(kodo::DistanceJoint{.ends = ends, .hertz = 2, .damping = 0.5_r});
    world.add(kodo::DistanceJoint{.ends = ends, .length = 3, .limits = kodo::Range{0, 4}});
    world.add(kodo::PrismaticJoint{.ends = ends, .axis = {0, 1}, .target = 2, .hertz = 1});
    world.add(kodo::MotorJoint{.ends = ends, .force = 3, .torque = 4, .hertz = 0});
    world.add(kodo::MouseJoint{.body = b, .target = {1, 2}, .force = 9});
    world.add(kodo::WheelJoint{.ends = ends, .axis = {1, 0}, .hertz = 4, .motorTorque = 2});
    world.add(kodo::PulleyJoint{.ends = ends, .groundA = {0, 9}, .groundB = {1, 9}, .ratio = 2});
    world.add(kodo::GearJoint{.ends = ends, .ratio = 3, .rack = Vec2{1, 0}});
    world.add(kodo::FilterJoint{.ends = {.a = a, .b = b}});
    world.addField({std::make_shared<kodo::Wind>(kodo::DragLaw{1, 2}, Vec2{3, 4},
                                                 kodo::Aabb{{-1, -2}, {5, 6}}),
                    {kodo::kMatchAny, kodo::category(2)}});
    world.addField({std::make_shared<kodo::Drag>(kodo::DragLaw{1, 2}), {}});
    world.addField({std::make_shared<kodo::Gravity>(Vec2{0, -1}), {}});
    world.addField(
        {std::make_shared<kodo::Attractor>(kodo::Attractor::Law::Linear, Vec2{1, 2}, 3_r), {}});
    world.addField(
        {std::make_shared<kodo::Buoyancy>(kodo::Buoyancy::Fluid{2, 3}, Vec2{0, 1}, Vec2{0, -10}),
         {}});
    const std::string text = textOf(world);
    const kodo::World read = worldOf(text);
    EXPECT_EQ(textOf(read), text);
    ASSERT_EQ(read.joints().size(), 11u);
    for (std::size_t i = 0; i < 11; ++i) {
        EXPECT_EQ(read.joint(read.joints()[i]).index(), world.joint(world.joints()[i]).index());
    }
    EXPECT_EQ(read.fields().size(), 5u);
    EXPECT_EQ(std::get<kodo::RevoluteJoint>(read.joint(read.joints()[0])).limits,
              (kodo::Range{-1, 2}));
    EXPECT_TRUE(std::get<kodo::GearJoint>(read.joint(read.joints()[9])).ends.collide);
}

TEST(SceneFile, TellsWhatItDoesNotHold) {
    kodo::World world;
    world.add({.userData = 3});
    world.setRegion(kodo::Aabb{{-1, -1}, {1, 1}});
    EXPECT_EQ(scene_files::notHeld(world), "user data, the region");
}

const std::string kGood = R"(title = "One"
seconds = 2
[settings]
substeps = 4
[[field]]
kind = "drag"
linear = 1
[[body]]
name = "a"
circle = 1
position = [0, 0]
[[body]]
name = "b"
box = [1, 2]
position = [3, 0]
restitution = 0.5
[[joint]]
kind = "wheel"
a = "a"
b = "b"
at = [1, 0]
)";

TEST(SceneFile, MistakesAreToldWithLineAndKeyAndLoseNothing) {
    const std::vector<std::vector<std::string>> cases{
        {"substeps = 4", "substeps = 0", ":4: substeps must be"},
        {"substeps = 4", "contact_passes = 4", ":4: contact_passes has no use in settings"},
        {"linear = 1", "law = \"linear\"", ":7: law has no use in a field of kind drag"},
        {"\"drag\"", "\"dragg\"", ":6: kind must be one of own, gravity, drag"},
        {"circle = 1", "circle = -1", ":10: circle: radius"},
        {"circle = 1", "circle = 1\nradius = 2", ":11: radius has no use in this body"},
        {"[3, 0]", "[3]", ":15: position must be two numbers"},
        {"restitution = 0.5", "restitution = 5", ":16: material.restitution: must be from 0 to 2"},
        {"restitution = 0.5", "restitutoin = 0.5", ":16: unknown key body.restitutoin"},
        {"restitution = 0.5", "categories = [48]", ":16: categories must be a list"},
        {"restitution = 0.5", "with = [1]", ":16: with needs collides"},
        {"\"wheel\"", "\"gear\"", ":17: the key to is missing"},
        {"at = [1, 0]", "at = [1, 0]\nlength = 2",
         ":22: length has no use in a joint of kind wheel"},
        {"b = \"b\"", "b = \"c\"", ":20: b must be the name of a body; there is no c"},
    };
    Sandbox sandbox;
    sandbox.takeText(kGood, "good.toml");
    const std::uint64_t hash = sandbox.world().stateHash();
    EXPECT_EQ(sandbox.fileTitle(), "One");
    for (const std::vector<std::string>& one : cases) {
        std::string text = kGood;
        ASSERT_NE(text.find(one[0]), std::string::npos);
        text.replace(text.find(one[0]), one[0].size(), one[1]);
        try {
            sandbox.takeText(text, "bad.toml");
            ADD_FAILURE() << one[1];
        } catch (const std::runtime_error& error) {
            EXPECT_EQ(std::string(error.what()).find("bad.toml" + one[2]), 0u) << error.what();
        }
        EXPECT_EQ(sandbox.world().stateHash(), hash);
    }
}

TEST(Sandbox, SavesAndLoadsASceneFile) {
    const std::string file = testing::TempDir() + "scene_file_test.toml";
    Sandbox sandbox;
    sandbox.save(file);
    const std::string text = sandbox.text();
    EXPECT_EQ(sandbox.notHeld(), "");
    for (int i = 0; i < 30; ++i) {
        sandbox.step();
    }
    sandbox.load(file);
    EXPECT_TRUE(sandbox.isLoaded());
    EXPECT_EQ(sandbox.text(), text);
    EXPECT_EQ(sandbox.gravity(), 10);
    for (int i = 0; i < 30; ++i) {
        sandbox.step();
    }
    sandbox.restart();
    EXPECT_EQ(sandbox.tick(), 0u);
    EXPECT_EQ(sandbox.text(), text);
    EXPECT_GT(sandbox.view().extent().x, 5);
    sandbox.open(1);
    EXPECT_FALSE(sandbox.isLoaded());
    std::filesystem::remove(file);
}

} // namespace
