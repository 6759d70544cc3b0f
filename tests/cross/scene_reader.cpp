// SPDX-License-Identifier: MIT
#include "scene_reader.hpp"

#include <apart/core/toml_keys.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <utility>

#include "scene_comparison.hpp"

namespace crosscheck {
namespace {

using apart::TomlKeys;
using scenes::Vec2;

constexpr double kSmallest = 0.05;   // m; Box2D's skin takes 1 cm of each side
constexpr double kLargest = 1000;    // m
constexpr double kFarthest = 10'000; // m
constexpr double kFastest = 1000;    // m/s or rad/s
constexpr std::size_t kMostBodies = 500;
constexpr std::size_t kMostCorners = 8; // of Box2D
constexpr double kMostPlaces = 3e6;     // bodies times steps
constexpr std::size_t kMostPaths = 20;  // drawn

constexpr std::array<std::string_view, 3> kTypes{"dynamic", "static", "kinematic"};
constexpr std::array<std::string_view, 5> kKinds{"revolute", "fixed", "distance", "rope",
                                                 "prismatic"}; // in the order of Link::Kind

std::string shortly(double number) {
    std::string digits = std::to_string(number);
    digits.erase(digits.find_last_not_of('0') + 1);
    return digits.back() == '.' ? digits.substr(0, digits.size() - 1) : digits;
}

class Reader {
public:
    explicit Reader(const std::string& file) : keys_(file) {}

    apart::Read<CrossScene> read(const toml::table& root) {
        keys_.onlyKeys(root, {"title", "seconds", "rate", "gravity", "body", "joint", "compare"},
                       "");
        CrossScene scene;
        scene.name = "OwnScene";
        scene.title = root.contains("title") ? keys_.text(root, "title") : "A scene of your own";
        const double seconds = real(root, "seconds", 0.1, 120);
        rate_ = real(root, "rate", 10, 1000, 60);
        steps_ = std::lround(seconds * rate_);
        scene.text = shortly(seconds) + " s in steps of 1/" + shortly(rate_) + " s.";
        scene.def.gravity = point(root, "gravity", kFastest, scenes::kDown);
        eachOf(root, "body", [&](const toml::table& table) { readBody(table, scene); });
        if (scene.def.bodies.empty() && keys_.faults() == 0) {
            keys_.fail(0, "the scene has no body: add [[body]]");
        }
        checkSizes(scene);
        std::vector<Link> links;
        eachOf(root, "joint", [&](const toml::table& table) {
            links.push_back(readJoint(table, scene.def.bodies));
        });
        std::vector<Comparison> comparisons;
        eachOf(root, "compare", [&](const toml::table& table) {
            comparisons.push_back(readComparison(table, scene));
        });
        if (comparisons.empty() && keys_.faults() == 0) {
            keys_.fail(0, "the scene compares nothing: add [[compare]]");
        }
        if (const auto problem = keys_.problem()) {
            return *problem;
        }
        scene.measure = [measure = Measure(scene.def, links, comparisons, rate_),
                         steps = steps_](Engine& engine) { return measure(engine, steps); };
        return scene;
    }

private:
    template <typename Take>
    void eachOf(const toml::table& root, const std::string& key, Take take) {
        const toml::node* node = root.get(key);
        if (node == nullptr) {
            return;
        }
        const toml::array* list = node->as_array();
        if (list == nullptr || !list->is_homogeneous(toml::node_type::table)) {
            keys_.fail(TomlKeys::lineOf(*node), key + " must be written as [[" + key + "]]");
            return;
        }
        for (const toml::node& one : *list) {
            take(*one.as_table());
        }
    }

    static std::optional<double> numberOf(const toml::node& node) {
        return node.is_number() ? node.value<double>() : std::nullopt;
    }

    double real(const toml::table& table, const std::string& key, double low, double high,
                std::optional<double> otherwise = {}) {
        const toml::node* node = table.get(key);
        if (node == nullptr) {
            if (!otherwise) {
                keys_.missing(table, key);
            }
            return otherwise.value_or(low);
        }
        const std::optional<double> value = numberOf(*node);
        if (!value || !(*value >= low && *value <= high)) {
            keys_.fail(TomlKeys::lineOf(*node),
                       key + " must be a number from " + shortly(low) + " to " + shortly(high));
            return otherwise.value_or(low);
        }
        return *value;
    }

