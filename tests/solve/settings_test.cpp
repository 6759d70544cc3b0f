// SPDX-License-Identifier: MIT
#include <kodo/solve/settings.hpp>
#include <support/near.hpp>

#include <functional>

namespace kodo {
namespace {

TEST(StepSettings, DefaultsAndProfilesAreGood) {
    EXPECT_FALSE(check(StepSettings{}).has_value());
    EXPECT_FALSE(check(thesis2006()).has_value());
}

// Every number can be set alone, and each has its range and its name in the sentence.
TEST(StepSettings, EachNumberIsChecked) {
    struct Bad {
        const char* field;
        std::function<void(StepSettings&)> spoil;
    };
    const Bad rows[] = {
        {"settings.substeps", [](StepSettings& s) { s.substeps = 0; }},
        {"settings.substeps", [](StepSettings& s) { s.substeps = 65; }},
        {"settings.impactPasses", [](StepSettings& s) { s.impactPasses = -1; }},
        {"settings.impactPasses", [](StepSettings& s) { s.impactPasses = 1001; }},
        {"settings.contactHertz", [](StepSettings& s) { s.contactHertz = 0; }},
        {"settings.contactHertz", [](StepSettings& s) { s.contactHertz = support::kNan; }},
        {"settings.contactDamping", [](StepSettings& s) { s.contactDamping = support::kInf; }},
        {"settings.pushSpeed", [](StepSettings& s) { s.pushSpeed = -1; }},
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

constexpr Feature kEachFeature[] = {
    Feature::Friction, Feature::RollingResistance, Feature::Restitution, Feature::Sweep,
    Feature::Records,  Feature::Resting,           Feature::Rotation};

TEST(StepSettings, FeaturesAreLeftOutOneByOne) {
    for (const Feature out : kEachFeature) {
        StepSettings settings;
        settings.leaveOut = static_cast<std::uint8_t>(out);
        for (const Feature feature : kEachFeature) {
            EXPECT_EQ(settings.has(feature), feature != out);
        }
    }
}

} // namespace
} // namespace kodo
