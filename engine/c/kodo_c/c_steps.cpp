// SPDX-License-Identifier: MIT
#include <kodo/step_stats.hpp>
#include <kodo_c/c_fields.hpp>
#include <kodo_c/c_handles.hpp>
#include <kodo_c/c_values.hpp>

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <string>
#include <vector>

namespace kodo_c {
namespace {

static_assert(kodo::kStepStageNames.size() == KODO_STAGE_SLEEP + 1);

/// A StageListener that calls functions of C.
class Listener final : public kodo::StageListener {
public:
    explicit Listener(const kodo_StepOptions& options) : options_(options) {}
    void enter(kodo::StepStage stage) override {
        if (options_.enterStage != nullptr) {
            options_.enterStage(options_.context, static_cast<kodo_StepStage>(stage));
        }
    }
    void leave() override {
        if (options_.leaveStages != nullptr) {
            options_.leaveStages(options_.context);
        }
    }

private:
    const kodo_StepOptions& options_;
};

/// Steps of many Worlds, each a task for one thread.
class WorldSteps {
public:
    /// Throws std::logic_error for a World that is in use, or twice in the list.
    WorldSteps(std::span<kodo_World* const> worlds, kodo::Real dt) : worlds_(worlds), dt_(dt) {
        for (; marked_ < worlds.size(); ++marked_) {
            const std::string name = "worlds[" + std::to_string(marked_) + "]";
            const kodo_World* world = worlds[marked_];
            if (world == nullptr || world->users.fetch_add(1) != 0) {
                if (world != nullptr) {
                    --world->users;
                }
                release();
                throw std::logic_error(
                    name + (world == nullptr
                                ? ": must not be null"
                                : ": is twice in the list, or within a step or a visit"));
            }
        }
    }
    WorldSteps(const WorldSteps&) = delete;
    WorldSteps& operator=(const WorldSteps&) = delete;
    ~WorldSteps() { release(); }

    void run(kodo::ThreadPool* pool) {
        if (pool != nullptr) {
            pool->begin(&WorldSteps::help, this);
        }
        work();
        if (pool != nullptr) {
            pool->end();
        }
        if (error_) {
            std::rethrow_exception(error_);
        }
    }

private:
    static void help(void* steps) { static_cast<WorldSteps*>(steps)->work(); }

    void work() noexcept {
        for (std::size_t i = next_++; i < worlds_.size(); i = next_++) {
            try {
                worlds_[i]->world.step(dt_);
                rethrowFieldErrors(worlds_[i]->world);
            } catch (...) {
                const std::lock_guard lock(mutex_);
                if (!error_ || i < failed_) {
                    error_ = std::current_exception();
                    failed_ = i;
                }
            }
        }
    }
    void release() {
        while (marked_ > 0) {
            --worlds_[--marked_]->users;
        }
    }

    std::span<kodo_World* const> worlds_;
    kodo::Real dt_;
    std::size_t marked_ = 0; // Worlds that are marked as in use
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;
    std::exception_ptr error_; // of the first World with one
    std::size_t failed_ = 0;   // its index
};

/// Calls a function with each World, each body of it, and the index of its value.
template <typename Call>
kodo_Status eachBody(std::span<kodo_World* const> worlds, std::span<const kodo_BodyId> ids,
                     Call&& call) {
    std::size_t index = 0;
    for (kodo_World* world : worlds) {
        kodo::World& made = required(world, "worlds").world;
        for (const kodo_BodyId id : ids) {
            call(made, fromC(id), index++);
        }
    }
    return KODO_OK;
}

} // namespace
} // namespace kodo_c

using namespace kodo_c;

kodo_Status kodo_initStepOptions(kodo_StepOptions* options, kodo_Head head) {
    return guarded([&] { initialise(options, head, "kodo_StepOptions"); });
}

kodo_Status kodo_createThreadPool(int32_t helpers, kodo_ThreadPool** pool) {
    return guarded([&] {
        kodo_ThreadPool*& made = required(pool, "pool");
        made = new kodo_ThreadPool{kodo::ThreadPool(helpers)};
    });
}

kodo_Status kodo_destroyThreadPool(kodo_ThreadPool* pool) {
    return guarded([&] { delete &required(pool, "pool"); });
}

kodo_Status kodo_step(kodo_World* world, kodo_Real dt, const kodo_StepOptions* options) {
    return guarded([&] {
        kodo::World& stepped = worldOf(world);
        const InUse use(*world);
        if (options == nullptr) {
            stepped.step(dt);
        } else {
            const kodo_StepOptions& given = checked(options, "options", "kodo_StepOptions");
            const bool listens = given.enterStage != nullptr || given.leaveStages != nullptr;
            Listener listener(given);
            stepped.step(dt, {.executor = given.pool == nullptr ? nullptr : &given.pool->pool,
                              .listener = listens ? &listener : nullptr});
        }
        rethrowFieldErrors(stepped);
    });
}

kodo_Status kodo_stepWorlds(kodo_World* const* worlds, size_t count, kodo_Real dt,
                            kodo_ThreadPool* pool) {
    return guarded([&] {
        WorldSteps steps(itemsOf(worlds, count, "worlds"), dt);
        steps.run(pool == nullptr ? nullptr : &pool->pool);
    });
}

kodo_Status kodo_poses(kodo_World* const* worlds, size_t worldCount, const kodo_BodyId* ids,
                       size_t idCount, kodo_Transform* poses) {
    return guarded([&] {
        requirePointer(poses, "poses");
        eachBody(itemsOf(worlds, worldCount, "worlds"), itemsOf(ids, idCount, "ids"),
                 [&](const kodo::World& world, kodo::BodyId id, std::size_t i) {
                     poses[i] = toC(world[id].transform());
                 });
    });
}

kodo_Status kodo_velocities(kodo_World* const* worlds, size_t worldCount, const kodo_BodyId* ids,
                            size_t idCount, kodo_Velocity* velocities) {
    return guarded([&] {
        requirePointer(velocities, "velocities");
        eachBody(itemsOf(worlds, worldCount, "worlds"), itemsOf(ids, idCount, "ids"),
                 [&](const kodo::World& world, kodo::BodyId id, std::size_t i) {
                     const kodo::BodyView body = world[id];
                     velocities[i] = {toC(body.velocity()), body.angularVelocity()};
                 });
    });
}

kodo_Status kodo_applyLoads(kodo_World* const* worlds, size_t worldCount, const kodo_BodyId* ids,
                            size_t idCount, const kodo_Load* loads) {
    return guarded([&] {
        requirePointer(loads, "loads");
        eachBody(itemsOf(worlds, worldCount, "worlds"), itemsOf(ids, idCount, "ids"),
                 [&](kodo::World& world, kodo::BodyId id, std::size_t i) {
                     kodo::BodyRef body = world[id];
                     body.applyForce(fromC(loads[i].force));
                     body.applyTorque(loads[i].torque);
                 });
    });
}

kodo_Status kodo_setVelocities(kodo_World* const* worlds, size_t worldCount, const kodo_BodyId* ids,
                               size_t idCount, const kodo_Velocity* velocities) {
    return guarded([&] {
        requirePointer(velocities, "velocities");
        eachBody(itemsOf(worlds, worldCount, "worlds"), itemsOf(ids, idCount, "ids"),
                 [&](kodo::World& world, kodo::BodyId id, std::size_t i) {
                     kodo::BodyRef body = world[id];
                     body.setVelocity(fromC(velocities[i].linear));
                     body.setAngularVelocity(velocities[i].angular);
                 });
    });
}
