// SPDX-License-Identifier: MIT
#pragma once

#include <scene_files/scene_file.hpp>

#include <string>
#include <vector>

#include "cross_scene.hpp"

namespace crosscheck {

/// A scene file as all engines play it.
struct PlayedScene {
    scenes::SceneDef def;
    std::vector<Link> links;
    std::vector<std::string> names;   // of def.bodies
    std::vector<std::size_t> drawn{}; // bodies whose paths are drawn
};

/// Tells what Box2D 2.4.1 has no equal of, each with its line.
PlayedScene playedScene(const scene_files::SceneFile& file, apart::TomlKeys& keys);

} // namespace crosscheck
