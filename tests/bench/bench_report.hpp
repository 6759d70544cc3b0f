// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "bench_run.hpp"

namespace bench {

/// Summary of several equal runs, which differ only in time.
struct Summary {
    Result result; // the run with the median time
    int runs = 0;
    double spread = 0; // (slowest - fastest) / median
    // Comparison with another engine, run alternately.
    std::string against;
    double ratio = 0; // of the median times; below 1: faster than the other
};

/// An engine reached different final states in one scene, which invalidates its results.
struct NotRepeatable : std::logic_error {
    using std::logic_error::logic_error;
};

/// Summarises one or more runs. Throws NotRepeatable if their final states differ.
Summary summaryOf(std::vector<Result> results);

/// One line with one object. A number that is not finite becomes null, as JSON has none.
std::string asJson(const Summary& summary, bool stages);
/// Human-readable text.
std::string asText(const Summary& summary, bool stages);

} // namespace bench
