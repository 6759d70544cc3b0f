// SPDX-License-Identifier: MIT
// From a scene file to what both engines can play. Box2D sets the limits.
#include "scene_reader.hpp"

#include <apart/core/toml_keys.hpp>

#include <scene_files/scene_table.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "played_scene.hpp"
#include "scene_comparison.hpp"

namespace crosscheck {
namespace {

using apart::TomlKeys;
using scene_files::Table;

constexpr std::size_t kMostBodies = 500;
constexpr double kMostPlaces = 3e6; // bodies times steps

std::string shortly(double number) {
    std::string digits = std::to_string(number);
    digits.erase(digits.find_last_not_of('0') + 1);
    return digits.back() == '.' ? digits.substr(0, digits.size() - 1) : digits;
}

class Reader {
public:
    explicit Reader(const std::string& file) : keys_(file) {}

    apart::Read<CrossScene> read(const toml::table& root) {
        const scene_files::SceneFile file = scene_files::readScene(root, keys_);
        CrossScene scene;
        scene.name = "OwnScene";
        scene.title = file.title;
        rate_ = file.rate;
        steps_ = std::lround(file.seconds * rate_);
        scene.text = shortly(file.seconds) + " s in steps of 1/" + shortly(rate_) + " s.";
        played_ = playedScene(file, keys_);
        if (!file.fields.empty()) {
            keys_.fail(TomlKeys::lineOf(*root.get("field")), "field: Box2D has no force fields");
        }
        scene.def = played_.def;
        scene.drawn = played_.drawn;
        scene.links = played_.links;
        checkSizes(scene);
        std::vector<Comparison> comparisons;
        scene_files::eachOf(keys_, root.get("compare"), "compare", [&](const toml::table& table) {
            comparisons.push_back(readComparison(table, scene));
        });
        if (comparisons.empty()) {
            comparisons.push_back({.what = What::Energy, .step = steps_});
            figure(scene, "energy", "J");
        }
        if (const auto problem = keys_.problem()) {
            return *problem;
        }
        scene.measure = [measure = Measure(scene.def, played_.links, comparisons, rate_),
                         steps = steps_](Engine& engine) { return measure(engine, steps); };
        return scene;
    }

private:
    void checkSizes(const CrossScene& scene) {
        const std::size_t bodies = scene.def.bodies.size();
        if (bodies > kMostBodies) {
            keys_.fail(0, std::to_string(bodies) + " bodies; at most " +
                              std::to_string(kMostBodies) + " are played");
        } else if (static_cast<double>(bodies) * static_cast<double>(steps_) > kMostPlaces) {
            keys_.fail(0,
                       "bodies times seconds times rate must be at most " + shortly(kMostPlaces));
        } else if (scene.drawn.empty() && bodies > 0 && keys_.faults() == 0) {
            keys_.fail(0, "no body can move");
        }
    }

    std::size_t bodyOf(Table& table, const std::string& key) {
        table.need(key);
        const std::string name = table.has(key) ? table.text(key) : std::string();
        const auto found = std::find(played_.names.begin(), played_.names.end(), name);
        if (found == played_.names.end() && !name.empty()) {
            table.fail(key, "must be the name of a body; there is no " + name);
        }
        return found == played_.names.end()
                   ? 0
                   : static_cast<std::size_t>(found - played_.names.begin());
    }

    std::pair<std::size_t, std::size_t> twoBodies(Table& table) {
        const std::size_t before = keys_.faults();
        const std::size_t a = bodyOf(table, "a");
        const std::size_t b = bodyOf(table, "b");
        if (a == b && keys_.faults() == before) {
            keys_.fail(table.line(), "a and b must be two bodies");
        }
        return {a, b};
    }

    Comparison readComparison(const toml::table& own, CrossScene& scene) {
        Table table(keys_, own);
        keys_.onlyKeys(own, {"what", "body", "a", "b", "time", "exact", "tolerance", "reason"},
                       "compare.");
        Comparison one;
        std::array<std::string_view, kWhats.size()> names;
        std::transform(kWhats.begin(), kWhats.end(), names.begin(),
                       [](const WhatWords& words) { return words.name; });
        table.need("what");
        one.what = static_cast<What>(table.choice("what", names).value_or(0));
        const WhatWords& words = kWhats[static_cast<std::size_t>(one.what)];
        std::string said(words.name);
        if (one.what == What::Touch || one.what == What::Impulse) {
            table.noUse({"body"}, "a comparison of " + said);
            std::tie(one.a, one.b) = twoBodies(table);
            said += " of " + nameOf(one.a) + " and " + nameOf(one.b);
        } else if (one.what == What::Energy) {
            table.noUse({"body", "a", "b"}, "a comparison of " + said);
        } else {
            table.noUse({"a", "b"}, "a comparison of " + said);
            one.a = bodyOf(table, "body");
            said += " of " + nameOf(one.a);
        }
        const double end = static_cast<double>(steps_) / rate_;
        const double time = table.number("time", 0, end, end);
        one.step = std::lround(time * rate_);
        said += table.has("time") ? " at " + shortly(time) + " s" : "";
        judge(table, figure(scene, said, std::string(words.unit)));
        return one;
    }

    void judge(Table& table, FigureAdder added) {
        const std::string reason =
            table.has("reason") ? table.text("reason") : std::string("as the scene says");
        if (table.has("exact")) {
            table.need("tolerance");
            added.kodoExact(table.number("exact", -1e9, 1e9, 0),
                            table.number("tolerance", 0, 1e9, 0), reason);
        } else if (table.has("tolerance")) {
            added.agree(table.number("tolerance", 0, 1e9, 0), reason);
        } else {
            table.noUse({"reason"}, "a comparison without tolerance");
        }
    }

    std::string nameOf(std::size_t body) const {
        return body < played_.names.size() ? played_.names[body] : std::string();
    }

    TomlKeys keys_;
    PlayedScene played_;
    double rate_ = 60; // steps a second
    long steps_ = 0;
};

} // namespace

apart::Read<CrossScene> readScene(std::string_view text, const std::string& file) {
    apart::Read<toml::table> root = apart::parseToml(text, file);
    if (auto* problem = std::get_if<apart::FileProblem>(&root)) {
        return *problem;
    }
    return Reader(file).read(std::get<toml::table>(root));
}

} // namespace crosscheck
