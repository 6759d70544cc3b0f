// SPDX-License-Identifier: MIT
// Runs a fuzz target on files, or on all files of folders, with any compiler. With --seconds N it
// then changes these inputs at random. The last input is in fuzz_last_input when one ends the
// program.
#include <support/random_numbers.hpp>

#include <fuzz/fuzz.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

using Bytes = std::string;

void run(const Bytes& bytes) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

std::vector<std::filesystem::path> filesIn(const char* path) {
    if (!std::filesystem::is_directory(path)) {
        return {path};
    }
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
        if (entry.is_regular_file()) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// One input with some bytes replaced, inserted, removed, doubled, or taken from another input.
Bytes changed(support::RandomNumbers& random, Bytes bytes, const Bytes& other) {
    for (std::size_t changes = 1 + random.below(8); changes > 0; --changes) {
        const std::size_t place = random.below(bytes.size() + 1);
        const std::size_t length =
            std::min<std::size_t>(1 + random.below(16), bytes.size() - place);
        switch (random.below(5)) {
        case 0:
            bytes.replace(place, length, length, static_cast<char>(random.below(256)));
            break;
        case 1:
            bytes.insert(place, 1, static_cast<char>(random.below(256)));
            break;
        case 2:
            bytes.erase(place, length);
            break;
        case 3:
            bytes.insert(place, bytes.substr(place, length));
            break;
        default:
            bytes.insert(place, other.substr(random.below(other.size() + 1), 1 + random.below(64)));
            break;
        }
    }
    return bytes;
}

void runChanges(const std::vector<Bytes>& inputs, int seconds) {
    const auto start = std::chrono::steady_clock::now();
    support::RandomNumbers random(static_cast<std::uint64_t>(start.time_since_epoch().count()));
    unsigned long long count = 0;
    while (std::chrono::steady_clock::now() - start < std::chrono::seconds(seconds)) {
        const Bytes& other = inputs[random.below(inputs.size())];
        const Bytes input = changed(random, inputs[random.below(inputs.size())], other);
        std::ofstream("fuzz_last_input", std::ios::binary) << input;
        run(input);
        ++count;
    }
    std::printf("%llu changed inputs\n", count);
}

} // namespace

int main(int argc, char** argv) {
    int seconds = 0;
    std::vector<Bytes> inputs;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--seconds") == 0 && i + 1 < argc) {
            seconds = std::atoi(argv[++i]);
            continue;
        }
        for (const std::filesystem::path& path : filesIn(argv[i])) {
            std::printf("%s\n", path.c_str());
            std::fflush(stdout);
            std::ifstream file(path, std::ios::binary);
            inputs.emplace_back(std::istreambuf_iterator<char>(file),
                                std::istreambuf_iterator<char>());
            run(inputs.back());
        }
    }
    std::printf("%zu inputs\n", inputs.size());
    if (seconds > 0 && !inputs.empty()) {
        runChanges(inputs, seconds);
    }
    return inputs.empty() ? 1 : 0;
}
