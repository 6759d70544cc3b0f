// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <array>
#include <string_view>
#include <type_traits>
#include <variant>

// The keys of the file, for reader and writer alike: each list names a key and the member that it
// holds. `Keys` is one of both.
namespace scene_files {
inline namespace KODO_PRECISION {

inline constexpr std::array<std::string_view, 3> kBodyTypes{"dynamic", "kinematic",
                                                            "static"}; // of BodyType
inline constexpr std::array<std::string_view, 3> kContinuousModes{"never", "static",
                                                                  "all"}; // of ContinuousMode
inline constexpr std::array<std::string_view, 11> kJointKinds{
    "revolute", "fixed",  "distance", "prismatic", "motor", "mouse",
    "wheel",    "pulley", "gear",     "filter",    "rope"}; // of JointDef; a rope is a distance
inline constexpr std::size_t kRope = 10;
static_assert(std::variant_size_v<kodo::JointDef> == kRope, "name the new joint, before the rope");
inline constexpr std::array<std::string_view, 6> kFieldKinds{
    "own", "gravity", "drag", "wind", "attractor", "buoyancy"}; // of FieldKind
inline constexpr std::array<std::string_view, 2> kAttractorLaws{"inverse_square", "linear"};
inline constexpr std::array<std::string_view, 5> kMixRules{"geometric_mean", "minimum", "mean",
                                                           "multiply", "maximum"}; // of MixRule
inline constexpr std::array<std::string_view, 2> kSolvers{"soft", "propagation"};
inline constexpr std::array<std::string_view, 8> kFeatures{
    "friction", "rolling_resistance", "restitution", "continuous_collision", "records",
    "sleep",    "rotation",           "collision"}; // by bit of Features
inline constexpr std::array<std::string_view, 4> kMatches{"none", "any", "all",
                                                          "equal"}; // bits from kMatchNone on
inline constexpr unsigned kCategories = 48;

template <typename Keys, typename Settings>
void solverKeys(Keys& keys, Settings& settings) {
    using Own = std::remove_const_t<Settings>;
    keys.take("substeps", settings, &Own::substeps);
    keys.take("impact_passes", settings, &Own::impactPasses);
    if constexpr (std::is_same_v<Own, kodo::SoftSettings>) {
        keys.take("contact_hertz", settings, &Own::contactHertz);
        keys.take("contact_damping", settings, &Own::contactDamping);
        keys.take("joint_gap", settings, &Own::jointGap);
    } else {
        keys.take("contact_passes", settings, &Own::contactPasses);
        keys.take("shock_passes", settings, &Own::shockPasses);
    }
    keys.take("joint_hertz", settings, &Own::jointHertz);
    keys.take("joint_damping", settings, &Own::jointDamping);
    keys.take("push_speed", settings, &Own::pushSpeed);
}

template <typename Keys, typename Surface>
void materialKeys(Keys& keys, Surface& surface) {
    using kodo::Material;
    keys.take("restitution", surface, &Material::restitution);
    keys.take("rolling_resistance", surface, &Material::rollingResistance);
    keys.take("surface_speed", surface, &Material::surfaceSpeed);
}

template <typename Keys, typename Def>
void bodyKeys(Keys& keys, Def& def) {
    using kodo::BodyDef;
    keys.take("velocity", def, &BodyDef::velocity);
    keys.take("spin", def, &BodyDef::angularVelocity);
    keys.take("linear_damping", def, &BodyDef::linearDamping);
    keys.take("angular_damping", def, &BodyDef::angularDamping);
}

/// The keys of a kind of joint, without those of its ends and `reference`.
template <typename Keys, typename Joint>
void jointKeys(Keys& keys, Joint& joint) {
    using Own = std::remove_const_t<Joint>;
    if constexpr (requires { joint.axis; }) {
        keys.take("axis", joint, &Own::axis);
    }
    if constexpr (requires { joint.length; }) {
        keys.take("length", joint, &Own::length);
    }
    if constexpr (requires { joint.limits; }) {
        keys.take("limits", joint, &Own::limits);
    }
    if constexpr (requires { joint.motorSpeed; }) {
        keys.take("motor_speed", joint, &Own::motorSpeed);
    }
    if constexpr (requires { joint.motorTorque; }) {
        keys.take("motor_torque", joint, &Own::motorTorque);
    }
    if constexpr (requires { joint.motorForce; }) {
        keys.take("motor_force", joint, &Own::motorForce);
    }
    if constexpr (requires { joint.target; }) {
        keys.take("target", joint, &Own::target);
    }
    if constexpr (requires { joint.force; }) {
        keys.take("force", joint, &Own::force);
    }
    if constexpr (requires { joint.torque; }) {
        keys.take("torque", joint, &Own::torque);
    }
    if constexpr (requires { joint.groundA; }) {
        keys.take("ground_a", joint, &Own::groundA);
        keys.take("ground_b", joint, &Own::groundB);
    }
    if constexpr (requires { joint.ratio; }) {
        keys.take("ratio", joint, &Own::ratio);
    }
    if constexpr (requires { joint.rack; }) {
        keys.take("rack", joint, &Own::rack);
    }
    if constexpr (requires { joint.hertz; }) {
        keys.take("hertz", joint, &Own::hertz);
        keys.take("damping", joint, &Own::damping);
    }
    if constexpr (requires { joint.ratchet; }) {
        keys.take("ratchet", joint, &Own::ratchet);
    }
}

/// The keys that the ends of a joint have beside bodies and anchors.
template <typename Keys, typename Ends>
void endKeys(Keys& keys, Ends& ends) {
    using kodo::JointEnds;
    keys.take("break_force", ends, &JointEnds::breakForce);
    keys.take("break_torque", ends, &JointEnds::breakTorque);
    keys.take("collide", ends, &JointEnds::collide);
}

} // namespace KODO_PRECISION
} // namespace scene_files
