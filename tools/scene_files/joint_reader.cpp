// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "scene_keys.hpp"
#include "scene_tables.hpp"

namespace scene_files {
inline namespace KODO_PRECISION {

using apart::TomlKeys;
using kodo::Real;
using kodo::Vec2;

namespace {

class JointReader {
public:
    explicit JointReader(TomlKeys& keys, const std::vector<FileBody>& bodies)
        : keys_(keys), bodies_(bodies) {}

    FileJoint read(const toml::table& own) {
        Table table(keys_, own);
        table.onlyKeys({"kind",         "a",        "b",           "at",           "to",
                        "anchor_a",     "anchor_b", "reference",   "axis",         "length",
                        "limit",        "limits",   "motor_speed", "motor_torque", "motor_force",
                        "target",       "force",    "torque",      "ground_a",     "ground_b",
                        "ratio",        "rack",     "hertz",       "damping",      "break_force",
                        "break_torque", "collide",  "ratchet"},
                       "joint.");
        table.need("kind");
        const std::size_t kind = table.choice("kind", kJointKinds).value_or(0);
        const std::string where = "a joint of kind " + std::string(kJointKinds[kind]);
        FileJoint joint{emptyJoint(kind == kRope ? 2 : kind), table.line()};
        const std::size_t before = keys_.faults();
        if (auto* mouse = std::get_if<kodo::MouseJoint>(&joint.def)) {
            mouse->body = bodyOf(table, "b");
            mouse->anchor = anchor(table, "at", "anchor_b", mouse->body);
            jointKeys(table, *mouse);
        } else {
            std::visit(
                [&](auto& def) {
                    if constexpr (requires { def.ends; }) {
                        readBetween(table, def, kind == kRope);
                    }
                },
                joint.def);
        }
        table.noOther(where);
        if (keys_.faults() == before) {
            if (const auto problem = kodo::check(joint.def)) {
                table.fail(*problem);
            }
        }
        return joint;
    }

private:
    /// The place of a body in the file, as an id.
    kodo::BodyId bodyOf(Table& table, const std::string& key) {
        if (!table.has(key)) {
            table.need(key);
            return {};
        }
        const std::string name = table.text(key);
        const auto found = std::find_if(bodies_.begin(), bodies_.end(),
                                        [&](const FileBody& body) { return body.name == name; });
        if (found != bodies_.end()) {
            return {static_cast<std::uint32_t>(found - bodies_.begin()), 1};
        }
        if (!name.empty()) {
            table.fail(key, "must be the name of a body; there is no " + name);
        }
        return {};
    }

    template <std::size_t index = 0>
    static kodo::JointDef emptyJoint(std::size_t kind) {
        if constexpr (index + 1 < std::variant_size_v<kodo::JointDef>) {
            if (kind != index) {
                return emptyJoint<index + 1>(kind);
            }
        }
        return std::variant_alternative_t<index, kodo::JointDef>{};
    }

    kodo::Transform frameOf(kodo::BodyId id) const {
        if (id.index >= bodies_.size()) {
            return {};
        }
        const kodo::BodyDef& def = bodies_[id.index].def;
        return {def.position, def.rotation};
    }

    /// A point of a body: in the world, or in its frame.
    Vec2 anchor(Table& table, const char* world, const char* local, kodo::BodyId id) {
        if (table.has(local)) {
            table.noUse({world}, std::string("a joint with ") + local);
            return table.pair(local).value_or(Vec2{});
        }
        table.need(world);
        return kodo::toLocal(frameOf(id), table.pair(world).value_or(Vec2{}));
    }

    template <typename Joint>
    void readBetween(Table& table, Joint& def, bool rope) {
        const std::size_t before = keys_.faults();
        def.ends.a = bodyOf(table, "a");
        def.ends.b = bodyOf(table, "b");
        if (def.ends.a == def.ends.b && keys_.faults() == before) {
            keys_.fail(table.line(), "a and b must be two bodies");
        }
        const auto isLocked = [&](kodo::BodyId id) {
            return id.index < bodies_.size() &&
                   bodies_[id.index].def.type != kodo::BodyType::Dynamic;
        };
        if (isLocked(def.ends.a) && isLocked(def.ends.b) && keys_.faults() == before) {
            keys_.fail(table.line(), "a or b must be a dynamic body");
        }
        constexpr bool kTwo = std::is_same_v<Joint, kodo::DistanceJoint> ||
                              std::is_same_v<Joint, kodo::PulleyJoint> ||
                              std::is_same_v<Joint, kodo::GearJoint>;
        if constexpr (!std::is_same_v<Joint, kodo::FilterJoint>) {
            def.ends.anchorA = anchor(table, "at", "anchor_a", def.ends.a);
            def.ends.anchorB = anchor(table, kTwo ? "to" : "at", "anchor_b", def.ends.b);
        }
        endKeys(table, def.ends);
        if constexpr (requires { def.reference; }) {
            def.reference =
                frameOf(def.ends.b).rotation.angle() - frameOf(def.ends.a).rotation.angle();
            table.take("reference", def, &Joint::reference);
        }
        jointKeys(table, def);
        if constexpr (requires { def.axis; }) {
            readAxis(table, def);
        }
        if constexpr (requires { def.limits; }) {
            if (const std::optional<double> limit = table.number("limit")) {
                table.noUse({"limits"}, "a joint with limit");
                def.limits = kodo::Range{static_cast<Real>(-*limit), static_cast<Real>(*limit)};
            }
        }
        if constexpr (std::is_same_v<Joint, kodo::DistanceJoint>) {
            readLength(table, def, rope);
        }
        if (table.has("motor_speed")) { // a motor without speed is a brake
            if constexpr (requires { def.motorTorque; }) {
                table.need("motor_torque");
            } else if constexpr (requires { def.motorForce; }) {
                table.need("motor_force");
            }
        }
    }

    /// With anchors in the frames of the bodies, the axis is in the frame of a.
    template <typename Joint>
    void readAxis(Table& table, Joint& def) {
        if (table.has("anchor_a")) {
            return;
        }
        const Vec2 axis = table.has("axis") ? def.axis : Vec2{0, 1};
        if (!(kodo::length(axis) > 0)) {
            table.fail("axis", "must not be [0, 0]");
            return;
        }
        def.axis = kodo::unrotate(frameOf(def.ends.a).rotation, kodo::normalize(axis));
    }

    /// The way between the anchors is the length of a rope or a rod, and of a spring at rest.
    void readLength(Table& table, kodo::DistanceJoint& def, bool rope) {
        if (!table.has("length")) {
            def.length = kodo::length(frameOf(def.ends.b) * def.ends.anchorB -
                                      frameOf(def.ends.a) * def.ends.anchorA);
        }
        if (rope) {
            table.noUse({"hertz", "damping", "limits", "limit"}, "a joint of kind rope");
            def.limits = kodo::Range{0, def.length};
        } else if (def.hertz == 0) {
            table.noUse({"damping"}, "a joint of kind distance without hertz");
            if (!def.limits && def.motorForce == 0) {
                def.limits = kodo::Range{def.length, def.length};
            }
        }
    }

    TomlKeys& keys_;
    const std::vector<FileBody>& bodies_;
};

} // namespace

FileJoint readJoint(TomlKeys& keys, const toml::table& own, const std::vector<FileBody>& bodies) {
    return JointReader(keys, bodies).read(own);
}

} // namespace KODO_PRECISION
} // namespace scene_files
