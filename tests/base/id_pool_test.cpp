// SPDX-License-Identifier: MIT
#include <support/random_numbers.hpp>

#include "base/id_pool.hpp"

#include <gtest/gtest.h>

#include <map>
#include <vector>

namespace kodo {
namespace {

TEST(IdPool, AssignsAscendingIndicesWhileNoneIsFree) {
    IdPool pool;
    for (std::uint32_t i = 0; i < 10; ++i) {
        EXPECT_EQ(pool.allocate().index, i);
    }
    EXPECT_EQ(pool.capacity(), 10u);
}

TEST(IdPool, ReusesTheLastFreedIndexFirst) {
    IdPool pool;
    for (int i = 0; i < 4; ++i) {
        pool.allocate();
    }
    pool.release(1);
    pool.release(3);
    pool.release(0);
    EXPECT_EQ(pool.allocate().index, 0u);
    EXPECT_EQ(pool.allocate().index, 3u);
    EXPECT_EQ(pool.allocate().index, 1u);
    EXPECT_EQ(pool.allocate().index, 4u);
}

TEST(IdPool, GenerationZeroIsNeverAlive) {
    IdPool pool;
    EXPECT_FALSE(pool.alive(0, 0));
    pool.allocate();
    EXPECT_FALSE(pool.alive(0, 0));
    pool.release(0);
    EXPECT_FALSE(pool.alive(0, 0));
}

// R1: one slot is reused 100,000 times. No earlier id becomes alive again.
TEST(IdPool, ReuseNeverRevivesAnOldId) {
    IdPool pool;
    std::vector<IdPool::Slot> old;
    for (int life = 0; life < 100000; ++life) {
        const IdPool::Slot slot = pool.allocate();
        ASSERT_EQ(slot.index, 0u);
        old.push_back(slot);
        pool.release(slot.index);
    }
    pool.allocate();
    for (const IdPool::Slot& slot : old) {
        ASSERT_FALSE(pool.alive(slot.index, slot.generation));
    }
}

// W1 on a small scale: lists model every id ever assigned and whether it is alive.
TEST(IdPool, AgreesWithAModelOverAMillionRandomCalls) {
    constexpr std::uint64_t kSeed = 7;
    support::RandomNumbers random(kSeed);
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    IdPool pool;
    std::vector<IdPool::Slot> living;
    std::vector<IdPool::Slot> dead;
    for (int call = 0; call < 1000000; ++call) {
        if (living.size() < 10 || (living.size() < 500 && random.below(2) == 0)) {
            const IdPool::Slot slot = pool.allocate();
            ASSERT_TRUE(pool.alive(slot.index, slot.generation));
            living.push_back(slot);
        } else {
            const std::size_t i = random.below(living.size());
            std::swap(living[i], living.back());
            pool.release(living.back().index);
            dead.push_back(living.back());
            living.pop_back();
        }
        if (!dead.empty()) {
            const IdPool::Slot& gone = dead[random.below(dead.size())];
            ASSERT_FALSE(pool.alive(gone.index, gone.generation));
        }
        const IdPool::Slot& here = living[random.below(living.size())];
        ASSERT_TRUE(pool.alive(here.index, here.generation));
    }
    std::map<std::uint32_t, std::uint32_t> owners;
    for (const IdPool::Slot& slot : living) {
        EXPECT_TRUE(owners.emplace(slot.index, slot.generation).second) << "two ids share a slot";
    }
    EXPECT_LE(pool.capacity(), 500u);
}

TEST(IdPool, ACopyAssignsTheSameIds) {
    IdPool pool;
    pool.allocate();
    pool.allocate();
    pool.release(0);
    IdPool copy = pool;
    for (int i = 0; i < 3; ++i) {
        const IdPool::Slot a = pool.allocate();
        const IdPool::Slot b = copy.allocate();
        EXPECT_EQ(a.index, b.index);
        EXPECT_EQ(a.generation, b.generation);
    }
}

} // namespace
} // namespace kodo
