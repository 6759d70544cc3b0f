// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/text_file.hpp>

#include <string>
#include <utility>
#include <variant>

namespace apart {

/// A sentence for stderr, and exit code 2.
struct Refusal {
    std::string sentence;
};

template <typename T>
T valueOrRefuse(Read<T> read) {
    if (const auto* problem = std::get_if<FileProblem>(&read)) {
        throw Refusal{problem->text()};
    }
    return std::get<T>(std::move(read));
}

} // namespace apart
