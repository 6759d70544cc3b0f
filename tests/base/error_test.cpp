// SPDX-License-Identifier: MIT
#include "support/draws.hpp"
#include "support/random_numbers.hpp"
#include <kodo/error.hpp>

#include "base/checks.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <type_traits>

namespace kodo {
namespace {

TEST(BadDefinition, ContainsFieldAndReason) {
    const BadDefinition bad(Problem{"shape.radius", "must be greater than 0, but is -1"});
    EXPECT_EQ(bad.problem().field, "shape.radius");
    EXPECT_EQ(std::string(bad.what()), "shape.radius: must be greater than 0, but is -1");
}

TEST(BadDefinition, IsAnInvalidArgumentAndBadBodyIdIsOutOfRange) {
    EXPECT_THROW(throw BadDefinition(Problem{}), std::invalid_argument);
    EXPECT_THROW(throw BadBodyId("gone"), std::out_of_range);
}

// With too few digits, 100000.1 is refused as "from -100000 to 100000, but is 100000".
TEST(Problem, PrintsEnoughDigitsToShowThatALimitIsExceeded) {
    const Real beyond = std::nextafter(Real(1e5), Real(1e6));
    EXPECT_EQ(outOfRange("x", beyond, -1e5, 1e5).reason,
              std::string("must be from -100000 to 100000, but is ") +
                  (sizeof(Real) == sizeof(float) ? "100000.01" : "100000.00000000001"));
    EXPECT_EQ(checkPositive("x", Real(-0.1), Real(1e9))->reason,
              "must be greater than 0, but is -0.1");
    EXPECT_EQ(checkPositive("x", Real(3e9), Real(1e9), "m")->reason,
              "must be at most 1e+09 m, but is 3e+09");
    EXPECT_EQ(outOfRange("x", 2, 0, 1, "s").reason, "must be from 0 to 1 s, but is 2");
    EXPECT_EQ(checkNotNegative("x", std::numeric_limits<Real>::infinity(), "N")->reason,
              "must be finite and at least 0 N, but is inf");
    EXPECT_EQ(outOfRange("x", std::numeric_limits<Real>::quiet_NaN(), 0, 1).reason,
              "must be from 0 to 1, but is nan");
    EXPECT_EQ(outOfRange("x", -std::numeric_limits<Real>::quiet_NaN(), 0, 1).reason,
              "must be from 0 to 1, but is nan");
    EXPECT_EQ(outOfRange("x", std::numeric_limits<Real>::infinity(), 0, 1).reason,
              "must be from 0 to 1, but is inf");
}

/// Decimal comma and a thousands separator, as in German.
struct CommasAndPoints : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(Problem, PrintsNumbersIndependentlyOfTheLocale) {
    const std::locale before =
        std::locale::global(std::locale(std::locale::classic(), new CommasAndPoints));
    const std::string reason = outOfRange("x", Real(12345.5), Real(0.25), 1).reason;
    std::locale::global(before);
    EXPECT_EQ(reason, "must be from 0.25 to 1, but is 12345.5");
}

TEST(Problem, PrintsAPointInEachLocaleOfC) {
    EXPECT_EQ(withPoint("-1,5e-07", ","), "-1.5e-07");
    EXPECT_EQ(withPoint("1\u066b5", "\u066b"), "1.5"); // two bytes, as in Persian
    EXPECT_EQ(withPoint("12", ","), "12");
    EXPECT_EQ(withPoint("inf", ","), "inf");
    const std::string before = std::setlocale(LC_NUMERIC, nullptr);
    for (const char* name : {"C", "de_DE.UTF-8"}) { // installed or not
        std::setlocale(LC_NUMERIC, name);
        EXPECT_EQ(textOf(Real(12345.5)), "12345.5") << name;
        EXPECT_EQ(textOf(Real(-2.5e-7)), "-2.5e-07") << name;
    }
    std::setlocale(LC_NUMERIC, before.c_str());
}

/// What a stream prints in the shortest precision from 6 that it reads back.
std::string streamed(Real value) {
    std::stringstream text;
    text.imbue(std::locale::classic());
    Real back = 0;
    for (int digits = 6; digits <= std::numeric_limits<Real>::max_digits10; ++digits) {
        text.str("");
        text.clear();
        text.precision(digits);
        text << value;
        if (std::isinf(value) || (text >> back && back == value)) {
            break;
        }
    }
    return text.str();
}

TEST(Problem, PrintsTheDigitsOfAStream) {
    using Bits = std::conditional_t<sizeof(Real) == sizeof(float), std::uint32_t, std::uint64_t>;
    using Limits = std::numeric_limits<Real>;
    support::RandomNumbers random(17);
    for (const Real value : {Real(0), -Real(0), (Limits::max)(), Limits::lowest(), (Limits::min)(),
                             Real(1e5), Real(1e6), Real(0.1), -Limits::infinity()}) {
        EXPECT_EQ(textOf(value), streamed(value));
    }
    for (int i = 0; i < support::draws(20000); ++i) {
        const Real value = std::bit_cast<Real>(static_cast<Bits>(random.bits()));
        if (std::isnormal(value)) { // not every library reads other numbers from a stream
            ASSERT_EQ(textOf(value), streamed(value));
        }
    }
}

} // namespace
} // namespace kodo
