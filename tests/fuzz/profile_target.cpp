// SPDX-License-Identifier: MIT
// Any text as a profile: it is refused with a sentence, or its text is stable.
#include <apart/stage/records/profile_file.hpp>

#include <fuzz/fuzz.hpp>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto read = apart::profileFrom(fuzz::textOf(data, size), "fuzz.toml");
    if (const auto* problem = std::get_if<apart::FileProblem>(&read)) {
        fuzz::require(!problem->reason.empty(), "a profile is refused without a reason");
        return 0;
    }
    const std::string text = apart::toText(std::get<apart::Profile>(read));
    const auto again = apart::profileFrom(text, "again.toml");
    fuzz::require(std::holds_alternative<apart::Profile>(again), "a written profile is refused");
    fuzz::require(apart::toText(std::get<apart::Profile>(again)) == text,
                  "a written profile is another one");
    return 0;
}
