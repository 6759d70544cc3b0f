// SPDX-License-Identifier: MIT
#include <apart/core/replay.hpp>

namespace apart {

namespace {

std::string valueText(Field field, std::int64_t value) {
    const std::span<const std::string_view> names = valueNames(field);
    const bool named = value >= 0 && value < static_cast<std::int64_t>(names.size());
    return named ? std::string(names[static_cast<std::size_t>(value)]) : std::to_string(value);
}

std::string fieldName(Field field) {
    return std::string(kFieldNames[static_cast<std::size_t>(field)]);
}

} // namespace

std::string Expectation::text() const {
    std::string span = std::to_string(tick);
    if (when == When::Never || when == When::Always || (when == When::By && from > 0)) {
        span = std::to_string(from) + "-" + span;
    }
    if (when != When::At) {
        span = std::string(kWhenNames[static_cast<std::size_t>(when)]) + " " + span;
    }
    return "expect " + span + " " + fieldName(field) + " " +
           std::string(kComparisonNames[static_cast<std::size_t>(comparison)]) + " " +
           valueText(field, value);
}

std::string Playback::Failure::text() const {
    return expectation.text() + ", but " + fieldName(expectation.field) + " is " +
           valueText(expectation.field, found) +
           (expectation.when == When::At ? "" : " at tick " + std::to_string(tick));
}

std::string toText(const Replay& replay) {
    std::string text = "apart-replay 3\nlevel " + replay.level;
    if (replay.levelDigest) {
        text += " " + toHex(*replay.levelDigest);
    }
    text += "\n";
    if (replay.rules) {
        text += "rules " + std::to_string(*replay.rules) + "\n";
    }
    text += "seed " + std::to_string(replay.seed) + "\n";
    if (replay.mode != Mode::Standard) {
        text += std::string(kModeNames[static_cast<std::size_t>(replay.mode)]) + "\n";
    }
    if (replay.handwritten) {
        text += "handwritten\n";
    }
    text += "# tick paddle target launch force aim\n";
    for (const auto& [tick, input] : replay.inputs) {
        text += std::to_string(tick) + " " + std::to_string(input.paddle) + " " +
                (input.target ? std::to_string(*input.target) : "-") +
                (input.launch ? " 1 " : " 0 ");
        text += kForceNames[static_cast<std::size_t>(input.force)];
        if (input.aim) {
            text += ' ';
            text += std::to_string(*input.aim);
        }
        text += '\n';
    }
    for (const HashMark& mark : replay.hashes) {
        text += "hash " + std::to_string(mark.tick) + " " + toHex(mark.hash) + "\n";
    }
    for (const Expectation& expectation : replay.expectations) {
        text += expectation.text() + "\n";
    }
    text += "end " + std::to_string(replay.end) + "\n";
    if (!replay.handwritten) {
        text += "digest " + toHex(digestOf(text)) + "\n";
    }
    return text;
}

} // namespace apart
