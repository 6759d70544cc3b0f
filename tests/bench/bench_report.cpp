// SPDX-License-Identifier: MIT
#include "bench_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bench {
namespace {

/// Writes one JSON object. Names and texts need no JSON escapes.
class JsonObject {
public:
    void add(const char* name, double value) {
        raw(name, std::isfinite(value) ? fmt::format("{}", value) : "null");
    }
    void add(const char* name, std::size_t value) { raw(name, std::to_string(value)); }
    void add(const char* name, int value) { raw(name, std::to_string(value)); }
    void add(const char* name, const std::string& text) { raw(name, '"' + text + '"'); }
    template <typename T>
    void add(const char* name, const std::optional<T>& value) {
        value ? add(name, *value) : raw(name, "null");
    }
    void raw(const char* name, const std::string& value) {
        text_ += fmt::format(R"({}"{}": {})", text_.empty() ? "" : ", ", name, value);
    }
    std::string text() const { return '{' + text_ + '}'; }

private:
    std::string text_;
};

/// Only Kodo has profiles.
bool hasProfile(const RunOptions& options) {
    return !options.engine.starts_with("box2d");
}

void addSettings(JsonObject& json, const Result& result) {
    const StepOptions& step = result.options.step;
    json.add("scene", result.options.scene);
    json.add("engine", result.options.engine);
    json.add("profile", hasProfile(result.options) ? std::optional(step.profile.value_or(kBalanced))
                                                   : std::nullopt);
    json.add("size", result.size);
    json.add("seed", static_cast<std::size_t>(result.options.seed));
    json.add("threads", step.threads);
    json.add("substeps", step.substeps);
    json.add("passes", step.passes);
    json.add("positionPasses", step.positionPasses);
    json.add("set", fmt::format("{}", fmt::join(step.set, ",")));
    json.add("leaveOut", fmt::format("{}", fmt::join(step.leaveOut, ",")));
    json.add("continuous", step.continuous);
    json.add("bodies", result.bodies);
    json.add("locked", result.locked);
    json.add("steps", result.steps);
}

std::string stagesAsJson(const Result& result) {
    JsonObject json;
    for (const StageTime& stage : result.stages) {
        json.add(stage.name.c_str(), 1e3 * stage.seconds / result.steps);
    }
    return json.text();
}

/// Without stages of the engine, the whole step is one stage.
Result withStages(Result result) {
    if (result.stages.empty()) {
        result.stages.push_back({"step", result.cpuSeconds});
    }
    return result;
}

/// The engine and its settings.
std::string wayOf(const RunOptions& options) {
    return options.engine +
           (hasProfile(options) ? ' ' + options.step.profile.value_or(kBalanced) : "");
}

/// What is measured of the state after the last step, without what has no meaning in the scene.
std::string stateAsText(const Result& result) {
    std::string text = "\n  at the end: ";
    if (result.depths.pairs > 0) {
        text += fmt::format("{} overlaps, largest {:.1f} mm, mean {:.1f} mm; ", result.depths.pairs,
                            1e3 * result.depths.max, 1e3 * result.depths.mean);
    }
    text += fmt::format("kinetic energy {:.2g} J", result.kineticEnergy);
    if (result.escaped) {
        text += fmt::format("; {} of {} bodies outside", *result.escaped, result.bodies);
    }
    if (result.stands) {
        text +=
            fmt::format("\n  {} of {} bodies have kept their places; the farthest moved {:.3f} m "
                        "sideways and {:.3f} m down",
                        result.displacement.stood, result.bodies, result.displacement.sideways,
                        result.displacement.down);
    }
    if (result.error) {
        const bool share = result.errorUnit.empty();
        text += fmt::format("\n  {}: {:.4g} {}", result.errorName,
                            (share ? 100 : 1) * *result.error, share ? "%" : result.errorUnit);
    }
    return text;
}

} // namespace

Summary summaryOf(std::vector<Result> results) {
    std::sort(results.begin(), results.end(), [](const Result& one, const Result& other) {
        return one.cpuSeconds < other.cpuSeconds;
    });
    for (const Result& result : results) {
        if (result.stateHash != results.front().stateHash) {
            throw NotRepeatable(fmt::format("{} in {}: two runs end in different states",
                                            result.options.scene, result.options.engine));
        }
    }
    Summary summary;
    summary.result = results[results.size() / 2];
    summary.runs = static_cast<int>(results.size());
    const double median = summary.result.cpuSeconds;
    summary.spread = (results.back().cpuSeconds - results.front().cpuSeconds) / median;
    return summary;
}

