// SPDX-License-Identifier: MIT
// Draws the pictures of the manual that no example draws: pictures FOLDER writes a file for each.
#include <kodo/kodo.hpp>

#include <array>
#include <cstdio>
#include <fstream>
#include <string>

namespace {

using kodo::Aabb;
using kodo::BodyId;
using kodo::BodyType;
using kodo::Vec2;
using kodo::World;

constexpr float kDt = 1.0f / 60; // s
const kodo::DrawStyle kPath{{255, 210, 70}};
const kodo::DrawStyle kText{{235, 235, 235}};

void run(World& world, int steps) {
    for (int step = 0; step < steps; ++step) {
        world.step(kDt);
    }
}

World groundWorld() {
    World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Plane{}, .type = BodyType::Static});
    return world;
}

/// The first program: a ball every sixth step of its fall.
std::string hello() {
    World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Box{20, 1}, .position = {0, -0.5f}, .type = BodyType::Static});
    const BodyId ball = world.add({.shape = kodo::Circle{0.5f}, .position = {0, 4}});
    kodo::SvgDraw picture({{-5, -0.7f}, {5, 4.8f}});
    for (int step = 0; step < 60; ++step) {
        if (step % 6 == 0) {
            picture.circle(world[ball].position(), 0.5f, {{120, 130, 150}});
        }
        world.step(kDt);
    }
    kodo::draw(world, picture, {.contacts = true});
    return picture.document();
}

/// Poses of steps, and the drawn one between two of them.
std::string step() {
    World world{{.gravity = {0, -10}}};
    const BodyId box = world.add({.shape = kodo::Box{0.6f, 0.6f},
                                  .position = {-4, 0},
                                  .velocity = {8, 6},
                                  .angularVelocity = 3});
    kodo::SvgDraw picture({{-5, -1}, {5, 2.8f}});
    for (int i = 0; i <= 5; ++i) {
        kodo::draw(world, picture, {.velocities = i < 5});
        picture.text(world[box].position() - Vec2{0, 0.7f}, "step " + std::to_string(i), kText);
        run(world, 12);
    }
    return picture.document();
}

std::string bodies() {
    World world = groundWorld();
    const BodyId lift =
        world.add({.shape = kodo::Box{2, 0.3f}, .position = {-3, 1}, .type = BodyType::Kinematic});
    world[lift].setVelocity({0, 0.5f});
    world.add({.shape = kodo::Box{1, 1}, .position = {-3, 1.65f}});
    world.add({.shape = kodo::Box{1, 1}, .position = {0, 0.5f}});
    world.add({.shape = kodo::Circle{0.5f},
               .position = {1.5f, 0.5f},
               .velocity = {1.5f, 0},
               .flags = kodo::kNeverSleep});
    world.add({.shape = kodo::Box{1.4f, 1.4f},
               .position = {5, 1},
               .type = BodyType::Static,
               .flags = kodo::kSensor});
    run(world, 60);
    kodo::SvgDraw picture({{-5, -0.8f}, {7, 3.2f}});
    kodo::draw(world, picture, {.velocities = true});
    picture.text({6, -0.4f}, "static", kText);
    picture.text({-3, 1}, "kinematic", kText);
    picture.text({0, 1.3f}, "asleep", kText);
    picture.text({3, 1.3f}, "awake", kText);
    picture.text({5, 2}, "sensor", kText);
    return picture.document();
}

std::string shapes() {
    World world;
    float x = 0;
    const auto add = [&](const kodo::Shape& shape) {
        world.add({.shape = shape, .position = {x, 0}, .type = BodyType::Static});
        x += 2.2f;
    };
    add(kodo::Circle{0.8f});
    add(kodo::Capsule{{-0.5f, -0.3f}, {0.5f, 0.3f}, 0.4f});
    add(kodo::Box{1.6f, 1});
    add(kodo::Box{.width = 1.2f, .height = 0.6f, .radius = 0.2f});
    add(kodo::Polygon{{{-0.8f, -0.6f}, {0.8f, -0.6f}, {0.4f, 0.6f}, {-0.6f, 0.4f}}});
    add(kodo::Compound{{kodo::Box{0.3f, 1.2f}, kodo::Circle{0.4f, {0, 0.6f}}}});
    add(kodo::Segment{.from = {-0.8f, -0.3f}, .to = {0.8f, 0.3f}, .oneSided = true});
    add(kodo::Point{});
    kodo::SvgDraw picture({{-1.4f, -1.6f}, {x - 0.8f, 1.4f}});
    kodo::draw(world, picture);
    const std::array<const char*, 8> names = {"Circle",  "Capsule",  "Box",     "radius",
                                              "Polygon", "Compound", "Segment", "Point"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        picture.text({2.2f * static_cast<float>(i), -1.3f}, names[i], kText);
    }
    return picture.document();
}

/// Four boxes with different friction that began at one place of a slope of 1 : 3.
std::string materials() {
    kodo::SvgDraw picture({{-6.2f, -0.6f}, {6.2f, 5}});
    World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Chain{.points = {{-6, 4}, {6, 0}}},
               .material = kodo::withFriction(1),
               .type = BodyType::Static,
               .flags = 1});
    for (const float friction : {0.0f, 0.15f, 0.25f, 0.6f}) {
        world.add({.shape = kodo::Box{0.8f, 0.5f},
                   .position = {-4.7f, 3.84f},
                   .rotation = kodo::Rot::fromAngle(-0.32175f),
                   .material = kodo::withFriction(friction * friction), // mixed with 1
                   .flags = kodo::kMatchAny,                            // boxes pass each other
                   .required = 1});
    }
    run(world, 100);
    kodo::draw(world, picture);
    for (const auto& [index, name] :
         {std::pair(1u, "0"), std::pair(2u, "0.15"), std::pair(3u, "0.25"), std::pair(4u, "0.6")}) {
        picture.text(world[world.bodies()[index]].position() + Vec2{0.2f, 0.5f}, name, kText);
    }
    return picture.document();
}

