// SPDX-License-Identifier: MIT
#include <support/same_records.hpp>

#include <worlds/judges.hpp>

#include <exception>

namespace worlds {

using namespace kodo;

namespace {

/// The world that must have the same bits.
class TwinWorld {
public:
    explicit TwinWorld(const Recipe& recipe) : recipe_(recipe) {
        if (recipe.twin == Twin::Threads || recipe.twin == Twin::Queries) {
            start(build(recipe));
        }
    }

    void beforeStep(int step, const Scene& scene) {
        if (step == recipe_.twinStep && recipe_.twin == Twin::Copy) {
            start({scene.world, scene.ids});
        }
        if (step == recipe_.twinStep && recipe_.twin == Twin::Bytes) {
            start({fromBytes(toBytes(scene.world)), scene.ids});
        }
        for (const Event& event : recipe_.events) {
            if (event.step == step && scene_) {
                apply(event, *scene_);
            }
        }
        if (scene_ && recipe_.twin == Twin::Queries) {
            ask(scene_->world);
        }
        if (scene_) {
            scene_->world.step(recipe_.dt, options_);
        }
    }

    std::optional<std::string> afterStep(const World& world, bool whole) const {
        if (!scene_) {
            return std::nullopt;
        }
        if (scene_->world.stateHash() != world.stateHash()) {
            return "state of the twin differs";
        }
        if (whole && !support::sameRecords(scene_->world, world)) {
            return "records of the twin differ";
        }
        return std::nullopt;
    }

private:
    /// Queries change no bit.
    static void ask(const World& world) {
        rayCast(world, {-20, 3}, {20, 1});
        overlap(world, Aabb{{-1, -1}, {1, 2}});
        closestPoint(world, {3, 5}, 100);
    }

    void start(Scene scene) {
        scene_ = std::move(scene);
        if (recipe_.twin == Twin::Threads) {
            thread_local ThreadPool pool(1);
            options_.executor = &pool;
        }
    }

    const Recipe& recipe_;
    std::optional<Scene> scene_;
    StepOptions options_;
};

class Run {
public:
    explicit Run(const Recipe& recipe)
        : recipe_(recipe),
          scene_(build(recipe)),
          twin_(recipe),
          energy_(recipe),
          momentum_(recipe) {
        restart();
    }

    std::optional<Finding> run() {
        for (; step_ < recipe_.steps; ++step_) {
            twin_.beforeStep(step_, scene_); // copies before the events
            applyEvents();
            scene_.world.step(recipe_.dt);
            if (auto finding = afterStep()) {
                return finding;
            }
        }
        if (recipe_.rests) {
            if (const auto text = judgeSleep(scene_.world)) {
                return Finding{"sleep", step_, *text};
            }
        }
        return removeAll();
    }

    int step() const { return step_; }

private:
    void restart() {
        energetic_ = startsSound(scene_.world);
        energy_.restart(scene_.world);
        momentum_.restart(scene_.world);
        paths_.restart(scene_.world);
    }

    void applyEvents() {
        bool any = false;
        for (const Event& event : recipe_.events) {
            if (event.step == step_) {
                apply(event, scene_);
                any = true;
            }
        }
        if (any) {
            restart();
        }
    }

    std::optional<Finding> afterStep() {
        const World& world = scene_.world;
        const bool whole = step_ % 8 == 7 || step_ + 1 == recipe_.steps;
        const auto finding = [&](const char* judge, std::optional<std::string> text) {
            return text ? std::optional(Finding{judge, step_, *text}) : std::nullopt;
        };
        if (auto found = finding("numbers", judgeNumbers(world))) {
            return found;
        }
        const std::optional<std::string> excess = energy_.afterStep(world);
        if (energetic_ && excess) {
            return Finding{"energy", step_, *excess};
        }
        if (auto found = finding("momentum", momentum_.afterStep(world))) {
            return found;
        }
        if (auto found = finding("touch", touches_.afterStep(world))) {
            return found;
        }
        if (recipe_.tiles == 1) { // its cost grows with the square
            if (auto found = finding("through", paths_.afterStep(world))) {
                return found;
            }
        }
        return finding("twin", whole ? twin_.afterStep(world, whole) : std::nullopt);
    }

    std::optional<Finding> removeAll() {
        for (const BodyId id : scene_.world.bodies()) {
            scene_.world.remove(id);
        }
        scene_.world.step(recipe_.dt);
        if (const auto text = touches_.afterStep(scene_.world)) {
            return Finding{"touch", step_, *text};
        }
        if (touches_.openCount() > 0) {
            return Finding{"touch", step_, "a pair has no end"};
        }
        return std::nullopt;
    }

    const Recipe& recipe_;
    bool energetic_ = true; // nothing overlaps at the start
    Scene scene_;
    TwinWorld twin_;
    EnergyJudge energy_;
    MomentumJudge momentum_;
    PathJudge paths_;
    TouchJudge touches_;
    int step_ = 0;
};

} // namespace

std::optional<Finding> judge(const Recipe& recipe) {
    int step = -1;
    try {
        Run run(recipe);
        try {
            return run.run();
        } catch (...) {
            step = run.step();
            throw;
        }
    } catch (const std::exception& error) {
        return Finding{"exception", step, error.what()};
    }
}

} // namespace worlds
