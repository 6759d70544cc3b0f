// SPDX-License-Identifier: MIT
// Scenes of the sandbox as scenes of the benchmark: bodies and revolute joints, all that its
// engines have in common. They go the way of tools/sidebyside, by a scene file.
#include <catalogue/scene.hpp>
#include <cross/scene_reader.hpp>
#include <fmt/format.h>
#include <scene_files/scene_file.hpp>

#include <cmath>

#include "bench_scenes.hpp"

namespace bench {
namespace {

/// Throws WrongUse for what the benchmark has no equal of.
scenes::RevoluteJointDef jointOf(const crosscheck::Link& link) {
    if (link.kind != crosscheck::Link::Kind::RevoluteJoint || link.breakForce > 0 ||
        link.reference) {
        throw WrongUse("all joints of the benchmark are revolute, without a breaking force");
    }
    scenes::RevoluteJointDef joint{link.a, link.b, link.point, link.motorSpeed, link.motorTorque};
    if (link.limits) {
        joint.limits = {link.limits->lower, link.limits->upper};
    }
    return joint;
}

Scene sceneOf(const destructoooor::Scene& scene) {
    if (scene.act != nullptr) {
        throw WrongUse("the scene acts in each step, which only the sandbox does");
    }
    const std::string name(scene.name);
    const std::string text = scene_files::sceneText(stage(scene).world, {.title = name});
    const apart::Read<crosscheck::CrossScene> read = crosscheck::readScene(text, name);
    if (const auto* problem = std::get_if<apart::FileProblem>(&read)) {
        throw WrongUse(problem->texts().front());
    }
    const auto& played = std::get<crosscheck::CrossScene>(read);
    Scene made{played.def};
    if (!made.def.chains.empty()) {
        throw WrongUse("the benchmark has no chains");
    }
    for (const scenes::BodyDef& body : made.def.bodies) {
        for (const scenes::Part& part : body.parts) {
            if (std::holds_alternative<scenes::Capsule>(part)) {
                throw WrongUse("the benchmark measures no overlap of capsules");
            }
        }
    }
    for (const crosscheck::Link& link : played.links) {
        made.def.joints.push_back(jointOf(link));
    }
    return made;
}

} // namespace

std::vector<Recipe> sandboxRecipes() {
    std::vector<Recipe> all;
    for (const destructoooor::Scene& scene : destructoooor::catalogue()) {
        const int steps = static_cast<int>(std::lround(static_cast<double>(scene.seconds) / kDt));
        all.push_back({std::string(scene.name), std::string(scene.question), "", 1, steps,
                       [&scene](int, std::uint64_t) { return sceneOf(scene); }});
    }
    return all;
}

} // namespace bench
