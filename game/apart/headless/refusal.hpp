// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/assets.hpp>
#include <apart/core/text_file.hpp>

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace apart {

/// Thrown to end the program with a sentence on stderr and exit code 2.
struct Refusal {
    std::string sentence;
};

template <typename T>
T valueOrRefuse(Read<T> read) {
    if (const auto* problem = std::get_if<FileProblem>(&read)) {
        std::string all;
        for (const std::string& text : problem->texts()) {
            all += (all.empty() ? "" : "\n") + text;
        }
        throw Refusal{all};
    }
    return std::get<T>(std::move(read));
}

/// Names of all levels. Throws Refusal if there are none.
inline std::vector<std::string> namesOfLevels() {
    std::vector<std::string> names = levelNames();
    if (names.empty()) {
        throw Refusal{assetsFolder().string() + ": there are no levels in it"};
    }
    return names;
}

} // namespace apart
