// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/text_file.hpp>
#include <apart/core/toml_keys.hpp>
#include <kodo/kodo.hpp>

#include <string>
#include <string_view>
#include <vector>

/// Scenes as text, in TOML: tests/cross/README.md has the keys. The sandbox saves and loads them,
/// tools/crosscheck plays them beside Box2D.
namespace scene_files {
// In the engine's inline namespace, so that one program can read scenes in both precisions.
inline namespace KODO_PRECISION {

struct FileBody {
    std::string name;
    kodo::BodyDef def;
    /// Surface, density and filter of each part; empty: those of the body.
    std::vector<kodo::Part> parts;
    int line = 0; // from 1, in the file
    int nameLine = 0;
    std::vector<int> partLines; // of the shape of each part
};

struct FileJoint {
    /// BodyId::index of its ends is the place of the body in the file.
    kodo::JointDef def;
    int line = 0; // from 1, in the file
};

struct SceneFile {
    std::string title;
    double seconds = 0;   // how long it is worth to be seen; 0.1 to 120
    double rate = 60;     // steps a second
    kodo::Vec2 gravity{}; // m/s^2
    kodo::StepSettings settings{};
    std::vector<kodo::FieldEntry> fields; // beside gravity
    std::vector<FileBody> bodies;
    std::vector<FileJoint> joints;
};

/// Reads all tables but [[compare]]. Mistakes go to `keys`, each with its line; the scene is
/// complete if there are none.
SceneFile readScene(const toml::table& root, apart::TomlKeys& keys);
/// The same from a text. Mistakes are told with `file`, line and key.
apart::Read<SceneFile> readScene(std::string_view text, const std::string& file);

/// A World with the scene in it. Bodies have the order of the file.
kodo::World worldOf(const SceneFile& scene);

/// What the head of a file tells beside the World.
struct SceneHead {
    std::string title;
    double seconds = 10;
    double rate = 60;
};
/// The World as text. A World that is read from it has the same bodies, joints, fields and settings
/// to the bit, and gives the same text. A rotation in mid-motion may change by its last bit, since
/// World::add() normalises; the text of the World read is then the one that stays.
std::string sceneText(const kodo::World& world, const SceneHead& head);

/// What the World has and its text does not, as words: "own force fields". Empty: nothing that
/// matters at its start. Impulses of contacts are never held, so that a pile that stands goes on
/// with slightly other numbers.
std::string notHeld(const kodo::World& world);

} // namespace KODO_PRECISION
} // namespace scene_files
