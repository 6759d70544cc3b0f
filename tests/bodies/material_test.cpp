// SPDX-License-Identifier: MIT
#include <kodo/body.hpp>
#include <support/near.hpp>

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

TEST(Material, DefaultIsValid) {
    EXPECT_FALSE(check(Material{}).has_value());
    EXPECT_FALSE(check(withFriction(0, 1)).has_value());
}

} // namespace
} // namespace kodo