std::string records() {
    World world = groundWorld();
    for (int i = 0; i < 3; ++i) {
        world.add({.shape = kodo::Box{1.6f, 1},
                   .position = {0.1f * static_cast<float>(i), 0.5f + static_cast<float>(i)}});
    }
    world.add({.shape = kodo::Circle{0.6f}, .position = {3, 0.6f}});
    run(world, 20);
    return kodo::svg(world, {.contacts = true, .impulses = true, .metresPerImpulse = 1.5f},
                     Aabb{{-3, -0.6f}, {5, 3.4f}});
}

/// A joint of each kind, between a static disc above and a box below it.
std::string joints() {
    World world{{.gravity = {0, -10}}};
    kodo::SvgDraw picture({{-1.4f, -2.9f}, {13.4f, 0.8f}});
    float x = 0;
    const auto ends = [&](const char* name, float drop, Vec2 anchorB) {
        const BodyId a =
            world.add({.shape = kodo::Circle{0.25f}, .position = {x, 0}, .type = BodyType::Static});
        const BodyId b = world.add({.shape = kodo::Box{0.7f, 0.7f}, .position = {x, -drop}});
        picture.text({x, -2.6f}, name, kText);
        x += 2.4f;
        return kodo::JointEnds{.a = a, .b = b, .anchorB = anchorB};
    };
    world.add(kodo::RevoluteJoint{.ends = ends("revolute", 1, {0, 1})});
    world.add(kodo::FixedJoint{.ends = ends("fixed", 1, {0, 1})});
    world.add(kodo::DistanceJoint{.ends = ends("spring", 1.6f, {}), .length = 1.5f, .hertz = 2});
    world.add(kodo::DistanceJoint{.ends = ends("rope", 1.5f, {}), .limits = kodo::Range{0, 1.5f}});
    world.add(kodo::PrismaticJoint{
        .ends = ends("prismatic", 1, {}), .axis = {0, 1}, .limits = kodo::Range{-1.6f, -0.6f}});
    world.add(kodo::MotorJoint{.ends = ends("motor", 1.2f, {}), .force = 20});
    run(world, 10);
    kodo::draw(world, picture);
    return picture.document();
}

/// A ray to its first hit, a cast disc, and the closest point of the mouse.
std::string queries() {
    World world = groundWorld();
    world.add({.shape = kodo::Box{1, 2}, .position = {2, 1}, .type = BodyType::Static});
    world.add({.shape = kodo::Circle{0.7f}, .position = {5, 0.7f}, .type = BodyType::Static});
    kodo::SvgDraw picture({{-4, -0.6f}, {7, 4}});
    kodo::draw(world, picture);
    if (const auto hit = kodo::rayCast(world, {-3, 2.6f}, {4, 0.2f})) {
        picture.line({-3, 2.6f}, hit->point, kPath);
        picture.point(hit->point, kPath);
        picture.arrow(hit->point, hit->point + hit->normal, kPath);
    }
    const Vec2 start{3.5f, 3.5f};
    const Vec2 move{1, -4};
    if (const auto hit = kodo::shapeCast(world, kodo::Circle{0.3f}, {start, {}}, move)) {
        picture.circle(start, 0.3f, kPath);
        picture.line(start, start + hit->fraction * move, kPath);
        picture.circle(start + hit->fraction * move, 0.3f, kPath);
    }
    if (const auto closest = kodo::closestPoint(world, {-1, 1.4f}, 10)) {
        picture.point({-1, 1.4f}, kPath);
        picture.arrow({-1, 1.4f}, closest->point, kPath);
    }
    picture.text({-2.4f, 2.9f}, "rayCast", kText);
    picture.text({4.6f, 3.5f}, "shapeCast", kText);
    picture.text({-1.2f, 0.5f}, "closestPoint", kText);
    return picture.document();
}

/// One of two equal piles was hit, so it is awake.
std::string sleep() {
    World world = groundWorld();
    for (const float x : {-4.0f, 0.0f}) {
        for (int row = 0; row < 3; ++row) {
            for (int i = 0; i < 3 - row; ++i) {
                world.add({.shape = kodo::Box{0.9f, 0.9f},
                           .position = {x + static_cast<float>(i) + 0.5f * static_cast<float>(row),
                                        0.45f + 0.9f * static_cast<float>(row)}});
            }
        }
    }
    run(world, 90);
    world.add({.shape = kodo::Circle{0.4f}, .position = {4, 1}, .velocity = {-12, 2}});
    run(world, 12);
    return kodo::svg(world, {.velocities = true}, Aabb{{-5, -0.6f}, {5, 3.4f}});
}

struct Picture {
    const char* name;
    std::string (*draw)();
};
constexpr std::array<Picture, 9> kPictures = {{{"hello", hello},
                                               {"step", step},
                                               {"bodies", bodies},
                                               {"shapes", shapes},
                                               {"materials", materials},
                                               {"records", records},
                                               {"joints", joints},
                                               {"queries", queries},
                                               {"sleep", sleep}}};

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("Usage: pictures FOLDER\n", stderr);
        return 2;
    }
    for (const Picture& picture : kPictures) {
        std::ofstream file(std::string(argv[1]) + "/" + picture.name + ".svg");
        file << picture.draw();
        if (!file) {
            std::fprintf(stderr, "cannot write %s.svg in %s\n", picture.name, argv[1]);
            return 1;
        }
    }
}
