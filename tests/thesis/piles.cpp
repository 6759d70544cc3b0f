// SPDX-License-Identifier: MIT
// Stacks: pairwise passes (fig. 4.5), shock propagation on and off, iterations against overlap, the
// order of passes (4.2.2, appendix A).
#include <support/depth.hpp>
#include <support/scenes.hpp>

#include <algorithm>
#include <cmath>

#include "experiment.hpp"

namespace thesis {

namespace {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;
using kodo::World;
using support::kDt;

constexpr Vec2 kDown{0, -10};

/// A tower and what has become of it.
struct Tower {
    World world;
    std::vector<BodyId> boxes;
    double overlap = 0; // m, the deepest from the first second on
    double off = 0;     // m, largest distance of a box from where it was put

    Tower(const kodo::StepSettings& settings, int count, Real seconds, int rate = 60)
        : world({.gravity = kDown, .settings = settings}) {
        support::addFloor(world);
        boxes = support::addStack(world, count);
        for (int i = 1; i <= static_cast<int>(seconds * Real(rate)); ++i) {
            world.step(Real(1) / Real(rate));
            if (i % rate == 0) {
                overlap = std::max(overlap, static_cast<double>(support::maxOverlap(world)));
            }
        }
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Vec2 place{0, Real(0.5) + Real(i)};
            off = std::max(off, static_cast<double>(length(world[boxes[i]].position() - place)));
        }
    }
    bool stands() const { return off < 0.25; }
    std::string drawn() const {
        return kodo::svg(world, {.contacts = true}, kodo::Aabb{{-7, -1}, {7, 13}});
    }
};

void addPairwise(std::vector<Experiment>& book) {
    Experiment one{"pairwise"};
    Chart chart{"Boxes of a stack of ten that the first step stops", "passes over the contacts",
                "boxes"};
    // Boxes that fall slower than a share of g h after some steps.
    const auto stoppedBy = [](const kodo::StepSettings& settings, Real share, int steps = 1) {
        World world({.gravity = kDown, .settings = settings});
        support::addFloor(world);
        const std::vector<BodyId> boxes = support::addStack(world, 10);
        support::run(world, steps);
        return static_cast<double>(std::count_if(boxes.begin(), boxes.end(), [&](BodyId id) {
            return world[id].velocity().y > -share * 10 * kDt;
        }));
    };
    chart.curves = {{"felt the floor", {}}, {"lost half of g h", {}}};
    const std::string felt = "boxes of ten that have felt the floor in the first step";
    const std::string half = "boxes of ten that have lost half of g h in it";
    for (const int count : {1, 2, 3, 5, 10, 20, 40}) {
        const kodo::StepSettings settings = passes(count, count, 0);
        const std::string setting =
            std::to_string(count) + (count > 1 ? " passes" : " pass") + ", shock off";
        const double some = stoppedBy(settings, Real(0.999));
        const double most = stoppedBy(settings, Real(0.5));
        one.add(felt, setting, some)
            .atLeast(std::min(count, 10), "each pass takes the news one box up, at least");
        one.add(half, setting, most);
        chart.curves[0].points.push_back({static_cast<double>(count), some});
        chart.curves[1].points.push_back({static_cast<double>(count), most});
    }
    for (const Profile& profile : profiles()) {
        one.add(half, profile.name, stoppedBy(profile.settings, Real(0.5)));
        one.add("boxes of ten that fall slower than that after 1 s", profile.name,
                stoppedBy(profile.settings, Real(0.5), 60))
            .near(10, 0, "a stack that stands is stopped as a whole");
    }
    one.charts.push_back(chart);
    book.push_back(one);
}

void addShock(std::vector<Experiment>& book, Extent extent) {
    Experiment one{"shock"};
    const Real seconds = Real(extent.of(10, 3));
    const Tower off(passes(5, 2, 0), 12, seconds);
    const Tower on(passes(5, 2, 2), 12, seconds);
    const Tower soft(profiles()[1].settings, 12, seconds);
    const std::string what =
        "tower of twelve after " + std::to_string(static_cast<int>(seconds)) + " s: ";
    one.add(what + "deepest overlap", "2 passes, shock off", off.overlap, "m")
        .atLeast(0.05, "seen with bare eyes: 5 % of a box");
    one.add(what + "deepest overlap", "2 passes, shock on", on.overlap, "m")
        .atMost(0.01, "1 % of a box");
    one.add(what + "deepest overlap", "balanced()", soft.overlap, "m").atMost(0.01, "likewise");
    one.add(what + "a box is off its place by", "2 passes, shock off", off.off, "m")
        .atLeast(1, "it falls: a box is off by its own size");
    one.add(what + "a box is off its place by", "2 passes, shock on", on.off, "m")
        .atMost(0.25, "it stands");
    one.add(what + "a box is off its place by", "balanced()", soft.off, "m")
        .atMost(0.25, "it stands");
    for (const Profile& profile : profiles()) {
        World world({.gravity = kDown, .settings = profile.settings});
        support::addFloor(world);
        support::addStack(world, 5);
        kodo::BodyDef heavy = support::boxDef({0, 6}, 2, 2);
        heavy.density = 50;
        const BodyId top = world.add(heavy);
        support::run(world, 300);
        one.add("a box of 200 kg sinks on five of 1 kg by", profile.name,
                6 - static_cast<double>(world[top].position().y), "m")
            .atMost(0.25, "each level becomes a floor for the next; 5 % of the stack");
    }
    one.pictures.push_back({"2 passes, shock off", off.drawn()});
    one.pictures.push_back({"2 passes, shock on", on.drawn()});
    one.pictures.push_back({"balanced()", soft.drawn()});
    book.push_back(one);
}

/// A pyramid of that many rows, and its boxes.
std::vector<BodyId> addPyramid(World& world, int rows) {
    std::vector<BodyId> boxes;
    support::addFloor(world);
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < rows - row; ++i) {
            const Real x = (Real(i) - Real(rows - 1 - row) / 2) * Real(1.1);
            boxes.push_back(world.add(support::boxDef({x, Real(0.5) + Real(row)}, 1, 1)));
        }
    }
    return boxes;
}