    Vec2 pointOf(const toml::node& node, const std::string& key, double most) {
        const toml::array* list = node.as_array();
        if (list != nullptr && list->size() == 2) {
            const std::optional<double> x = numberOf(*list->get(0));
            const std::optional<double> y = numberOf(*list->get(1));
            if (x && y && std::abs(*x) <= most && std::abs(*y) <= most) {
                return {*x, *y};
            }
        }
        keys_.fail(TomlKeys::lineOf(node), key + " must be two numbers from -" + shortly(most) +
                                               " to " + shortly(most) + ", as [1, 2]");
        return {};
    }

    Vec2 point(const toml::table& table, const std::string& key, double most,
               std::optional<Vec2> otherwise = {}) {
        const toml::node* node = table.get(key);
        if (node != nullptr) {
            return pointOf(*node, key, most);
        }
        if (!otherwise) {
            keys_.missing(table, key);
        }
        return otherwise.value_or(Vec2{});
    }

    void noUse(const toml::table& table, std::initializer_list<std::string_view> keys,
               const std::string& where) {
        for (const std::string_view key : keys) {
            if (const toml::node* node = table.get(key)) {
                keys_.fail(TomlKeys::lineOf(*node), std::string(key) + " has no use in " + where);
            }
        }
    }

    std::optional<scenes::Part> readPart(const toml::table& table, Vec2 at) {
        const auto has = [&](const char* key) { return table.contains(key) ? 1 : 0; };
        if (has("box") + has("circle") + has("polygon") != 1) {
            keys_.fail(TomlKeys::lineOf(table), "one of box, circle and polygon is needed");
            return std::nullopt;
        }
        if (has("circle") == 1) {
            return scenes::Circle{real(table, "circle", kSmallest / 2, kLargest), at};
        }
        if (has("box") == 1) {
            const Vec2 size = point(table, "box", kLargest);
            if (size.x < kSmallest || size.y < kSmallest) {
                keys_.fail(TomlKeys::lineOf(*table.get("box")),
                           "box must be a width and a height of at least " + shortly(kSmallest));
            }
            return scenes::Box{size.x, size.y, at};
        }
        return readPolygon(*table.get("polygon"), at);
    }

    std::optional<scenes::Part> readPolygon(const toml::node& node, Vec2 at) {
        const toml::array* list = node.as_array();
        if (list == nullptr || list->size() < 3 || list->size() > kMostCorners) {
            keys_.fail(TomlKeys::lineOf(node), "polygon must have 3 to 8 corners, as [[0, 0], "
                                               "[1, 0], [0, 1]]");
            return std::nullopt;
        }
        scenes::Polygon polygon;
        for (const toml::node& corner : *list) {
            polygon.corners.push_back(at + pointOf(corner, "a corner of polygon", kLargest));
        }
        const std::size_t count = polygon.corners.size();
        for (std::size_t i = 0; i < count; ++i) {
            const Vec2 start = polygon.corners[i];
            const Vec2 edge = polygon.corners[(i + 1) % count] - start;
            double width = 0;
            for (std::size_t k = 2; k < count; ++k) {
                const double beside =
                    cross(edge, polygon.corners[(i + k) % count] - start) / sizeOf(edge);
                if (!(beside > 0)) {
                    keys_.fail(TomlKeys::lineOf(node),
                               "polygon must be convex, with its corners counter-clockwise");
                    return std::nullopt;
                }
                width = std::max(width, beside);
            }
            if (width < kSmallest) {
                keys_.fail(TomlKeys::lineOf(node),
                           "polygon must be at least " + shortly(kSmallest) + " wide");
                return std::nullopt;
            }
        }
        return polygon;
    }

    void readParts(const toml::table& table, scenes::BodyDef& body) {
        if (!table.contains("parts")) {
            if (const auto part = readPart(table, {})) {
                body.parts.push_back(*part);
            }
            return;
        }
        noUse(table, {"box", "circle", "polygon"}, "a body with parts");
        eachOf(table, "parts", [&](const toml::table& one) {
            keys_.onlyKeys(one, {"box", "circle", "polygon", "at"}, "parts.");
            if (const auto part = readPart(one, point(one, "at", kLargest, Vec2{}))) {
                body.parts.push_back(*part);
            }
        });
    }

