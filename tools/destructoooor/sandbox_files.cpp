// SPDX-License-Identifier: MIT
#include <scene_files/scene_file.hpp>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "sandbox.hpp"

namespace destructoooor {

namespace {

bool isText(const std::string& file) {
    return file.ends_with(".toml");
}

} // namespace

std::string Sandbox::text() const {
    const bool ofFile = !fileTitle_.empty();
    return scene_files::sceneText(
        world_, {.title = ofFile ? fileTitle_ : std::string(scene().name),
                 .seconds = ofFile ? fileSeconds_ : static_cast<double>(judgedAfter())});
}

std::string Sandbox::notHeld() const {
    const std::string rest = scene_files::notHeld(world_);
    const std::string acts = act_ != nullptr ? "what the scene does in each step" : "";
    return acts + (acts.empty() || rest.empty() ? "" : ", ") + rest;
}

void Sandbox::takeText(std::string_view text, const std::string& file) {
    const apart::Read<scene_files::SceneFile> read = scene_files::readScene(text, file);
    if (const auto* const problem = std::get_if<apart::FileProblem>(&read)) {
        std::string all;
        for (const std::string& line : problem->texts()) {
            all += (all.empty() ? "" : "\n") + line;
        }
        throw std::runtime_error(all);
    }
    const auto& scene = std::get<scene_files::SceneFile>(read);
    try {
        adopt(scene_files::worldOf(scene));
    } catch (const kodo::BadDefinition& error) {
        throw std::runtime_error(file + ": " + error.what());
    }
    fileTitle_ = scene.title;
    fileSeconds_ = scene.seconds;
}

void Sandbox::save(const std::string& file) const {
    std::ofstream out(file, std::ios::binary);
    if (isText(file)) {
        out << text();
    } else {
        const std::vector<std::byte> bytes = kodo::toBytes(world_);
        out.write(reinterpret_cast<const char*>(bytes.data()),
                  static_cast<std::streamsize>(bytes.size()));
    }
    if (!out.flush()) {
        throw std::runtime_error("The World cannot be written to " + file + ".");
    }
}

void Sandbox::load(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) {
        throw std::runtime_error("There is no file " + file + ".");
    }
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (isText(file)) {
        takeText(text, file);
        return;
    }
    try {
        take(std::as_bytes(std::span(text)));
    } catch (const kodo::BadSnapshot& error) {
        throw std::runtime_error(file + ": " + error.what());
    }
}

} // namespace destructoooor
