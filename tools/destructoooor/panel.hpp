// SPDX-License-Identifier: MIT
#pragma once

#include "workbench.hpp"

namespace destructoooor {

/// The panels around the scene, by Dear ImGui: scenes on the left, dials and measures on the right,
/// hands and time below.
class Panel {
public:
    /// Adds the panels to the present frame of ImGui. Tells the workbench which part is free.
    void build(Workbench& bench, kodo_sfml::Size pixels);

private:
    void scenes(Workbench& bench);
    void sceneList(Workbench& bench);
    void about(Workbench& bench);
    void dialTab(Workbench& bench);
    void measureTab(const Workbench& bench);
    void viewTab(Workbench& bench);
    void fileTab(Workbench& bench);
    void timeBar(Workbench& bench);

    char file_[256] = "scene.toml";
    std::size_t shown_ = static_cast<std::size_t>(-1); // scene whose group was opened
};

} // namespace destructoooor
