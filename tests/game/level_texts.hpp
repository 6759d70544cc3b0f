// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level_file.hpp>

#include <gtest/gtest.h>

#include <string>

namespace apart {

/// The text of a level with one substring replaced.
inline std::string changed(std::string text, const std::string& before, const std::string& after) {
    const std::size_t place = text.find(before);
    EXPECT_NE(place, std::string::npos) << before;
    return text.replace(place, before.size(), after);
}

/// The problem in the text of a level, or "none".
inline std::string problemOf(const std::string& text) {
    const Read<Level> level = parseLevel(text, "test", "test.toml");
    const auto* problem = std::get_if<FileProblem>(&level);
    return problem != nullptr ? problem->text() : "none";
}

} // namespace apart
