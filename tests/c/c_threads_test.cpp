// SPDX-License-Identifier: MIT
#include <array>
#include <list>
#include <stdexcept>
#include <thread>

#include "c_world.hpp"

namespace {

using namespace c_test;

class CThreads : public testing::Test {
protected:
    CThreads() {
        EXPECT_OK(kodo_createThreadPool(3, &pool_));
        origin_.add(groundDef());
        for (int i = 0; i < 10; ++i) {
            ids_.push_back(origin_.add(bodyAt(kodo_Real(0.1) * kodo_Real(i), kodo_Real(1 + i))));
        }
        for (int i = 0; i < 40; ++i) {
            worlds_.emplace_back(origin_);
            EXPECT_OK(kodo_setVelocity(worlds_.back(), ids_[0], kodo_vec2(kodo_Real(i), 0)));
            handles_.push_back(worlds_.back());
        }
    }
    ~CThreads() override { EXPECT_OK(kodo_destroyThreadPool(pool_)); }

    kodo_ThreadPool* pool_ = nullptr;
    CWorld origin_;
    std::vector<kodo_BodyId> ids_;
    std::list<CWorld> worlds_;
    std::vector<kodo_World*> handles_;
};

TEST_F(CThreads, ManyWorldsStepAsEachAlone) {
    std::list<CWorld> alone(worlds_.begin(), worlds_.end());
    for (int step = 0; step < 60; ++step) {
        EXPECT_OK(kodo_stepWorlds(handles_.data(), handles_.size(), kDt, pool_));
    }
    auto world = worlds_.begin();
    for (const CWorld& other : alone) {
        other.step(60);
        EXPECT_EQ(other.hash(), (world++)->hash());
    }
    EXPECT_OK(kodo_stepWorlds(handles_.data(), handles_.size(), kDt, nullptr));
    EXPECT_OK(kodo_stepWorlds(nullptr, 0, kDt, pool_));
}

TEST_F(CThreads, AStepWithAPoolHasTheSameBits) {
    for (int i = 0; i < 600; ++i) {
        origin_.add(bodyAt(kodo_Real(i % 60) - 30, kodo_Real(2 + 2 * (i / 60))));
    }
    const CWorld other(origin_);
    kodo_StepOptions options = kodo_stepOptions();
    options.pool = pool_;
    for (int step = 0; step < 30; ++step) {
        EXPECT_OK(kodo_step(origin_, kDt, &options));
    }
    other.step(30);
    EXPECT_EQ(other.hash(), origin_.hash());
}

TEST_F(CThreads, AWorldThatIsTwiceInTheListIsRefusedAndNoneSteps) {
    handles_.push_back(handles_[3]);
    const std::uint64_t before = worlds_.front().hash();
    EXPECT_EQ(KODO_WRONG_USE, kodo_stepWorlds(handles_.data(), handles_.size(), kDt, pool_));
    EXPECT_STREQ("worlds[40]: is twice in the list, or within a step or a visit", kodo_errorText());
    EXPECT_EQ(before, worlds_.front().hash());
    handles_.pop_back(); // all can step again
    EXPECT_OK(kodo_stepWorlds(handles_.data(), handles_.size(), kDt, pool_));
}

TEST_F(CThreads, AnErrorOfOneWorldIsReportedAndTheOthersStep) {
    kodo_Field field = kodo_field(KODO_OWN_FIELD);
    field.own.at = [](void*, const kodo_FieldBody*, kodo_Real, kodo_FieldForce*) {
        throw std::runtime_error("out of order");
    };
    EXPECT_OK(kodo_addField(handles_[7], &field));
    EXPECT_EQ(KODO_OTHER_ERROR, kodo_stepWorlds(handles_.data(), handles_.size(), kDt, pool_));
    EXPECT_STREQ("out of order", kodo_errorText());
    for (const kodo_World* handle : handles_) {
        std::uint64_t steps = 0;
        EXPECT_OK(kodo_stepCount(handle, &steps));
        EXPECT_EQ(1u, steps);
    }
    EXPECT_EQ(KODO_BAD_DEFINITION, kodo_stepWorlds(handles_.data(), handles_.size(), 2, pool_));
}

TEST_F(CThreads, APoolThatIsInUseIsRefused) {
    struct Both {
        kodo_World* other;
        kodo_ThreadPool* pool;
        kodo_Status status;
    } both{handles_[1], pool_, KODO_OK};
    kodo_StepOptions options = kodo_stepOptions();
    options.pool = pool_;
    options.context = &both;
    options.enterStage = [](void* context, kodo_StepStage) {
        auto& given = *static_cast<Both*>(context);
        given.status = kodo_stepWorlds(&given.other, 1, kDt, given.pool);
    };
    for (int i = 0; i < 600; ++i) { // enough for the pool to be used
        origin_.add(bodyAt(kodo_Real(i % 60) - 30, kodo_Real(2 + 2 * (i / 60))));
    }
    EXPECT_OK(kodo_step(origin_, kDt, &options));
    EXPECT_EQ(KODO_WRONG_USE, both.status);
}

TEST_F(CThreads, EachThreadMayHaveItsOwnWorld) {
    std::array<std::uint64_t, 4> hashes{};
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < hashes.size(); ++i) {
        threads.emplace_back([this, i, &hashes] {
            const CWorld own(origin_);
            own.step(60);
            EXPECT_EQ(KODO_BAD_DEFINITION, kodo_step(own, kodo_Real(2 + i), nullptr));
            hashes[i] = own.hash();
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (const std::uint64_t hash : hashes) {
        EXPECT_EQ(hashes[0], hash);
    }
}

} // namespace
