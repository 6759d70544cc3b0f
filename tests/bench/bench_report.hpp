// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "bench_run.hpp"

namespace bench {

/// Several runs of the same thing: they differ in nothing but time.
struct Summary {
    Result result; // of the run with the median time
    int runs = 0;
    double spread = 0; // (slowest - fastest) / median
    // Beside another engine, run in turn.
    std::string against;
    double ratio = 0; // of the median times; below 1 is faster than the other
};

/// An engine that ends one scene in two states: no figure of it means anything.
struct NotRepeatable : std::logic_error {
    using std::logic_error::logic_error;
};

/// Of one run or more. Throws NotRepeatable when they end in different states.
Summary summaryOf(std::vector<Result> results);

/// One line, one object. A number that is not finite becomes null, as JSON has none.
std::string asJson(const Summary& summary, bool stages);
/// For people.
std::string asText(const Summary& summary, bool stages);

} // namespace bench
