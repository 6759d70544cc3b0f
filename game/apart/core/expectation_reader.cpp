// SPDX-License-Identifier: MIT
#include <apart/core/expectation_reader.hpp>

namespace apart {

namespace {

/// A tick, or two with a hyphen between them. Returns why the word is none, or "".
std::string readSpan(std::string_view word, Expectation& expectation) {
    const std::size_t hyphen = word.find('-');
    const bool two = hyphen != std::string_view::npos;
    const std::optional<std::uint32_t> from = two ? tickOf(word.substr(0, hyphen)) : 0;
    const std::optional<std::uint32_t> to = tickOf(two ? word.substr(hyphen + 1) : word);
    if (!from || !to) {
        return quoted(word) + " is no span: TICK or FROM-TO, with whole numbers from 0 to " +
               std::to_string(kLongestReplay);
    }
    if (*from > *to) {
        return quoted(word) + " is no span FROM-TO: FROM must not be above TO";
    }
    expectation.from = *from;
    expectation.tick = *to;
    return "";
}

/// Both operators of equality; the others need an order.
bool isEquality(Comparison comparison) {
    return comparison == Comparison::Equal || comparison == Comparison::NotEqual;
}

/// The value of a field that has names, by its name.
std::string readName(const Words& words, std::size_t at, std::span<const std::string_view> names,
                     Expectation& expectation) {
    if (!isEquality(expectation.comparison)) {
        return std::string(words[at]) +
               " has names, which have no order: its operators are == and !=";
    }
    const std::optional<std::size_t> name = indexOf(words[at + 2], names);
    if (!name) {
        std::string reason =
            quoted(words[at + 2]) + " is no value of " + std::string(words[at]) + ", which is";
        for (std::size_t i = 0; i < names.size(); ++i) {
            reason += (i == 0                  ? " "
                       : i + 1 == names.size() ? " or "
                                               : ", ") +
                      std::string(names[i]);
        }
        return reason;
    }
    expectation.value = static_cast<std::int64_t>(*name);
    return "";
}

/// Field, operator and value, from the word `at` on.
std::string readComparison(const Words& words, std::size_t at, Expectation& expectation) {
    const std::optional<std::size_t> field = indexOf(words[at], kFieldNames);
    const std::optional<std::size_t> comparison = indexOf(words[at + 1], kComparisonNames);
    if (!field) {
        return "there is no field " + quoted(words[at]);
    }
    if (!comparison) {
        return "there is no operator " + quoted(words[at + 1]);
    }
    expectation.field = static_cast<Field>(*field);
    expectation.comparison = static_cast<Comparison>(*comparison);
    if (const auto names = valueNames(expectation.field); !names.empty()) {
        return readName(words, at, names, expectation);
    }
    const std::optional<std::int64_t> value = toNumber(words[at + 2]);
    if (!value) {
        return quoted(words[at + 2]) + " is no value of " + std::string(words[at]) +
               ", which is a whole number";
    }
    expectation.value = *value;
    return "";
}

} // namespace

std::string readExpectation(const Words& words, Expectation& expectation) {
    const std::optional<std::size_t> when =
        words.size() == 6 ? indexOf(words[1], kWhenNames) : std::optional<std::size_t>(0);
    if (!when || words.size() < 5 || words.size() > 6) {
        return "an expectation reads: expect TICK FIELD OPERATOR VALUE, or with by, never or "
               "always and a span FROM-TO in place of the tick";
    }
    const std::size_t at = words.size() - 4;
    expectation.when = static_cast<When>(*when);
    if (expectation.when == When::At) {
        const std::optional<std::uint32_t> tick = tickOf(words[at]);
        if (!tick) {
            return tickReason(words[at]);
        }
        expectation.from = expectation.tick = *tick;
    } else if (std::string reason = readSpan(words[at], expectation); !reason.empty()) {
        return reason;
    }
    return readComparison(words, at + 1, expectation);
}

} // namespace apart