    void readBody(const toml::table& table, CrossScene& scene) {
        keys_.onlyKeys(table,
                       {"name", "type", "box", "circle", "polygon", "parts", "position", "angle",
                        "velocity", "spin", "density", "friction", "restitution", "weightless",
                        "upright", "sensor"},
                       "body.");
        scenes::BodyDef body;
        const std::string name = keys_.text(table, "name");
        const auto [taken, added] = names_.emplace(name, scene.def.bodies.size());
        if (!added && !name.empty()) {
            keys_.fail(TomlKeys::lineOf(*table.get("name")),
                       "name " + name + " is that of another body");
        }
        readParts(table, body);
        body.position = point(table, "position", kFarthest);
        const double angle = real(table, "angle", -kFastest, kFastest, 0);
        body.rotation = {std::cos(angle), std::sin(angle)};
        body.velocity = point(table, "velocity", kFastest, Vec2{});
        body.spin = real(table, "spin", -kFastest, kFastest, 0);
        body.density = real(table, "density", 1e-3, 1e6, 1);
        body.material.friction = real(table, "friction", 0, 10, body.material.friction);
        body.material.restitution = real(table, "restitution", 0, 1, 0);
        body.weightless = keys_.flag(table, "weightless");
        body.upright = keys_.flag(table, "upright");
        body.sensor = keys_.flag(table, "sensor");
        const std::size_t type = keys_.choice(table, "type", kTypes).value_or(0);
        body.locked = type != 0;
        if (body.locked) {
            noUse(table, {"density", "weightless", "upright"},
                  "a " + std::string(kTypes[type]) + " body");
        }
        const bool moves = body.spin != 0 || dot(body.velocity, body.velocity) > 0;
        if (type == 1) {
            noUse(table, {"velocity", "spin"}, "a static body");
        } else if (type == 2 && !moves) {
            keys_.fail(TomlKeys::lineOf(table), "a kinematic body needs a velocity or a spin");
        }
        if ((!body.locked || moves) && scene.drawn.size() < kMostPaths) {
            scene.drawn.push_back(scene.def.bodies.size());
        }
        bodyNames_.push_back(name);
        scene.def.bodies.push_back(std::move(body));
    }

