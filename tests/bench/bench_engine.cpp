// SPDX-License-Identifier: MIT
#include "bench_engine.hpp"

#include <algorithm>

namespace bench {

const std::vector<std::string>& engineNames() {
    static const std::vector<std::string> kNames{"kodo", "kodo64", "box2d", "box2d3"};
    return kNames;
}

std::vector<std::string> builtEngines() {
    std::vector<std::string> names = engineNames();
    if (!hasBox2d3()) {
        names.pop_back();
    }
    return names;
}

const std::vector<std::string>& profileNames() {
    static const std::vector<std::string> kNames{kBalanced, "fast", "accurate", "thesis2006"};
    return kNames;
}

const std::vector<std::string>& featureNames() {
    static const std::vector<std::string> kNames{"friction", "rolling", "restitution", "continuous",
                                                 "records",  "sleep",   "rotation",    "collision"};
    return kNames;
}

const std::vector<std::string>& continuousModeNames() {
    static const std::vector<std::string> kNames{"never", "static", "all"};
    return kNames;
}

namespace {

/// Throws WrongUse for two values of one number.
void refuseRepeated(const std::vector<std::string>& set) {
    std::vector<std::string> names;
    for (const std::string& text : set) {
        const std::string name = text.substr(0, text.find('='));
        if (std::find(names.begin(), names.end(), name) != names.end()) {
            throw WrongUse("--set: " + name + " is set twice");
        }
        names.push_back(name);
    }
}

} // namespace

std::unique_ptr<Engine> makeEngine(const std::string& name, const scenes::SceneDef& scene,
                                   const StepOptions& options) {
    refuseRepeated(options.set);
    if (name == "kodo") {
        return f32::makeKodo(scene, options);
    }
    if (name == "kodo64") {
        return f64::makeKodo(scene, options);
    }
    if (name == "box2d") {
        return makeBox2d(scene, options);
    }
    if (name == "box2d3") {
        return makeBox2d3(scene, options);
    }
    throw WrongUse("there is no engine '" + name + "': it is kodo, kodo64, box2d or box2d3");
}

} // namespace bench
