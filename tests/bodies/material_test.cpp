// SPDX-License-Identifier: MIT
#include <kodo/body.hpp>
#include <support/near.hpp>

#include <string>

namespace kodo {
namespace {

TEST(Material, WithFrictionSetsStaticAndKineticFriction) {
    constexpr Material material = withFriction(Real(0.5), Real(0.25));
    EXPECT_EQ(material.staticFriction, Real(0.5));
    EXPECT_EQ(material.kineticFriction, Real(0.5));
    EXPECT_EQ(material.restitution, Real(0.25));
    EXPECT_EQ(material.rollingResistance, 0);
}

// S3: the geometric mean, the smaller restitution, the larger rolling resistance.
TEST(Material, MixingCombinesEachCoefficientByItsRule) {
    const Material a{Real(0.9), Real(0.4), Real(0.3), Real(0.1)};
    const Material b{Real(0.4), Real(0.1), Real(0.8), Real(0.02)};
    const Material both = mix(a, b);
    EXPECT_TRUE(support::near(both.staticFriction, 0.6L, support::kEpsilon));
    EXPECT_TRUE(support::near(both.kineticFriction, 0.2L, support::kEpsilon));
    EXPECT_EQ(both.restitution, Real(0.3));
    EXPECT_EQ(both.rollingResistance, Real(0.1));
}

TEST(Material, MixingIsSymmetric) {
    const Material a{Real(0.9), Real(0.4), Real(0.3), Real(0.1)};
    const Material b{Real(0.7), Real(0.2), 1, 0};
    EXPECT_EQ(mix(a, b), mix(b, a));
}

TEST(Material, MixingWithZeroFrictionGivesZero) {
    const Material both = mix(withFriction(0), withFriction(100));
    EXPECT_EQ(both.staticFriction, 0);
    EXPECT_EQ(both.kineticFriction, 0);
}

// A later rule wins over an earlier one, whichever of the two parts has it.
TEST(Material, MixingFollowsTheLaterOfTwoRules) {
    struct Case {
        MixRule rule;
        long double friction; // of 0.9 and 0.4
        long double bounce;   // of 0.25 and 1
    };
    const Case cases[] = {{MixRule::GeometricMean, 0.6L, 0.5L},
                          {MixRule::Minimum, 0.4L, 0.25L},
                          {MixRule::Mean, 0.65L, 0.625L},
                          {MixRule::Multiply, 0.36L, 0.25L},
                          {MixRule::Maximum, 0.9L, 1}};
    for (const Case& later : cases) {
        for (const MixRule earlier :
             {MixRule::GeometricMean, MixRule::Minimum, MixRule::Mean, MixRule::Multiply}) {
            if (earlier > later.rule) {
                continue;
            }
            Material a = withFriction(Real(0.9), Real(0.25));
            Material b = withFriction(Real(0.4), 1);
            a.frictionRule = b.restitutionRule = later.rule;
            b.frictionRule = a.restitutionRule = earlier;
            for (const Material& both : {mix(a, b), mix(b, a)}) {
                const int rule = static_cast<int>(later.rule);
                EXPECT_TRUE(support::near(both.staticFriction, later.friction, support::kEpsilon))
                    << rule;
                EXPECT_TRUE(support::near(both.kineticFriction, later.friction, support::kEpsilon))
                    << rule;
                EXPECT_TRUE(support::near(both.restitution, later.bounce, support::kEpsilon))
                    << rule;
            }
        }
    }
}

TEST(Material, MixingAddsSurfaceSpeeds) {
    Material a;
    Material b;
    a.surfaceSpeed = Real(1.5);
    b.surfaceSpeed = -4;
    EXPECT_EQ(mix(a, b).surfaceSpeed, Real(-2.5));
}

TEST(Material, RefusesWhatIsOutOfRangeByName) {
    const auto fieldOf = [](auto change) {
        Material material;
        change(material);
        const std::optional<Problem> problem = check(material);
        return problem ? problem->field : std::string();
    };
    EXPECT_EQ(fieldOf([](Material& m) { m.restitution = kMaxRestitution; }), "");
    EXPECT_EQ(fieldOf([](Material& m) { m.restitution = Real(2.01); }), "material.restitution");
    EXPECT_EQ(fieldOf([](Material& m) { m.surfaceSpeed = -kMaxSpeed; }), "");
    EXPECT_EQ(fieldOf([](Material& m) { m.surfaceSpeed = 2 * kMaxSpeed; }),
              "material.surfaceSpeed");
    EXPECT_EQ(fieldOf([](Material& m) { m.frictionRule = static_cast<MixRule>(5); }),
              "material.frictionRule");
    EXPECT_EQ(fieldOf([](Material& m) { m.restitutionRule = static_cast<MixRule>(200); }),
              "material.restitutionRule");
}

TEST(Material, DefaultIsValid) {
    EXPECT_FALSE(check(Material{}).has_value());
    EXPECT_FALSE(check(withFriction(0, 1)).has_value());
}

} // namespace
} // namespace kodo
