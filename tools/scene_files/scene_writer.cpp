// SPDX-License-Identifier: MIT
#include <map>
#include <utility>

#include "scene_file.hpp"
#include "scene_lines.hpp"

namespace scene_files {
inline namespace KODO_PRECISION {
namespace {

using kodo::Vec2;

std::string jointText(const kodo::JointDef& def, const std::map<kodo::BodyId, std::string>& names) {
    Lines lines("\n");
    lines.add("kind", inQuotes(kJointKinds[def.index()]));
    std::visit(
        [&](const auto& joint) {
            if constexpr (requires { joint.ends; }) {
                lines.add("a", inQuotes(names.at(joint.ends.a)));
                lines.add("b", inQuotes(names.at(joint.ends.b)));
                if (!std::holds_alternative<kodo::FilterJoint>(def)) {
                    lines.add("anchor_a", textOf(joint.ends.anchorA));
                    lines.add("anchor_b", textOf(joint.ends.anchorB));
                }
                endKeys(lines, joint.ends);
            } else {
                lines.add("b", inQuotes(names.at(joint.body)));
                lines.add("anchor_b", textOf(joint.anchor));
            }
            if constexpr (requires { joint.reference; }) {
                lines.add("reference", textOf(joint.reference)); // the reader knows another default
            }
            if constexpr (std::is_same_v<std::decay_t<decltype(joint)>, kodo::DistanceJoint>) {
                if (joint.length == 1) {
                    lines.add("length", "1"); // likewise
                }
            }
            jointKeys(lines, joint);
        },
        def);
    return "\n[[joint]]\n" + lines.made() + "\n";
}

void writeLaw(Lines& lines, const kodo::DragLaw& law, Vec2 velocity) {
    lines.take("linear", law, &kodo::DragLaw::linear);
    lines.take("quadratic", law, &kodo::DragLaw::quadratic);
    lines.add("velocity", textOf(velocity));
}

std::string fieldText(const kodo::FieldEntry& entry) {
    using kodo::FieldKind;
    const kodo::ForceField& field = *entry.field;
    Lines lines("\n");
    lines.add("kind", inQuotes(kFieldKinds[static_cast<std::size_t>(field.kind())]));
    switch (field.kind()) {
    case FieldKind::Own:
        return {};
    case FieldKind::Gravity:
        lines.add("acceleration", textOf(static_cast<const kodo::Gravity&>(field).acceleration()));
        break;
    case FieldKind::Drag: {
        const auto& drag = static_cast<const kodo::Drag&>(field);
        writeLaw(lines, drag.law(), drag.air());
        break;
    }
    case FieldKind::Wind: {
        const auto& wind = static_cast<const kodo::Wind&>(field);
        writeLaw(lines, wind.law(), wind.velocity());
        if (const std::optional<kodo::Aabb> region = wind.region()) {
            lines.add("lower", textOf(region->lower));
            lines.add("upper", textOf(region->upper));
        }
        break;
    }
    case FieldKind::Attractor: {
        const auto& attractor = static_cast<const kodo::Attractor&>(field);
        lines.add("law", inQuotes(kAttractorLaws[static_cast<std::size_t>(attractor.law())]));
        lines.add("center", textOf(attractor.center()));
        lines.add("strength", textOf(attractor.strength()));
        lines.add("softening", textOf(attractor.softening()));
        break;
    }
    case FieldKind::Buoyancy: {
        const auto& water = static_cast<const kodo::Buoyancy&>(field);
        lines.add("density", textOf(water.fluid().density));
        lines.add("drag", textOf(water.fluid().drag));
        lines.add("surface", textOf(water.surface()));
        lines.add("gravity", textOf(water.gravity()));
        break;
    }
    }
    writeMatch(lines, entry.which);
    return "\n[[field]]\n" + lines.made() + "\n";
}

std::string settingsText(const kodo::StepSettings& settings) {
    Lines lines("\n");
    lines.add("solver", inQuotes(kSolvers[settings.solver.index()]));
    std::visit([&](const auto& own) { solverKeys(lines, own); }, settings.solver);
    lines.take("sleep_steps", settings, &kodo::StepSettings::sleepSteps);
    std::string features;
    for (std::size_t i = 0; i < kFeatures.size(); ++i) {
        if ((settings.leaveOut.bits >> i & 1u) != 0) {
            features += (features.empty() ? "" : ", ") + inQuotes(kFeatures[i]);
        }
    }
    if (!features.empty()) {
        lines.add("leave_out", "[" + features + "]");
    }
    return "\n[settings]\n" + lines.made() + "\n";
}

/// True if the entry is what WorldDef::gravity makes.
bool isGravity(const kodo::FieldEntry& entry) {
    return entry.field->kind() == kodo::FieldKind::Gravity && entry.which.flags == 0 &&
           entry.which.required == 0 && entry.which.group == 0 &&
           static_cast<const kodo::Gravity&>(*entry.field).acceleration() != Vec2{};
}

} // namespace

std::string sceneText(const kodo::World& world, const SceneHead& head) {
    const std::vector<kodo::FieldEntry>& fields = world.fields();
    const bool pulls = !fields.empty() && isGravity(fields.front());
    Lines lines("\n");
    lines.add("title", inQuotes(head.title));
    lines.add("seconds", fmt::format("{}", head.seconds));
    lines.add("rate", fmt::format("{}", head.rate));
    lines.add("gravity",
              textOf(pulls ? static_cast<const kodo::Gravity&>(*fields.front().field).acceleration()
                           : Vec2{}));
    std::string made = lines.made() + "\n" + settingsText(world.settings());
    for (std::size_t i = pulls ? 1 : 0; i < fields.size(); ++i) {
        made += fieldText(fields[i]);
    }
    std::map<kodo::BodyId, std::string> names;
    for (const kodo::BodyId id : world.bodies()) {
        names[id] = "body " + std::to_string(names.size() + 1);
        made += bodyText(world[id], names[id]);
    }
    for (const kodo::JointId id : world.joints()) {
        made += jointText(world.joint(id), names);
    }
    return made;
}

std::string notHeld(const kodo::World& world) {
    std::string all;
    const auto add = [&](bool lacks, const char* words) {
        if (lacks) {
            all += (all.empty() ? "" : ", ") + std::string(words);
        }
    };
    bool own = false;
    for (const kodo::FieldEntry& entry : world.fields()) {
        own = own || entry.field->kind() == kodo::FieldKind::Own;
    }
    bool asleep = false;
    bool marked = false;
    for (const kodo::BodyId id : world.bodies()) {
        asleep = asleep || world[id].isAsleep();
        marked = marked || world[id].userData() != 0;
    }
    bool turned = false;
    for (const kodo::JointId id : world.joints()) {
        turned = turned || std::abs(world.jointState(id).angle) > Real(3.15);
    }
    add(own, "force fields of your own");
    add(turned, "turns of joints: an angle starts again between -pi and pi");
    add(asleep, "sleep: all bodies wake");
    add(marked, "user data");
    add(world.region().has_value(), "the region");
    add(world.tolerances().unit() != 1, "the length unit");
    return all;
}

} // namespace KODO_PRECISION
} // namespace scene_files
