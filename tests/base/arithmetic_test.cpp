// SPDX-License-Identifier: MIT
#include <kodo/kodo.hpp>

#include <gtest/gtest.h>

#include <cfenv>
#include <string>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace kodo {
namespace {

std::string refusal() {
    try {
        World world;
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

TEST(Arithmetic, AReorderedSumIsRefused) {
    EXPECT_TRUE(detail::requireExactArithmetic(0, Real(5) / 49));
    EXPECT_THROW(detail::requireExactArithmetic(1, Real(5) / 49), std::runtime_error);
}

// 5 * (1 / 49) rounds twice, and differs from 5 / 49 in float and in double.
TEST(Arithmetic, AProductWithAReciprocalIsRefused) {
    const volatile Real reciprocal = Real(1) / 49;
    EXPECT_THROW(detail::requireExactArithmetic(0, 5 * reciprocal), std::runtime_error);
}

TEST(Arithmetic, AWorldRefusesAnotherRoundingMode) {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const std::string reason = refusal();
        std::fesetround(FE_TONEAREST);
        EXPECT_NE(reason.find("round to nearest"), std::string::npos) << mode;
    }
    EXPECT_EQ(refusal(), "");
}

#if defined(__SSE2__)
TEST(Arithmetic, AWorldRefusesFlushedSubnormals) {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | _MM_FLUSH_ZERO_ON);
    const std::string reason = refusal();
    _mm_setcsr(before);
    EXPECT_NE(reason.find("subnormal"), std::string::npos);
}
#endif

} // namespace
} // namespace kodo
