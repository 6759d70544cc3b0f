// SPDX-License-Identifier: MIT
#include "base/assert.hpp"
#include "base/id_pool.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace kodo {
namespace {

struct Broken : std::runtime_error {
    using std::runtime_error::runtime_error;
};

void throwBroken(const char* condition, const char* file, int line) {
    throw Broken(std::string(file) + ":" + std::to_string(line) + " " + condition);
}

class Assert : public testing::Test {
protected:
    void SetUp() override {
#ifndef KODO_ENABLE_ASSERTS
        GTEST_SKIP() << "asserts are off in this build";
#endif
        before_ = setAssertHandler(&throwBroken);
    }
    void TearDown() override {
        if (before_ != nullptr) {
            setAssertHandler(before_);
        }
    }

private:
    AssertHandler before_ = nullptr;
};

TEST_F(Assert, PassesConditionFileAndLineToTheHandler) {
    try {
        KODO_ASSERT(1 + 1 == 3);
        FAIL() << "the handler was not called";
    } catch (const Broken& broken) {
        const std::string text = broken.what();
        EXPECT_NE(text.find("1 + 1 == 3"), std::string::npos) << text;
        EXPECT_NE(text.find("assert_test.cpp:"), std::string::npos) << text;
    }
}

TEST_F(Assert, DoesNotCallTheHandlerWhileTheConditionHolds) {
    EXPECT_NO_THROW(KODO_ASSERT(1 + 1 == 2));
}

TEST_F(Assert, SetHandlerReturnsThePreviousHandler) {
    EXPECT_EQ(setAssertHandler(&throwBroken), &throwBroken);
}

TEST_F(Assert, IdPoolRefusesToReleaseADeadId) {
    IdPool pool;
    EXPECT_THROW(pool.release(0), Broken);
    const IdPool::Slot slot = pool.allocate();
    pool.release(slot.index);
    EXPECT_THROW(pool.release(slot.index), Broken);
}

using AssertDeathTest = Assert;

TEST_F(AssertDeathTest, AbortsWhenTheHandlerReturns) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_DEATH(
        {
            setAssertHandler(nullptr);
            KODO_ASSERT(2 < 1);
        },
        "assert_test.cpp:[0-9]+: kodo: .*2 < 1");
}

} // namespace
} // namespace kodo