    void checkSizes(CrossScene& scene) {
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

    std::size_t bodyOf(const toml::table& table, const std::string& key) {
        if (!table.contains(key)) {
            keys_.missing(table, key);
            return 0;
        }
        const std::string name = keys_.text(table, key);
        const auto found = names_.find(name);
        if (found == names_.end() && !name.empty()) {
            keys_.fail(TomlKeys::lineOf(*table.get(key)),
                       key + " must be the name of a body; there is no " + name);
        }
        return found == names_.end() ? 0 : found->second;
    }

    std::pair<std::size_t, std::size_t> twoBodies(const toml::table& table) {
        const std::size_t before = keys_.faults();
        const std::size_t a = bodyOf(table, "a");
        const std::size_t b = bodyOf(table, "b");
        if (a == b && keys_.faults() == before) {
            keys_.fail(TomlKeys::lineOf(table), "a and b must be two bodies");
        }
        return {a, b};
    }

    Link readJoint(const toml::table& table, const std::vector<scenes::BodyDef>& bodies) {
        using Kind = Link::Kind;
        keys_.onlyKeys(table,
                       {"kind", "a", "b", "at", "to", "axis", "motor_speed", "motor_torque",
                        "motor_force", "limit", "hertz", "damping"},
                       "joint.");
        Link link;
        if (!table.contains("kind")) {
            keys_.missing(table, "kind");
        }
        link.kind = keys_.choice(table, "kind", kKinds, Kind::RevoluteJoint);
        std::tie(link.a, link.b) = twoBodies(table);
        if (std::max(link.a, link.b) < bodies.size() && bodies[link.a].locked &&
            bodies[link.b].locked && link.a != link.b) {
            keys_.fail(TomlKeys::lineOf(table), "a or b must be a dynamic body");
        }
        const std::string where =
            "a joint of kind " + std::string(kKinds[static_cast<std::size_t>(link.kind)]);
        const bool turns = link.kind == Kind::RevoluteJoint;
        const bool slides = link.kind == Kind::PrismaticJoint;
        const bool two = link.kind == Kind::DistanceJoint || link.kind == Kind::RopeJoint;
        link.point = point(table, "at", kFarthest);
        if (two) {
            link.pointB = point(table, "to", kFarthest);
        } else {
            noUse(table, {"to"}, where);
        }
        if (turns || slides) {
            readMotor(table, turns ? "motor_torque" : "motor_force", link);
            noUse(table, {turns ? "motor_force" : "motor_torque"}, where);
        } else {
            noUse(table, {"motor_speed", "motor_torque", "motor_force", "limit"}, where);
        }
        if (slides) {
            const Vec2 axis = point(table, "axis", kFastest, Vec2{0, 1});
            if (!(sizeOf(axis) > 0)) {
                keys_.fail(TomlKeys::lineOf(*table.get("axis")), "axis must not be [0, 0]");
            }
            link.axis = sizeOf(axis) > 0 ? 1 / sizeOf(axis) * axis : Vec2{0, 1};
        } else {
            noUse(table, {"axis"}, where);
        }
        if (link.kind == Kind::DistanceJoint) {
            link.hertz = real(table, "hertz", 0, 60, 0);
            link.damping = real(table, "damping", 0, 10, 0);
            if (link.hertz == 0) {
                noUse(table, {"damping"}, where + " without hertz");
            }
        } else {
            noUse(table, {"hertz", "damping"}, where);
        }
        return link;
    }

    void readMotor(const toml::table& table, const std::string& strength, Link& link) {
        if (table.contains("motor_speed") || table.contains(strength)) {
            link.motorSpeed = real(table, "motor_speed", -kFastest, kFastest);
            link.motorTorque = real(table, strength, 1e-6, 1e9);
        }
        if (table.contains("limit")) {
            link.limit =
                real(table, "limit", 0, link.kind == Link::Kind::RevoluteJoint ? kPi : kLargest);
        }
    }

    Comparison readComparison(const toml::table& table, CrossScene& scene) {
        keys_.onlyKeys(table, {"what", "body", "a", "b", "time", "exact", "tolerance", "reason"},
                       "compare.");
        Comparison one;
        std::array<std::string_view, kWhats.size()> names;
        std::transform(kWhats.begin(), kWhats.end(), names.begin(),
                       [](const WhatWords& words) { return words.name; });
        if (!table.contains("what")) {
            keys_.missing(table, "what");
        }
        one.what = keys_.choice(table, "what", names, What::X);
        const WhatWords& words = kWhats[static_cast<std::size_t>(one.what)];
        std::string said(words.name);
        if (one.what == What::Touch || one.what == What::Impulse) {
            noUse(table, {"body"}, "a comparison of " + said);
            std::tie(one.a, one.b) = twoBodies(table);
            said += " of " + nameOf(one.a) + " and " + nameOf(one.b);
        } else if (one.what == What::Energy) {
            noUse(table, {"body", "a", "b"}, "a comparison of " + said);
        } else {
            noUse(table, {"a", "b"}, "a comparison of " + said);
            one.a = bodyOf(table, "body");
            said += " of " + nameOf(one.a);
        }
        const double end = static_cast<double>(steps_) / rate_;
        const double time = real(table, "time", 0, end, end);
        one.step = std::lround(time * rate_);
        said += table.contains("time") ? " at " + shortly(time) + " s" : "";
        judge(table, figure(scene, said, std::string(words.unit)));
        return one;
    }

    void judge(const toml::table& table, FigureAdder added) {
        const std::string reason = table.contains("reason") ? keys_.text(table, "reason")
                                                            : std::string("as the scene says");
        if (table.contains("exact")) {
            added.kodoExact(real(table, "exact", -1e9, 1e9), real(table, "tolerance", 0, 1e9),
                            reason);
        } else if (table.contains("tolerance")) {
            added.agree(real(table, "tolerance", 0, 1e9), reason);
        } else {
            noUse(table, {"reason"}, "a comparison without tolerance");
        }
    }

    std::string nameOf(std::size_t body) const {
        return body < bodyNames_.size() ? bodyNames_[body] : std::string();
    }

    TomlKeys keys_;
    std::map<std::string, std::size_t> names_;
    std::vector<std::string> bodyNames_;
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