void addIterations(std::vector<Experiment>& book, Extent extent) {
    Experiment one{"iterations"};
    const int rows = extent.of(10, 6);
    const std::string what = "deepest overlap in a pyramid of " + std::to_string(rows) + " rows";
    Chart chart{"Deepest overlap after 2 s", "passes over collisions and contacts", "overlap (m)",
                true};
    chart.curves = {{"shock off", {}}, {"4 shock passes", {}}};
    const auto overlapWith = [&](const kodo::StepSettings& settings) {
        World world({.gravity = kDown, .settings = settings});
        addPyramid(world, rows);
        support::run(world, 120);
        return static_cast<double>(support::maxOverlap(world));
    };
    double first = 0;
    for (const int count : {2, 5, 10, 20, 40, 80}) {
        const double plain = overlapWith(passes(count, count, 0));
        first = count == 2 ? plain : first;
        chart.curves[0].points.push_back({static_cast<double>(count), plain});
        Row& row = one.add(what, std::to_string(count) + " passes, shock off", plain, "m");
        if (count > 2) {
            row.atMost(count >= 40 ? first / 2 : 1.05 * first,
                       count >= 40 ? "half of that with 2 passes" : "that with 2 passes, and 5 %");
        }
        chart.curves[1].points.push_back(
            {static_cast<double>(count), overlapWith(passes(count, count, 4))});
    }
    one.add(what, "balanced()", overlapWith(profiles()[1].settings), "m")
        .atMost(0.01, "1 % of a box");
    Chart heights{"Deepest overlap in a tower after 1 s, over its height", "boxes", "overlap (m)"};
    heights.curves = {{"10 passes, shock off", {}}, {"thesis2006()", {}}, {"balanced()", {}}};
    for (const int count : {2, 4, 8, 12, 16}) {
        const std::array<kodo::StepSettings, 3> ways{passes(10, 10, 0), profiles()[0].settings,
                                                     profiles()[1].settings};
        for (std::size_t i = 0; i < ways.size(); ++i) {
            heights.curves[i].points.push_back(
                {static_cast<double>(count), Tower(ways[i], count, 1).overlap});
        }
    }
    const auto& plain = heights.curves[0].points;
    for (std::size_t i = 1; i < plain.size(); ++i) {
        one.add("overlap in a tower of " + std::to_string(static_cast<int>(plain[i][0])) +
                    " after 1 s",
                "10 passes, shock off", plain[i][1], "m")
            .atLeast(plain[i - 1][1], "more than in the lower tower");
    }
    one.charts = {chart, heights};
    book.push_back(one);
}

void addStacks(std::vector<Experiment>& book, Extent extent) {
    Experiment one{"stacks"};
    const Real seconds = Real(extent.of(30, 5));
    for (const int rate : {30, 60, 240}) {
        for (const int count : {3, 10, 20}) {
            const std::string what = std::to_string(count) + " boxes at " + std::to_string(rate) +
                                     " Hz: the worst is off by";
            for (const Profile& profile : profiles()) {
                one.add(what, profile.name, Tower(profile.settings, count, seconds, rate).off, "m")
                    .atMost(0.25, "it stands: no box is a quarter of its width off");
            }
            if (rate == 60) {
                one.add(what, "10 passes, shock off", Tower(passes(5, 10, 0), count, seconds).off,
                        "m");
            }
        }
    }
    book.push_back(one);
}

void addOrder(std::vector<Experiment>& book, Extent extent) {
    Experiment one{"order"};
    for (const Profile& profile : profiles()) {
        World world({.gravity = kDown, .settings = profile.settings});
        const std::vector<BodyId> boxes = addPyramid(world, extent.of(10, 6));
        support::run(world, extent.of(600, 180));
        double drift = 0;
        double largest = 0;
        for (const BodyId id : boxes) {
            drift += static_cast<double>(world[id].position().x);
            largest = std::max(largest, std::fabs(static_cast<double>(world[id].velocity().x)));
        }
        one.add("mean drift of a symmetric pyramid to the right", profile.name,
                drift / static_cast<double>(boxes.size()), "m")
            .near(0, 0.02, "no side is preferred; 2 % of a box");
        one.pictures.push_back({profile.name, kodo::svg(world, {}, kodo::Aabb{{-7, -1}, {7, 11}})});
    }
    book.push_back(one);
}

} // namespace

void addPiles(std::vector<Experiment>& book, Extent extent) {
    addPairwise(book);
    addShock(book, extent);
    addIterations(book, extent);
    addStacks(book, extent);
    addOrder(book, extent);
}

} // namespace thesis