std::string asJson(const Summary& summary, bool stages) {
    const Result& result = summary.result;
    JsonObject json;
    addSettings(json, result);
    json.add("cpuMsPerStep", result.cpuMsPerStep());
    json.add("nsPerBodyStep", result.nsPerBodyStep());
    json.add("wallMsPerStep", result.wallMsPerStep());
    json.add("worstStepMs",
             result.worstSeconds ? std::optional(1e3 * *result.worstSeconds) : std::nullopt);
    json.add("runs", summary.runs);
    json.add("spread", summary.spread);
    if (!summary.against.empty()) {
        json.add("against", summary.against);
        json.add("ratio", summary.ratio);
    }
    json.add("overlaps", result.depths.pairs);
    json.add("depthMaxMm", 1e3 * result.depths.max);
    json.add("depthMeanMm", 1e3 * result.depths.mean);
    json.add("depthPeakMm",
             result.maxOverlap ? std::optional(1e3 * *result.maxOverlap) : std::nullopt);
    json.add("escaped", result.escaped);
    json.add("stood", result.displacement.stood);
    json.add("driftSidewaysM", result.displacement.sideways);
    json.add("driftDownM", result.displacement.down);
    json.add("kineticEnergyJ", result.kineticEnergy);
    json.add("massKg", result.mass);
    json.add("errorName", result.errorName);
    json.add("errorUnit", result.errorUnit);
    json.add("error", result.error);
    json.add("pairWorkNsPerStep", result.pairWorkPerStep);
    json.add("bytesPerBody", result.bytesPerBody > 0 ? std::optional(result.bytesPerBody)
                                                     : std::nullopt); // see heapBytes()
    const auto contact = result.contactBytes;
    json.add("bytesPerContact", contact ? std::optional(contact->all) : std::nullopt);
    json.add("bytesPerContactRow", contact ? std::optional(contact->row) : std::nullopt);
    json.add("snapshotMs",
             result.snapshot ? std::optional(1e3 * result.snapshot->seconds) : std::nullopt);
    json.add("snapshotBytes",
             result.snapshot ? std::optional(result.snapshot->bytes) : std::nullopt);
    json.add("copyMs", result.copy ? std::optional(1e3 * result.copy->seconds) : std::nullopt);
    json.add("copyBytes", result.copy ? std::optional(result.copy->bytes) : std::nullopt);
    json.add("allocationsPerStep", result.options.engine.starts_with("box2d")
                                       ? std::nullopt // its allocations bypass operator new
                                       : std::optional(result.allocationsPerStep));
    json.add("stateHash", fmt::format("{:016x}", result.stateHash));
    if (stages) {
        json.raw("stagesMsPerStep", stagesAsJson(withStages(result)));
    }
    return json.text();
}

std::string asText(const Summary& summary, bool stages) {
    const Result& result = summary.result;
    const RunOptions& options = result.options;
    std::string text = fmt::format("{} {}, {}: {:.4g} ms a step", options.scene, result.size,
                                   wayOf(options), result.cpuMsPerStep());
    if (result.bodies > 0) {
        text += fmt::format(", {:.4g} ns a body and step", result.nsPerBodyStep());
    }
    if (options.step.threads > 1) { // the other times cover only the calling thread
        text += fmt::format("; {:.4g} ms on the wall", result.wallMsPerStep());
    }
    if (result.worstSeconds) {
        text += fmt::format("; longest step {:.4g} ms", 1e3 * *result.worstSeconds);
    }
    if (summary.runs > 1) {
        text += fmt::format(" (median of {}, spread {:.1f} %)", summary.runs, 100 * summary.spread);
    }
    if (!summary.against.empty()) {
        text += fmt::format(", {:.3f} of the time of {}", summary.ratio, summary.against);
    }
    text += stateAsText(result);
    if (result.bytesPerBody > 0) {
        text += fmt::format("\n  {:.0f} bytes a body, with its share of all", result.bytesPerBody);
    }
    if (result.contactBytes) {
        text += fmt::format("\n  {} bytes a contact, {} of them its row in the solver",
                            result.contactBytes->all, result.contactBytes->row);
    }
    if (result.snapshot) {
        text += fmt::format("\n  snapshot {:.4g} ms, {} bytes", 1e3 * result.snapshot->seconds,
                            result.snapshot->bytes);
    }
    if (result.copy) {
        text += fmt::format("\n  copy {:.4g} ms, {} bytes of the heap", 1e3 * result.copy->seconds,
                            result.copy->bytes);
    }
    if (stages) {
        for (const StageTime& stage : withStages(result).stages) {
            text +=
                fmt::format("\n  {:<12} {:.4g} ms", stage.name, 1e3 * stage.seconds / result.steps);
        }
    }
    return text;
}

} // namespace bench
