// SPDX-License-Identifier: MIT
#include <utility>

#include "scene_keys.hpp"
#include "scene_tables.hpp"

namespace scene_files {
inline namespace KODO_PRECISION {

using apart::TomlKeys;
using kodo::Flags;
using kodo::Real;
using kodo::Vec2;

namespace {

constexpr const char* kPrimitives[] = {"box",     "circle", "polygon", "capsule",
                                       "segment", "plane",  "point"};

/// The primitive of a body or a part.
class ShapeReader {
public:
    static std::optional<kodo::Primitive> read(Table& table) {
        std::string kind;
        int kinds = 0;
        for (const char* one : kPrimitives) {
            kinds += table.has(one) ? 1 : 0;
            kind = table.has(one) ? one : kind;
        }
        if (kinds != 1) {
            table.keys().fail(table.line(), "one of box, circle, polygon, capsule, segment, plane "
                                            "and point is needed");
            return std::nullopt;
        }
        const std::size_t before = table.keys().faults();
        kodo::Primitive made = primitive(table, kind);
        if (table.keys().faults() > before) {
            return std::nullopt;
        }
        if (const auto problem = kodo::check(made)) {
            table.keys().fail(table.line(kind), kind + ": " + problem->text());
            return std::nullopt;
        }
        return made;
    }

private:
    static kodo::Primitive primitive(Table& table, const std::string& kind) {
        const Vec2 at = table.pair("at").value_or(Vec2{});
        if (kind == "circle") {
            return kodo::Circle{real(table, "circle"), at};
        }
        if (kind == "box") {
            const Vec2 size = table.pair("box").value_or(Vec2{});
            const Vec2 turn = table.pair("turn").value_or(Vec2{1, 0});
            return kodo::Box{size.x, size.y, at, {turn.x, turn.y}, real(table, "radius")};
        }
        if (kind == "polygon") {
            kodo::Polygon polygon{table.points("polygon").value_or(std::vector<Vec2>{}),
                                  real(table, "radius")};
            for (Vec2& corner : polygon.corners) {
                corner += at;
            }
            return polygon;
        }
        if (kind == "plane") {
            return kodo::Plane{table.pair("plane").value_or(Vec2{}), real(table, "offset")};
        }
        if (kind == "point") {
            return kodo::Point{table.pair("point").value_or(Vec2{})};
        }
        const std::vector<Vec2> ends = table.points(kind).value_or(std::vector<Vec2>(2));
        if (ends.size() != 2) {
            table.fail(kind, "must be two points, as [[0, 0], [1, 0]]");
        }
        if (kind == "capsule") {
            return kodo::Capsule{ends[0] + at, ends[1] + at, real(table, "radius")};
        }
        return kodo::Segment{ends[0] + at, ends[1] + at, table.flag("one_sided"),
                             real(table, "radius")};
    }
    static Real real(Table& table, const char* key) {
        return static_cast<Real>(table.number(key).value_or(0));
    }
};

kodo::Material readMaterial(Table& table, kodo::Material material) {
    if (const std::optional<double> friction = table.number("friction")) {
        material.kineticFriction = static_cast<Real>(*friction);
        material.staticFriction = static_cast<Real>(*friction);
    }
    table.take("static_friction", material, &kodo::Material::staticFriction);
    materialKeys(table, material);
    if (const auto rule = table.choice("friction_rule", kMixRules)) {
        material.frictionRule = static_cast<kodo::MixRule>(*rule);
    }
    if (const auto rule = table.choice("restitution_rule", kMixRules)) {
        material.restitutionRule = static_cast<kodo::MixRule>(*rule);
    }
    if (const auto problem = kodo::check(material)) {
        const std::string key = keyOf(problem->field);
        table.keys().fail(table.line(key == "kinetic_friction" ? "friction" : key),
                          problem->text());
    }
    return material;
}

bool hasFilter(const Table& table) {
    return table.has("categories") || table.has("collides") || table.has("with") ||
           table.has("group");
}

kodo::CollisionFilter readFilter(Table& table) {
    kodo::CollisionFilter filter = readMatch(table);
    filter.flags |= table.categories("categories").value_or(0);
    filter.flags |= table.flag("sensor") ? kodo::kSensor : 0;
    return filter;
}

void readMotion(Table& table, kodo::BodyDef& def) {
    table.need("position");
    def.position = table.pair("position").value_or(Vec2{});
    def.rotation = kodo::Rot::fromAngle(static_cast<Real>(table.number("angle").value_or(0)));
    if (const std::optional<Vec2> rotation = table.pair("rotation")) {
        table.noUse({"angle"}, "a body with rotation");
        def.rotation = {rotation->x, rotation->y};
    }
    const std::size_t type = table.choice("type", kBodyTypes).value_or(0);
    def.type = static_cast<kodo::BodyType>(type);
    if (type != 0) {
        table.noUse({"weightless", "upright", "lock_move", "gravity_scale", "mass"},
                    "a " + std::string(kBodyTypes[type]) + " body");
    }
    if (def.type == kodo::BodyType::Static) {
        table.noUse({"velocity", "spin"}, "a static body");
    }
    bodyKeys(table, def);
    def.gravityScale = static_cast<Real>(table.number("gravity_scale").value_or(1));
    if (table.flag("weightless")) {
        table.noUse({"gravity_scale"}, "a weightless body");
        def.gravityScale = 0;
    }
    if (const auto mode = table.choice("continuous_mode", kContinuousModes)) {
        def.continuousMode = static_cast<kodo::ContinuousMode>(*mode);
    }
    const std::pair<const char*, Flags> flags[] = {{"upright", kodo::kLockRotate},
                                                   {"lock_move", kodo::kLockMove},
                                                   {"never_sleep", kodo::kNeverSleep},
                                                   {"disabled", kodo::kDisabled}};
    for (const auto& [key, bit] : flags) {
        def.flags |= table.flag(key) ? bit : 0;
    }
}

void readMass(Table& table, kodo::BodyDef& def) {
    table.take("density", def, &kodo::BodyDef::density);
    if (const std::optional<double> mass = table.number("mass")) {
        kodo::MassDef own{static_cast<Real>(*mass), table.pair("mass_center"), {}};
        if (const std::optional<double> inertia = table.number("inertia")) {
            own.inertia = static_cast<Real>(*inertia);
        }
        def.mass = own;
    }
}

void readShape(TomlKeys& keys, Table& table, FileBody& body) {
    if (table.has("chain")) {
        body.partLines = {table.line("chain")};
        kodo::Chain chain{.points = table.points("chain").value_or(std::vector<Vec2>{})};
        chain.closed = table.flag("closed");
        chain.oneSided = table.flag("one_sided");
        body.def.shape = std::move(chain);
        return;
    }
    const toml::node* parts = table.get("parts");
    if (parts == nullptr) {
        for (const char* kind : kPrimitives) {
            if (table.has(kind)) {
                body.partLines = {table.line(kind)};
            }
        }
        if (const auto primitive = ShapeReader::read(table)) {
            body.def.shape = kodo::shapeOf(*primitive);
        }
        return;
    }
    for (const char* kind : kPrimitives) {
        table.noUse({kind}, "a body with parts");
    }
    kodo::Compound compound;
    bool differs = false;
    eachOf(keys, parts, "parts", [&](const toml::table& own) {
        Table part(keys, own);
        part.onlyKeys({"box",
                       "circle",
                       "polygon",
                       "capsule",
                       "segment",
                       "plane",
                       "point",
                       "one_sided",
                       "radius",
                       "offset",
                       "turn",
                       "at",
                       "density",
                       "friction",
                       "static_friction",
                       "restitution",
                       "rolling_resistance",
                       "surface_speed",
                       "friction_rule",
                       "restitution_rule",
                       "sensor",
                       "categories",
                       "collides",
                       "with",
                       "group"},
                      "parts.");
        body.partLines.push_back(part.line());
        compound.parts.push_back(ShapeReader::read(part).value_or(kodo::Circle{1}));
        kodo::Part rest;
        rest.material = readMaterial(part, body.def.material);
        rest.density = body.def.density;
        part.take("density", rest, &kodo::Part::density);
        if (hasFilter(part) || part.has("sensor")) {
            rest.filter = readFilter(part);
        }
        differs = differs || rest.filter || rest.density != body.def.density ||
                  rest.material != body.def.material;
        body.parts.push_back(std::move(rest));
        part.noOther("this part");
    });
    if (!differs) {
        body.parts.clear();
    }
    if (compound.parts.size() == 1) {
        body.def.shape = kodo::shapeOf(compound.parts[0]);
    } else {
        body.def.shape = std::move(compound);
    }
}

} // namespace

kodo::CollisionFilter readMatch(Table& table) {
    kodo::CollisionFilter filter;
    if (const auto match = table.choice("collides", kMatches)) {
        filter.flags = kodo::kMatchNone << *match;
    }
    filter.required = table.categories("with").value_or(0);
    filter.group = static_cast<std::int32_t>(table.number("group", -1e9, 1e9, 0));
    if (filter.required != 0 && filter.flags == 0) {
        table.fail("with", "needs collides: none, any, all or equal");
    }
    return filter;
}

FileBody readBody(TomlKeys& keys, const toml::table& own) {
    Table table(keys, own);
    table.onlyKeys({"name",
                    "type",
                    "box",
                    "circle",
                    "polygon",
                    "capsule",
                    "segment",
                    "plane",
                    "point",
                    "chain",
                    "closed",
                    "one_sided",
                    "radius",
                    "offset",
                    "turn",
                    "at",
                    "parts",
                    "position",
                    "angle",
                    "rotation",
                    "velocity",
                    "spin",
                    "density",
                    "mass",
                    "mass_center",
                    "inertia",
                    "friction",
                    "static_friction",
                    "restitution",
                    "rolling_resistance",
                    "surface_speed",
                    "friction_rule",
                    "restitution_rule",
                    "linear_damping",
                    "angular_damping",
                    "gravity_scale",
                    "continuous_mode",
                    "weightless",
                    "upright",
                    "lock_move",
                    "sensor",
                    "never_sleep",
                    "disabled",
                    "categories",
                    "collides",
                    "with",
                    "group"},
                   "body.");
    FileBody body;
    body.line = table.line();
    body.name = table.text("name");
    body.nameLine = table.line("name");
    const std::size_t before = keys.faults();
    readMotion(table, body.def);
    readMass(table, body.def);
    body.def.material = readMaterial(table, {});
    const kodo::CollisionFilter filter = readFilter(table);
    body.def.flags |= filter.flags;
    body.def.required = filter.required;
    body.def.group = filter.group;
    readShape(keys, table, body);
    table.noOther("this body");
    if (keys.faults() == before) {
        if (const auto problem = kodo::check(body.def)) {
            table.fail(*problem);
        }
    }
    return body;
}

} // namespace KODO_PRECISION
} // namespace scene_files
