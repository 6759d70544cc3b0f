// SPDX-License-Identifier: MIT
#include <string>

#include "c_world.hpp"

namespace {

using namespace c_test;

/// A box that turns on a kinematic disc, and a capsule, in a World and its twin in C++.
struct Scene {
    CWorld world;
    kodo::World twin{{.gravity = {0, -10}}};

    Scene() {
        kodo_BodyDef def = bodyAt(0, 5);
        def.type = KODO_KINEMATIC;
        const kodo_BodyId disc = world.add(def);
        const kodo::BodyId twinDisc =
            twin.add({.position = {0, 5}, .type = kodo::BodyType::Kinematic});
        def = bodyAt(1, 5);
        def.shape = kodo_box(1, 1);
        const kodo_BodyId box = world.add(def);
        const kodo::BodyId twinBox = twin.add({.shape = kodo::Box{1, 1}, .position = {1, 5}});
        def = bodyAt(0, 0);
        def.shape = kodo_capsule(kodo_vec2(-1, 0), kodo_vec2(1, 0), kodo_Real(0.5));
        world.add(def);
        twin.add({.shape = kodo::Capsule{{-1, 0}, {1, 0}, kodo::Real(0.5)}});
        kodo_JointDef joint = kodo_jointDef(KODO_REVOLUTE_JOINT);
        joint.revolute.ends.a = disc;
        joint.revolute.ends.b = box;
        joint.revolute.ends.anchorB = kodo_vec2(-1, 0);
        world.add(joint);
        twin.add(kodo::RevoluteJoint{.ends = {.a = twinDisc, .b = twinBox, .anchorB = {-1, 0}}});
        world.step(10);
        for (int i = 0; i < 10; ++i) {
            twin.step(kDt);
        }
    }
};

/// What the functions of a picture were called with.
struct Seen {
    int lines = 0;
    int circles = 0;
    int polygons = 0;
    int rounded = 0;
    int begun = 0;
    std::size_t corners = 0; // of the last polygon
    std::string texts;
    kodo_DrawStyle last{};
};

kodo_DebugDraw pictureFor(Seen& seen) {
    kodo_DebugDraw target = kodo_debugDraw();
    target.context = &seen;
    target.view = {{-10, -10}, {10, 10}};
    target.line = [](void* context, kodo_Vec2, kodo_Vec2, const kodo_DrawStyle* style) {
        ++static_cast<Seen*>(context)->lines;
        static_cast<Seen*>(context)->last = *style;
    };
    target.circle = [](void* context, kodo_Vec2, kodo_Real, const kodo_DrawStyle*) {
        ++static_cast<Seen*>(context)->circles;
    };
    target.polygon = [](void* context, const kodo_Vec2*, size_t count, const kodo_DrawStyle*) {
        ++static_cast<Seen*>(context)->polygons;
        static_cast<Seen*>(context)->corners = count;
    };
    target.text = [](void* context, kodo_Vec2, const char* utf8, const kodo_DrawStyle*) {
        static_cast<Seen*>(context)->texts += utf8;
    };
    return target;
}

TEST(CDraw, FiguresAreThoseOfTheWorld) {
    const Scene scene;
    Seen seen;
    kodo_DebugDraw target = pictureFor(seen);
    EXPECT_OK(kodo_draw(scene.world, &target, nullptr));
    EXPECT_EQ(2, seen.circles);   // disc and pin
    EXPECT_EQ(2, seen.polygons);  // box and capsule
    EXPECT_GT(seen.corners, 20u); // of the capsule
    EXPECT_EQ(3 + 2, seen.lines); // spokes; arm and gap of the joint
    EXPECT_EQ("", seen.texts);
}

TEST(CDraw, FunctionsOfTheCallerReplaceThoseMadeOfOthers) {
    const Scene scene;
    Seen seen;
    kodo_DebugDraw target = pictureFor(seen);
    target.rounded = [](void* context, const kodo_Vec2* corners, size_t count, kodo_Real radius,
                        const kodo_DrawStyle*) {
        EXPECT_EQ(2u, count);
        EXPECT_EQ(kodo_Real(-1), corners[0].x);
        EXPECT_EQ(kodo_Real(0.5), radius);
        ++static_cast<Seen*>(context)->rounded;
    };
    target.begin = [](void* context, kodo_BodyId, kodo_DrawStyle* style) {
        ++static_cast<Seen*>(context)->begun;
        style->width = 9;
    };
    target.label = [](void*, kodo_BodyId) -> const char* { return "x"; };
    kodo_DrawOptions options = kodo_drawOptions();
    options.joints = false;
    options.labels = true;
    EXPECT_OK(kodo_draw(scene.world, &target, &options));
    EXPECT_EQ(1, seen.rounded);
    EXPECT_EQ(1, seen.polygons);
    EXPECT_EQ(3, seen.begun);
    EXPECT_EQ(9, seen.last.width);
    EXPECT_EQ("xxx", seen.texts);
}

TEST(CDraw, ThePictureIsThatOfCpp) {
    const Scene scene;
    kodo_DrawOptions options = kodo_drawOptions();
    options.velocities = true;
    const kodo_Aabb view{{-4, -4}, {4, 8}};
    std::size_t count = 0;
    EXPECT_OK(kodo_svg(scene.world, &options, &view, nullptr, 0, &count));
    std::string text(count, ' ');
    EXPECT_OK(kodo_svg(scene.world, &options, &view, text.data(), count, &count));
    EXPECT_EQ(kodo::svg(scene.twin, {.velocities = true}, kodo::Aabb{{-4, -4}, {4, 8}}), text);

    kodo_Aabb all{};
    EXPECT_OK(kodo_viewOf(scene.world, &all));
    EXPECT_EQ(kodo::viewOf(scene.twin).upper.y, all.upper.y);
}

TEST(CDraw, BadArgumentsAreRefused) {
    const Scene scene;
    kodo_DebugDraw target = kodo_debugDraw();
    EXPECT_OK(kodo_draw(scene.world, &target, nullptr)); // shows nothing
    EXPECT_EQ(KODO_WRONG_USE, kodo_draw(nullptr, &target, nullptr));
    EXPECT_EQ(KODO_WRONG_USE, kodo_draw(scene.world, nullptr, nullptr));
    target.head.size = 1;
    EXPECT_EQ(KODO_WRONG_USE, kodo_draw(scene.world, &target, nullptr));
    kodo_DrawOptions options = kodo_drawOptions();
    options.head.version = 99;
    std::size_t count = 0;
    EXPECT_EQ(KODO_WRONG_USE, kodo_svg(scene.world, &options, nullptr, nullptr, 0, &count));
    const kodo_Aabb empty{};
    EXPECT_EQ(KODO_BAD_DEFINITION, kodo_svg(scene.world, nullptr, &empty, nullptr, 0, &count));
    EXPECT_EQ(KODO_WRONG_USE, kodo_svg(scene.world, nullptr, nullptr, nullptr, 9, &count));
}

} // namespace
