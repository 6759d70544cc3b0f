// SPDX-License-Identifier: MIT
#include "tours.hpp"

#include "parts.hpp"

namespace destructoooor {

namespace {

constexpr Real kSettled = 2; // s

/// The default solver, without sleep, so that overlap stays in sight.
kodo::StepSettings present() {
    kodo::StepSettings settings = kodo::balanced();
    settings.leaveOut = kodo::Feature::Sleep;
    return settings;
}

Tour iterations() {
    return {
        "Iterations against overlap",
        "Overlap grows with the load; more iterations take it away.",
        {{"Four heights",
          "An iteration tells each box of its neighbours alone. The weight of twelve boxes needs "
          "many to reach the ground.",
          "The lower half of each stack: the higher it is, the deeper boxes overlap.",
          thesisWith(8, 8, 0),
          kSettled,
          {15, 200}},
         {"Few iterations",
          "Two iterations for ten rows: most of the weight is never carried.",
          "The pyramid sinks into itself, row by row.",
          thesisWith(2, 2, 0),
          kSettled,
          {100, 1000}},
         {"Few iterations",
          "The same pyramid with ten iterations.",
          "It stands. The deepest overlap is some centimetres, at the bottom.",
          thesisWith(10, 10, 0),
          kSettled,
          {5, 60}},
         {"Few iterations",
          "And with sixty: overlap is gone, but each one visits all contacts.",
          "The visits of contacts: four times those of the stop before.",
          thesisWith(40, 60, 0),
          kSettled,
          {0, 5}},
         {"Few iterations",
          "The default solver of today makes five short steps instead of one long one.",
          "Less overlap than with sixty iterations, for a twelfth of the visits.",
          present(),
          kSettled,
          {0, 2}}}};
}

Tour shock() {
    return {
        "Shock propagation off and on",
        "Level by level from the ground up, a few passes carry any weight.",
        {{"Shock propagation off",
          "Two iterations cannot carry twelve boxes.",
          "The tower is squeezed, then it falls.",
          thesisWith(5, 2, 0),
          kSettled,
          {100, 1100}},
         {"Shock propagation on",
          "Two shock passes more. Each level is solved once, then it is a floor for the next one.",
          "The tower stands. Red outlines: the same one without shock passes.",
          thesisWith(5, 2, 2),
          kSettled,
          {0, 2},
          thesisWith(5, 2, 0)},
         {"Heavy on light",
          "200 kg on five boxes of 1 kg, with ten iterations and no shock pass.",
          "The heavy box goes through the light ones to the ground.",
          thesisWith(5, 10, 0),
          kSettled,
          {100, 2000}},
         {"Heavy on light",
          "The same with four shock passes.",
          "Nothing overlaps: a floor does not care how heavy the next level is.",
          thesisWith(5, 10, 4),
          kSettled,
          {0, 2}},
         {"Heavy on light",
          "The default solver of today has no shock passes: five short steps carry the weight.",
          "It holds, with some millimetres of overlap. Red outlines: with shock passes.",
          present(),
          kSettled,
          {2, 20},
          thesisWith(5, 10, 4)}}};
}

} // namespace

std::span<const Tour> tours() {
    static const std::vector<Tour> all{iterations(), shock()};
    return all;
}

} // namespace destructoooor
