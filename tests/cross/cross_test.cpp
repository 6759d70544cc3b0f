// SPDX-License-Identifier: MIT
// Judges every scene of the book: Kodo's two solvers beside Box2D 2.4.1 and the closed forms.
// `tools/crosscheck` shows the same scenes as a page.
#include <kodo/real.hpp>

#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <string>

#include "cross_scene.hpp"

namespace crosscheck {
namespace {

std::string line(const Figure& figure, double kodo, double box2d, double tolerance) {
    char text[200];
    std::snprintf(text, sizeof text, "%-40s %14.7g %14.7g %14.7g %14.4g %s",
                  (figure.what + " [" + figure.unit + "]").c_str(), kodo, box2d, figure.exact,
                  tolerance, figure.reason.c_str());
    return text;
}

class CrossScenes : public testing::TestWithParam<std::size_t> {
protected:
    void judge(Solver solver) {
        const CrossScene& scene = sceneBook()[GetParam()];
        const Played kodo = play(scene, *KODO_PRECISION::makeKodo(scene.def, solver));
        const Played box2d = play(scene, *makeBox2d(scene.def, scene.bounceThreshold));
        ASSERT_EQ(kodo.values.size(), scene.figures.size());
        for (std::size_t i = 0; i < scene.figures.size(); ++i) {
            const Figure& figure = scene.figures[i];
            EXPECT_TRUE(holds(figure, solver, kodo.values[i], box2d.values[i]))
                << "                                         Kodo          Box2D    closed form"
                << "      tolerance\n"
                << line(figure, kodo.values[i], box2d.values[i], toleranceOf(figure, solver));
        }
    }
};

TEST_P(CrossScenes, SoftSolverAgrees) {
    judge(Solver::Soft);
}

TEST_P(CrossScenes, PropagationAgrees) {
    judge(Solver::Propagation);
}

INSTANTIATE_TEST_SUITE_P(Book, CrossScenes, testing::Range(std::size_t{0}, sceneBook().size()),
                         [](const auto& given) { return sceneBook()[given.param].name; });

TEST(CrossBook, EveryJudgedFigureStatesTheReasonOfItsTolerance) {
    std::set<std::string> names;
    for (const CrossScene& scene : sceneBook()) {
        EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
        EXPECT_FALSE(scene.drawn.empty()) << scene.name;
        for (const Figure& figure : scene.figures) {
            EXPECT_TRUE(figure.rule == Rule::Show || !figure.reason.empty())
                << scene.name << ": " << figure.what;
            EXPECT_TRUE(!figure.propagation || !figure.propagation->reason.empty())
                << scene.name << ": " << figure.what;
        }
    }
}

} // namespace
} // namespace crosscheck
