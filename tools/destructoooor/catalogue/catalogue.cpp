// SPDX-License-Identifier: MIT
#include <vector>

#include "scene.hpp"

namespace destructoooor {

std::span<const Scene> catalogue() {
    static const std::vector<Scene> all = [] {
        std::vector<Scene> scenes;
        for (const auto part : {stackingScenes(), surfaceScenes(), jointScenes(), machineScenes(),
                                geometryScenes(), fieldScenes(), principleScenes()}) {
            scenes.insert(scenes.end(), part.begin(), part.end());
        }
        return scenes;
    }();
    return all;
}

Staged stage(const Scene& scene, const kodo::StepSettings& settings) {
    Staged staged{kodo::World({.gravity = scene.gravity, .settings = settings}), {}};
    staged.ids = scene.build(staged.world);
    return staged;
}

} // namespace destructoooor
