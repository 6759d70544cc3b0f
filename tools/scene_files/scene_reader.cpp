// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <utility>

#include "scene_keys.hpp"
#include "scene_tables.hpp"

namespace scene_files {
inline namespace KODO_PRECISION {
namespace {

using apart::TomlKeys;
using kodo::Real;
using kodo::Vec2;

class Reader {
public:
    explicit Reader(TomlKeys& keys) : keys_(keys) {}

    SceneFile read(const toml::table& root) {
        keys_.onlyKeys(root,
                       {"title", "seconds", "rate", "gravity", "settings", "field", "body", "joint",
                        "compare"},
                       "");
        Table head(keys_, root);
        scene_.title = head.has("title") ? head.text("title") : "A scene of your own";
        head.need("seconds");
        scene_.seconds = head.number("seconds", 0.1, 120, 1);
        scene_.rate = head.number("rate", 10, 1000, 60);
        scene_.gravity = head.pair("gravity").value_or(Vec2{0, -10});
        if (const toml::node* settings = head.get("settings")) {
            readSettings(*settings);
        }
        eachOf(keys_, root.get("field"), "field",
               [&](const toml::table& table) { readField(table); });
        eachOf(keys_, root.get("body"), "body",
               [&](const toml::table& table) { addBody(readBody(keys_, table)); });
        if (scene_.bodies.empty() && keys_.faults() == 0) {
            keys_.fail(0, "the scene has no body: add [[body]]");
        }
        eachOf(keys_, root.get("joint"), "joint", [&](const toml::table& table) {
            scene_.joints.push_back(readJoint(keys_, table, scene_.bodies));
        });
        return std::move(scene_);
    }

private:
    void readSettings(const toml::node& node) {
        const toml::table* own = node.as_table();
        if (own == nullptr) {
            keys_.fail(TomlKeys::lineOf(node), "settings must be written as [settings]");
            return;
        }
        Table table(keys_, *own);
        table.onlyKeys({"solver", "substeps", "impact_passes", "contact_passes", "shock_passes",
                        "contact_hertz", "contact_damping", "joint_hertz", "joint_damping",
                        "joint_gap", "push_speed", "sleep_steps", "leave_out"},
                       "settings.");
        const std::size_t solver = table.choice("solver", kSolvers).value_or(0);
        if (solver == 1) {
            scene_.settings.solver = kodo::PropagationSettings{};
        }
        std::visit([&](auto& settings) { solverKeys(table, settings); }, scene_.settings.solver);
        table.take("sleep_steps", scene_.settings, &kodo::StepSettings::sleepSteps);
        if (const toml::node* list = table.get("leave_out")) {
            readFeatures(table, *list);
        }
        table.noOther("settings of the solver " + std::string(kSolvers[solver]));
        if (const auto problem = kodo::check(scene_.settings)) {
            table.fail(*problem);
        }
    }

    void readFeatures(Table& table, const toml::node& node) {
        const toml::array* list = node.as_array();
        bool good = list != nullptr;
        for (std::size_t i = 0; good && i < list->size(); ++i) {
            const std::optional<std::string_view> name = list->get(i)->value<std::string_view>();
            const auto* const found =
                std::find(kFeatures.begin(), kFeatures.end(), name.value_or(""));
            good = found != kFeatures.end();
            scene_.settings.leaveOut |=
                good ? static_cast<kodo::Feature>(1u << (found - kFeatures.begin()))
                     : kodo::Features{};
        }
        if (!good) {
            table.fail("leave_out", "must be a list of features, as [\"sleep\", \"friction\"]");
        }
    }

    void readField(const toml::table& own) {
        Table table(keys_, own);
        table.onlyKeys({"kind", "acceleration", "linear", "quadratic", "velocity", "lower", "upper",
                        "law", "center", "strength", "softening", "density", "drag", "surface",
                        "gravity", "collides", "with", "group"},
                       "field.");
        table.need("kind");
        const std::size_t before = keys_.faults();
        const std::size_t kind = table.choice("kind", kFieldKinds).value_or(0);
        if (kind == 0) {
            if (keys_.faults() == before && table.has("kind")) {
                table.fail("kind", "own has no text");
            }
            return;
        }
        kodo::FieldEntry entry{fieldOf(table, static_cast<kodo::FieldKind>(kind)),
                               readMatch(table)};
        table.noOther("a field of kind " + std::string(kFieldKinds[kind]));
        try {
            kodo::World scratch;
            scratch.addField(entry);
        } catch (const kodo::BadDefinition& error) {
            table.fail(error.problem());
        }
        scene_.fields.push_back(std::move(entry));
    }

    static std::shared_ptr<const kodo::ForceField> fieldOf(Table& table, kodo::FieldKind kind) {
        const auto vec = [&](const char* key) { return table.pair(key).value_or(Vec2{}); };
        const auto real = [&](const char* key) {
            return static_cast<Real>(table.number(key).value_or(0));
        };
        const auto law = [&] { return kodo::DragLaw{real("linear"), real("quadratic")}; };
        if (kind == kodo::FieldKind::Gravity) {
            return std::make_shared<kodo::Gravity>(vec("acceleration"));
        }
        if (kind == kodo::FieldKind::Drag) {
            return std::make_shared<kodo::Drag>(law(), vec("velocity"));
        }
        if (kind == kodo::FieldKind::Wind) {
            const std::optional<Vec2> lower = table.pair("lower");
            const std::optional<Vec2> upper = table.pair("upper");
            return std::make_shared<kodo::Wind>(
                law(), vec("velocity"),
                lower && upper ? std::optional(kodo::Aabb{*lower, *upper}) : std::nullopt);
        }
        if (kind == kodo::FieldKind::Attractor) {
            const std::size_t by = table.choice("law", kAttractorLaws).value_or(0);
            return std::make_shared<kodo::Attractor>(static_cast<kodo::Attractor::Law>(by),
                                                     vec("center"), real("strength"),
                                                     real("softening"));
        }
        return std::make_shared<kodo::Buoyancy>(
            kodo::Buoyancy::Fluid{real("density"), real("drag")}, vec("surface"), vec("gravity"));
    }

    void addBody(FileBody body) {
        const auto same = std::find_if(scene_.bodies.begin(), scene_.bodies.end(),
                                       [&](const FileBody& one) { return one.name == body.name; });
        if (same != scene_.bodies.end() && !body.name.empty()) {
            keys_.fail(body.nameLine, "name " + body.name + " is that of another body");
        }
        scene_.bodies.push_back(std::move(body));
    }

    TomlKeys& keys_;
    SceneFile scene_;
};

} // namespace

SceneFile readScene(const toml::table& root, apart::TomlKeys& keys) {
    return Reader(keys).read(root);
}

apart::Read<SceneFile> readScene(std::string_view text, const std::string& file) {
    const apart::Read<toml::table> root = apart::parseToml(text, file);
    if (const auto* problem = std::get_if<apart::FileProblem>(&root)) {
        return *problem;
    }
    apart::TomlKeys keys(file);
    SceneFile scene = readScene(std::get<toml::table>(root), keys);
    if (const auto problem = keys.problem()) {
        return *problem;
    }
    return scene;
}

kodo::World worldOf(const SceneFile& scene) {
    kodo::World world({.gravity = scene.gravity, .settings = scene.settings});
    for (const kodo::FieldEntry& entry : scene.fields) {
        world.addField(entry);
    }
    std::vector<kodo::BodyId> ids;
    for (const FileBody& body : scene.bodies) {
        ids.push_back(world.add(body.def));
        for (std::size_t i = 0; i < body.parts.size(); ++i) {
            kodo::Part part = std::as_const(world)[ids.back()].part(i);
            part.material = body.parts[i].material;
            part.density = body.parts[i].density;
            part.filter = body.parts[i].filter;
            world[ids.back()].setPart(i, part);
        }
        if (!body.parts.empty() && body.def.mass) {
            world[ids.back()].setMass(*body.def.mass);
        }
        if (!body.parts.empty()) { // the centre of mass may have moved
            world[ids.back()].setPosition(body.def.position);
            if (body.def.type != kodo::BodyType::Static) {
                world[ids.back()].setVelocity(body.def.velocity);
            }
        }
    }
    for (const FileJoint& joint : scene.joints) {
        kodo::JointDef def = joint.def;
        std::visit(
            [&](auto& one) {
                if constexpr (requires { one.ends; }) {
                    one.ends.a = ids.at(one.ends.a.index);
                    one.ends.b = ids.at(one.ends.b.index);
                } else {
                    one.body = ids.at(one.body.index);
                }
            },
            def);
        world.add(def);
    }
    return world;
}

} // namespace KODO_PRECISION
} // namespace scene_files
