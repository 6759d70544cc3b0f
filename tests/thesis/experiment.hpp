// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/debug_draw.hpp>
#include <kodo/kodo.hpp>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The figures and lessons of the thesis [Thesis06], measured again.
namespace thesis {

/// A measured number and the range that a law gives it.
struct Row {
    std::string what{};
    std::string setting{}; // profile or method
    std::string unit{};
    double value = 0;
    std::optional<double> low{}; // without low and high: shown, not judged
    std::optional<double> high{};
    std::string law{}; // the reason of the range

    Row& atLeast(double bound, std::string why) {
        low = bound;
        law = std::move(why);
        return *this;
    }
    Row& atMost(double bound, std::string why) {
        high = bound;
        law = std::move(why);
        return *this;
    }
    Row& near(double exact, double tolerance, std::string why) {
        low = exact - tolerance;
        high = exact + tolerance;
        law = std::move(why);
        return *this;
    }
};

struct Picture {
    std::string caption;
    std::string svg;
};

struct Curve {
    std::string name;
    std::vector<std::array<double, 2>> points;
};

struct Chart {
    std::string caption;
    std::string across; // name and unit of each axis
    std::string up;
    bool logarithmic = false; // both axes
    std::vector<Curve> curves{};
};

/// One section of the page; tools/lib/thesis.py has its words, by id.
struct Experiment {
    std::string id;
    std::vector<Row> rows{};
    std::vector<Picture> pictures{};
    std::vector<Chart> charts{};

    Row& add(std::string what, std::string setting, double value, std::string unit = "") {
        return rows.emplace_back(
            Row{std::move(what), std::move(setting), std::move(unit), value, {}, {}, {}});
    }
};

/// A profile with its name. Nothing sleeps, so that all is measured.
struct Profile {
    const char* name;
    kodo::StepSettings settings;
};

inline std::array<Profile, 2> profiles() {
    std::array<Profile, 2> both{Profile{"thesis2006()", kodo::thesis2006()},
                                Profile{"balanced()", kodo::balanced()}};
    for (Profile& profile : both) {
        profile.settings.leaveOut = kodo::Feature::Sleep;
    }
    return both;
}

/// The solver of the thesis with these passes.
inline kodo::StepSettings passes(int impacts, int contacts, int shocks) {
    kodo::StepSettings settings = kodo::thesis2006();
    settings.propagation().impactPasses = impacts;
    settings.propagation().contactPasses = contacts;
    settings.propagation().shockPasses = shocks;
    settings.leaveOut = kodo::Feature::Sleep;
    return settings;
}

/// How long experiments run: a test takes the short ones, by the same laws.
struct Extent {
    bool quick = false;
    int of(int whole, int short_) const { return quick ? short_ : whole; }
};

// Each file of the folder has some of them.
void addGeometry(std::vector<Experiment>& book);
void addMotion(std::vector<Experiment>& book, Extent extent);
void addCollisions(std::vector<Experiment>& book, Extent extent);
void addPiles(std::vector<Experiment>& book, Extent extent);
void addRest(std::vector<Experiment>& book, Extent extent);
void addLeaveOut(std::vector<Experiment>& book, Extent extent);
void addGame(std::vector<Experiment>& book);

} // namespace thesis
