// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace apart {

/// A level whose file is read again whenever it changes.
struct Reload {
    static constexpr double kNewsSeconds = 5;

    double at = 0;                     // s, of the next look at the file
    std::vector<std::string> faults{}; // of the file
    std::string news{};                // a sentence about the last change, or empty
    double newsAt = 0;                 // s, since when it is shown

    bool hasNews(double now) const {
        return faults.empty() && !news.empty() && now < newsAt + kNewsSeconds;
    }
    /// The first error, and the number of the others.
    std::vector<std::string> notes() const;
};

} // namespace apart
