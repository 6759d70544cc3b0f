// SPDX-License-Identifier: MIT
#include "bench_run.hpp"

#include <algorithm>
#include <array>
#include <ctime>

#include "heap.hpp"

namespace bench {
namespace {

constexpr int kPeakEvery = 20; // steps

double secondsOf(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Sums up the time between start() and stop().
class StopWatch {
public:
    explicit StopWatch(clockid_t clock) : clock_(clock) {}
    void start() { started_ = secondsOf(clock_); }
    void stop() { sum_ += secondsOf(clock_) - started_; }
    double seconds() const { return sum_; }

private:
    clockid_t clock_;
    double started_ = 0;
    double sum_ = 0;
};

constexpr int kSnapshots = 9;

/// Empty without work.
std::optional<Cost> costOf(const std::function<std::size_t()>& work) {
    if (!work) {
        return std::nullopt;
    }
    std::array<double, kSnapshots> times{};
    Cost cost;
    for (double& time : times) {
        StopWatch watch(CLOCK_THREAD_CPUTIME_ID);
        watch.start();
        cost.bytes = work();
        watch.stop();
        time = watch.seconds();
    }
    std::nth_element(times.begin(), times.begin() + kSnapshots / 2, times.end());
    cost.seconds = times[kSnapshots / 2];
    return cost;
}

/// One run from the first to the last step. Steps are measured in stretches, since reading the
/// clock takes as long as a hundred steps of an empty world.
class Run {
public:
    Run(const Scene& scene, Engine& engine, const RunOptions& options)
        : scene_(scene),
          stage_(engine, scene.def),
          excludedPairs_(jointedPairs(scene.def)),
          peak_(options.peak),
          worst_(options.worst || scene.worstStep),
          snapshot_(options.snapshot) {}

    void warmUp() {
        for (int done = 0; done < scene_.warmUp;) {
            done += stretch(scene_.warmUp - done);
            act();
        }
    }

    void measure(int steps) {
        steps_ = steps;
        pairWorkBefore_ = stage_.engine().pairWork().value_or(0);
        for (int done = 0; done < steps;) {
            const std::uint64_t allocations = allocationCount();
            const double before = cpu_.seconds();
            if (scene_.stepIsTimed) {
                start();
            }
            const int taken = stretch(done < steps / 2 ? steps / 2 - done : steps - done);
            if (done >= steps / 2) {
                allocations_ += allocationCount() - allocations;
            }
            if (!scene_.stepIsTimed) {
                if (scene_.prepare) {
                    scene_.prepare(stage_);
                }
                start();
            }
            if (scene_.actIsTimed) {
                act();
            }
            stop();
            worstSeconds_ = std::max(worstSeconds_, cpu_.seconds() - before);
            if (!scene_.actIsTimed) {
                act();
            }
            done += taken;
            if (peak_ && done / kPeakEvery > (done - taken) / kPeakEvery) {
                maxOverlap_ = std::max(maxOverlap_, depthsOf(stage_.bodies(), excludedPairs_).max);
            }
        }
    }

    Result result() const {
        const std::vector<Placed> bodies = stage_.bodies();
        Result result;
        result.locked = static_cast<std::size_t>(std::count_if(
            bodies.begin(), bodies.end(), [](const Placed& body) { return body.def->locked; }));
        result.bodies = stage_.engine().bodyCount() - result.locked;
        result.cpuSeconds = cpu_.seconds();
        result.wallSeconds = wall_.seconds();
        if (worst_) {
            result.worstSeconds = worstSeconds_;
        }
        result.depths = depthsOf(bodies, excludedPairs_);
        if (peak_) {
            result.maxOverlap = std::max(maxOverlap_, result.depths.max);
        }
        if (scene_.region) {
            result.escaped = escapedFrom(*scene_.region, bodies);
        }
        result.displacement = driftOf(bodies);
        result.stands = scene_.stands;
        result.kineticEnergy = kineticEnergy(bodies);
        result.mass = stage_.engine().mass();
        result.stateHash = stage_.engine().stateHash();
        if (scene_.error) {
            result.errorName = scene_.error->name;
            result.errorUnit = scene_.error->unit;
            result.error = scene_.error->measure(stage_, result.depths);
        }
        result.contactBytes = stage_.engine().contactBytes();
        if (snapshot_) {
            const SnapshotWork work = stage_.engine().snapshotWork();
            result.snapshot = costOf(work.write);
            result.copy = costOf(work.copy);
        }
        result.stages = stage_.engine().stages();
        if (const auto pairWork = stage_.engine().pairWork()) {
            result.pairWorkPerStep =
                1e-3 * static_cast<double>(*pairWork - pairWorkBefore_) / steps_;
        }
        const int late = steps_ - steps_ / 2;
        result.allocationsPerStep = static_cast<double>(allocations_) / late;
        return result;
    }

private:
    /// Takes up to `left` steps, until the next action is due. Returns their number.
    int stretch(int left) {
        int count = left;
        for (const int every : {scene_.every, peak_ ? kPeakEvery : 0, worst_ ? 1 : 0}) {
            if (every > 0) {
                count = std::min(count, every - taken_ % every);
            }
        }
        for (int i = 0; i < count; ++i) {
            stage_.engine().step(kDt);
        }
        taken_ += count;
        return count;
    }

    void act() {
        if (scene_.act && taken_ % scene_.every == 0) {
            scene_.act(stage_, taken_);
        }
    }

    void start() {
        wall_.start();
        cpu_.start();
    }
    void stop() {
        cpu_.stop();
        wall_.stop();
    }

    const Scene& scene_;
    Stage stage_;
    ExcludedPairs excludedPairs_;
    bool peak_;
    bool worst_;
    bool snapshot_; // each step is a stretch of its own
    int taken_ = 0; // steps, including the warm-up
    int steps_ = 0; // measured steps
    std::uint64_t allocations_ = 0;
    std::uint64_t pairWorkBefore_ = 0;
    double maxOverlap_ = 0;
    double worstSeconds_ = 0; // of a stretch
    StopWatch cpu_{CLOCK_THREAD_CPUTIME_ID};
    StopWatch wall_{CLOCK_MONOTONIC};
};

} // namespace

Result run(const RunOptions& options) {
    const Recipe recipe = recipeOf(options.scene);
    if (options.size && recipe.sizeMeans.empty() && *options.size != recipe.size) {
        throw WrongUse("the scene " + options.scene + " has only one size");
    }
    const int size = options.size.value_or(recipe.size);
    const int steps = options.steps.value_or(recipe.steps);
    const Scene scene = recipe.make(size, options.seed);
    StepOptions step = options.step;
    step.rest = scene.rest;
    step.events = scene.events;
    const std::size_t before = heapBytes();
    const std::unique_ptr<Engine> engine = makeEngine(options.engine, scene.def, step);
    const std::size_t made = heapBytes() - before;
    if (options.snapshot && !engine->snapshotWork().write) {
        throw WrongUse("--snapshot: " + options.engine + " has no snapshot");
    }
    Run run(scene, *engine, options);
    const std::size_t ready = heapBytes();
    run.warmUp();
    run.measure(steps);
    const double bytes = static_cast<double>(made + heapBytes() - ready);
    Result result = run.result();
    const std::size_t all = result.bodies + result.locked;
    result.bytesPerBody = all == 0 ? 0 : bytes / static_cast<double>(all);
    result.options = options;
    result.size = size;
    result.steps = steps;
    return result;
}

} // namespace bench
