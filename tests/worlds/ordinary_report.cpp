// SPDX-License-Identifier: MIT
#include <worlds/ordinary.hpp>

#include <atomic>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <thread>

namespace worlds {
namespace {

constexpr std::size_t kEngines = 2;
constexpr int kShrinkTries = 1000;
constexpr const char* kEngineNames[kEngines] = {sizeof(kodo::Real) == 4 ? "float" : "double",
                                                "box2d3"};

/// Counts of a family.
struct Row {
    int scenes = 0;
    struct Side {
        int faulty = 0;
        double seconds = 0;
        std::vector<int> byJudge = std::vector<int>(ordinaryJudges().size());
    };
    Side sides[kEngines];

    void add(const Row& other) {
        scenes += other.scenes;
        for (std::size_t e = 0; e < kEngines; ++e) {
            sides[e].faulty += other.sides[e].faulty;
            sides[e].seconds += other.sides[e].seconds;
            for (std::size_t j = 0; j < sides[e].byJudge.size(); ++j) {
                sides[e].byJudge[j] += other.sides[e].byJudge[j];
            }
        }
    }
};

class OrdinaryReport {
public:
    explicit OrdinaryReport(const OrdinaryOptions& options)
        : options_(options),
          engines_(hasOrdinaryBox2d3() ? 2 : 1),
          rows_(ordinaryFamilies().size()) {}

    bool run() {
        std::vector<std::thread> threads;
        for (unsigned i = 0; i < options_.jobs; ++i) {
            threads.emplace_back([this] { work(); });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        return print();
    }

private:
    void work() {
        for (std::uint64_t index = next_++; index < options_.count; index = next_++) {
            const std::uint64_t seed = options_.seed + index;
            const Recipe recipe = ordinaryRecipe(seed);
            for (std::size_t e = 0; e < engines_; ++e) {
                const auto engine = e == 0 ? ordinaryInKodo(recipe) : ordinaryInBox2d3(recipe);
                const OrdinaryRun run = runOrdinary(recipe, *engine);
                note(seed, recipe, e, run);
                if (e == 0 && !options_.shrunkInto.empty()) {
                    save(seed, recipe, run);
                }
            }
        }
    }

    void note(std::uint64_t seed, const Recipe& recipe, std::size_t e, const OrdinaryRun& run) {
        const std::lock_guard lock(mutex_);
        Row& row = rows_[ordinaryFamily(seed)];
        row.scenes += e == 0 ? 1 : 0;
        row.sides[e].seconds += run.seconds;
        row.sides[e].faulty += run.faults.empty() ? 0 : 1;
        for (const Finding& fault : run.faults) {
            for (std::size_t j = 0; j < ordinaryJudges().size(); ++j) {
                row.sides[e].byJudge[j] += ordinaryJudges()[j] == fault.judge ? 1 : 0;
            }
            std::printf("%s: seed %llu (%s, %.0f Hz): %s, step %d: %s\n", kEngineNames[e],
                        static_cast<unsigned long long>(seed),
                        ordinaryFamilies()[ordinaryFamily(seed)],
                        1 / static_cast<double>(recipe.dt), fault.judge.c_str(), fault.step,
                        fault.text.c_str());
        }
        std::fflush(stdout);
    }

    void save(std::uint64_t seed, const Recipe& recipe, const OrdinaryRun& run) const {
        for (const Finding& fault : run.faults) {
            const Judge judge = [&](const Recipe& smaller) {
                return judgeOrdinary(smaller, fault.judge);
            };
            std::ofstream(options_.shrunkInto + "/ordinary_" + fault.judge + "_" + kEngineNames[0] +
                          "_" + std::to_string(seed) + ".world")
                << toText(shrink(recipe, fault, judge, kShrinkTries));
        }
    }

    void printRow(const char* name, const Row& row) const {
        std::printf("%-17s %6d", name, row.scenes);
        for (std::size_t e = 0; e < engines_; ++e) {
            const Row::Side& side = row.sides[e];
            std::printf(" | %6d %5.1f%%", side.faulty,
                        100.0 * side.faulty / std::max(1, row.scenes));
            for (const int count : side.byJudge) {
                std::printf(" %7d", count);
            }
            std::printf(" %8.2f", side.seconds);
        }
        std::printf("\n");
    }

    /// True if Kodo has no fault.
    bool print() const {
        std::printf("%-17s %6s", "family", "scenes");
        for (std::size_t e = 0; e < engines_; ++e) {
            std::printf(" | %6s %6s", kEngineNames[e], "");
            for (const char* const judge : ordinaryJudges()) {
                std::printf(" %7s", judge);
            }
            std::printf(" %8s", "s");
        }
        std::printf("\n");
        Row all;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            printRow(ordinaryFamilies()[i], rows_[i]);
            all.add(rows_[i]);
        }
        printRow("all", all);
        return all.sides[0].faulty == 0;
    }

    const OrdinaryOptions& options_;
    std::size_t engines_;
    std::atomic<std::uint64_t> next_{0};
    std::mutex mutex_;
    std::vector<Row> rows_; // by family
};

} // namespace

bool reportOrdinary(const OrdinaryOptions& options) {
    return OrdinaryReport(options).run();
}

} // namespace worlds
