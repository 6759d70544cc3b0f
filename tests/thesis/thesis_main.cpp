// SPDX-License-Identifier: MIT
// Writes all experiments as JSON, for the page of tools/thesis. `--quick` is for tests.
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string_view>

#include "experiment.hpp"

namespace thesis {
namespace {

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            result += '\\';
        }
        result += c == '\n' ? std::string("\\n") : std::string(1, c);
    }
    return result + "\"";
}

std::string number(double value) {
    if (!std::isfinite(value)) {
        return "null";
    }
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

std::string bound(const std::optional<double>& value) {
    return value ? number(*value) : "null";
}

/// "[a,b,c]" of what `print` makes of each.
template <typename List, typename Print>
std::string listOf(const List& list, Print print) {
    std::string result;
    for (const auto& one : list) {
        result += (result.empty() ? "" : ",") + print(one);
    }
    return "[" + result + "]";
}

std::string rowOf(const Row& row) {
    return "{\"what\":" + quoted(row.what) + ",\"setting\":" + quoted(row.setting) +
           ",\"unit\":" + quoted(row.unit) + ",\"value\":" + number(row.value) +
           ",\"low\":" + bound(row.low) + ",\"high\":" + bound(row.high) +
           ",\"law\":" + quoted(row.law) + "}";
}

std::string curveOf(const Curve& curve) {
    return "{\"name\":" + quoted(curve.name) + ",\"points\":" +
           listOf(curve.points,
                  [](const std::array<double, 2>& p) {
                      return "[" + number(p[0]) + "," + number(p[1]) + "]";
                  }) +
           "}";
}

std::string chartOf(const Chart& chart) {
    return "{\"caption\":" + quoted(chart.caption) + ",\"across\":" + quoted(chart.across) +
           ",\"up\":" + quoted(chart.up) +
           ",\"logarithmic\":" + (chart.logarithmic ? "true" : "false") +
           ",\"curves\":" + listOf(chart.curves, curveOf) + "}";
}

std::string pictureOf(const Picture& picture) {
    return "{\"caption\":" + quoted(picture.caption) + ",\"svg\":" + quoted(picture.svg) + "}";
}

std::string experimentOf(const Experiment& one) {
    return "{\"id\":" + quoted(one.id) + ",\"rows\":" + listOf(one.rows, rowOf) +
           ",\n\"pictures\":" + listOf(one.pictures, pictureOf) +
           ",\n\"charts\":" + listOf(one.charts, chartOf) + "}\n";
}

std::vector<Experiment> allOf(Extent extent) {
    std::vector<Experiment> book;
    addGeometry(book);
    addMotion(book, extent);
    addCollisions(book, extent);
    addPiles(book, extent);
    addRest(book, extent);
    addLeaveOut(book, extent);
    addGame(book);
    return book;
}

} // namespace
} // namespace thesis

int main(int count, char** arguments) {
    const bool quick = count == 2 && std::string_view(arguments[1]) == "--quick";
    if (count > 1 && !quick) {
        std::cerr << "usage: thesis_lab [--quick]\n";
        return 2;
    }
    try {
        std::cout << thesis::listOf(thesis::allOf({quick}), thesis::experimentOf) << "\n";
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
    return 0;
}
