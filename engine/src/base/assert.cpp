// SPDX-License-Identifier: MIT
#include "base/assert.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

void printFailure(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: kodo: assertion failed: %s\n", file, line, condition);
}

std::atomic<AssertHandler> currentHandler{&printFailure};

} // namespace

AssertHandler setAssertHandler(AssertHandler handler) {
    return currentHandler.exchange(handler != nullptr ? handler : &printFailure);
}

void assertionFailed(const char* condition, const char* file, int line) {
    currentHandler.load()(condition, file, line);
    std::abort();
}

} // namespace KODO_PRECISION
} // namespace kodo
