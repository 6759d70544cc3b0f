// SPDX-License-Identifier: MIT
#include <kodo/settings.hpp>
#include <support/near.hpp>

#include <functional>

namespace kodo {
namespace {

TEST(StepSettings, DefaultsAndProfilesAreValid) {
    for (const StepSettings& settings :
         {StepSettings{}, fast(), balanced(), accurate(), thesis2006()}) {
        EXPECT_FALSE(check(settings).has_value());
    }
    EXPECT_EQ(balanced(), StepSettings{});
}

// A refusal of a single number out of range names its field.
TEST(StepSettings, EachNumberIsChecked) {
    struct Bad {
        const char* field;
        std::function<void(StepSettings&)> spoil;
    };
    const Bad rows[] = {
        {"settings.substeps", [](StepSettings& s) { s.soft().substeps = 0; }},
        {"settings.substeps", [](StepSettings& s) { s.soft().substeps = 65; }},
        {"settings.impactPasses", [](StepSettings& s) { s.soft().impactPasses = -1; }},
        {"settings.impactPasses", [](StepSettings& s) { s.soft().impactPasses = 1001; }},
        {"settings.contactHertz", [](StepSettings& s) { s.soft().contactHertz = 0; }},
        {"settings.contactHertz", [](StepSettings& s) { s.soft().contactHertz = support::kNan; }},
        {"settings.contactDamping",
         [](StepSettings& s) { s.soft().contactDamping = support::kInf; }},
        {"settings.jointGap", [](StepSettings& s) { s.soft().jointGap = 0; }},
        {"settings.pushSpeed", [](StepSettings& s) { s.soft().pushSpeed = -1; }},
    };
    for (const Bad& bad : rows) {
        SCOPED_TRACE(bad.field);
        StepSettings settings;
        bad.spoil(settings);
        const auto problem = check(settings);
        ASSERT_TRUE(problem.has_value());
        EXPECT_EQ(problem->field, bad.field);
    }
}

constexpr Feature kEachFeature[] = {Feature::Friction,    Feature::RollingResistance,
                                    Feature::Restitution, Feature::ContinuousCollision,
                                    Feature::Records,     Feature::Sleep,
                                    Feature::Rotation,    Feature::Collision};

TEST(StepSettings, FeaturesAreLeftOutIndependently) {
    for (const Feature out : kEachFeature) {
        StepSettings settings;
        settings.leaveOut = out;
        for (const Feature feature : kEachFeature) {
            EXPECT_EQ(settings.has(feature), feature != out);
        }
    }
}

} // namespace
} // namespace kodo
