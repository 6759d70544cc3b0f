// SPDX-License-Identifier: MIT
#include <kodo/error.hpp>
#include <kodo/executor.hpp>

#include "base/worker_team.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <vector>

namespace kodo {
namespace {

// Every piece runs once, and all of them before forEach() returns, with any number of helpers.
TEST(WorkerTeam, RunsEveryPieceOnce) {
    for (const int helpers : {0, 1, 3}) {
        ThreadPool pool(helpers);
        for (int round = 0; round < 50; ++round) {
            WorkerTeam team(&pool);
            EXPECT_EQ(team.alone(), helpers == 0);
            for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 1000u}) {
                std::vector<int> done(count, 0);
                team.forEach(count, 8, [&](std::size_t first, std::size_t last) {
                    for (std::size_t i = first; i < last; ++i) {
                        ++done[i];
                    }
                });
                EXPECT_EQ(done, std::vector<int>(count, 1)) << helpers << " helpers";
            }
        }
    }
}

// Pieces are the same for any number of helpers. A loop of one piece is not cut.
TEST(WorkerTeam, PiecesDependOnlyOnTheGrain) {
    ThreadPool pool(2);
    WorkerTeam team(&pool);
    std::vector<std::size_t> lengths(100, 0);
    team.forEach(100, 30,
                 [&](std::size_t first, std::size_t last) { lengths[first] = last - first; });
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_EQ(lengths[i], i == 90 ? 10u : i % 30 == 0 ? 30u : 0u) << i;
    }
    std::size_t calls = 0;
    team.forEach(30, 30, [&](std::size_t, std::size_t last) { calls += last; });
    EXPECT_EQ(calls, 30u);
}

// Each partition runs its phases in order, each once. An even phase begins when all partitions have
// completed the previous even phase. With and without helpers.
TEST(WorkerTeam, RunsPhasesInOrder) {
    constexpr std::uint32_t kTurns = 41;
    for (const int helpers : {0, 1, 2, 5}) {
        ThreadPool pool(helpers);
        WorkerTeam team(&pool);
        ASSERT_EQ(team.partitions(), static_cast<std::uint32_t>(helpers) + 1);
        for (int round = 0; round < 50; ++round) {
            std::vector<std::atomic<std::uint32_t>> done(team.partitions());
            std::atomic<int> wrong{0};
            team.inPhases(kTurns, [&](std::uint32_t share, std::uint32_t turn) {
                wrong += done[share].load() != turn ? 1 : 0;
                for (const std::atomic<std::uint32_t>& other : done) {
                    wrong += turn % 2 == 0 && other.load() + 1 < turn ? 1 : 0;
                }
                done[share].store(turn + 1);
            });
            EXPECT_EQ(wrong.load(), 0);
            for (const std::atomic<std::uint32_t>& each : done) {
                EXPECT_EQ(each.load(), kTurns);
            }
        }
        team.inPhases(0, [](std::uint32_t, std::uint32_t) { ADD_FAILURE(); });
    }
}

// Concurrent writes of pieces to shared data.
TEST(WorkerTeam, MarksCountsAndMaximaAreAtomic) {
    ThreadPool pool(3);
    WorkerTeam team(&pool);
    std::uint8_t seen = 0;
    std::uint32_t count = 0;
    Real largest = 0;
    std::vector<std::uint32_t> places(5000, 0);
    team.forEach(places.size(), 16, [&](std::size_t first, std::size_t last) {
        WorkerTeam::mark(seen);
        for (std::size_t i = first; i < last; ++i) {
            places[team.count(count)] = static_cast<std::uint32_t>(i);
            WorkerTeam::raise(largest, static_cast<Real>(i % 4999));
        }
    });
    EXPECT_EQ(seen, 1);
    EXPECT_EQ(count, places.size());
    EXPECT_EQ(largest, Real(4998));
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i < places.size(); ++i) {
        ASSERT_EQ(places[i], i);
    }
}

TEST(ThreadPool, RefusesANumberOfHelpersOutOfRange) {
    for (const int helpers : {-1, ThreadPool::kMaxHelpers + 1}) {
        try {
            ThreadPool pool(helpers);
            ADD_FAILURE() << helpers;
        } catch (const BadDefinition& error) {
            EXPECT_EQ(error.problem().field, "helpers");
        }
    }
}

} // namespace
} // namespace kodo
