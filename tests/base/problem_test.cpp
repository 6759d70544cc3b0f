// SPDX-License-Identifier: MIT
#include <kodo/base/problem.hpp>

#include <gtest/gtest.h>

#include <string>

namespace kodo {
namespace {

TEST(BadDefinition, CarriesFieldAndSentence) {
    const BadDefinition bad(Problem{"shape.radius", "must be greater than 0, but is -1"});
    EXPECT_EQ(bad.problem().field, "shape.radius");
    EXPECT_EQ(std::string(bad.what()), "shape.radius: must be greater than 0, but is -1");
}

TEST(BadDefinition, IsAnInvalidArgumentAndBadBodyIdOutOfRange) {
    EXPECT_THROW(throw BadDefinition(Problem{}), std::invalid_argument);
    EXPECT_THROW(throw BadBodyId("gone"), std::out_of_range);
}

} // namespace
} // namespace kodo
