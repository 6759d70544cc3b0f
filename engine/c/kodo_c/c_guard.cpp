// SPDX-License-Identifier: MIT
#include <kodo/error.hpp>
#include <kodo/version.hpp>
#include <kodo_c/c_guard.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

namespace kodo_c {
namespace {

// Of fixed size, so that it holds a sentence when memory has run out.
thread_local std::array<char, 1024> errorText{};

kodo_Status store(kodo_Status status, std::string_view text) {
    const std::size_t size = std::min(text.size(), errorText.size() - 1);
    std::copy_n(text.data(), size, errorText.data());
    errorText[size] = '\0';
    return status;
}

std::string sizeText(std::size_t bytes, std::uint32_t version) {
    return std::to_string(bytes) + " bytes in version " + std::to_string(version);
}

} // namespace

kodo_Status storeError() noexcept {
    try {
        throw;
    } catch (const kodo::BadDefinition& error) {
        return store(KODO_BAD_DEFINITION, error.what());
    } catch (const kodo::BadBodyId& error) {
        return store(KODO_BAD_ID, error.what());
    } catch (const kodo::BadSnapshot& error) {
        return store(KODO_BAD_SNAPSHOT, error.what());
    } catch (const std::logic_error& error) {
        return store(KODO_WRONG_USE, error.what());
    } catch (const std::bad_alloc&) {
        return store(KODO_NO_MEMORY, "there is not enough memory");
    } catch (const std::exception& error) {
        return store(KODO_OTHER_ERROR, error.what());
    } catch (...) {
        return store(KODO_OTHER_ERROR, "an exception that is no std::exception");
    }
}

void refuse(const std::string& field, const std::string& reason) {
    throw kodo::BadDefinition({field, reason});
}

void requirePointer(const void* pointer, const char* name) {
    if (pointer == nullptr) {
        throw std::logic_error(std::string(name) + ": must not be null");
    }
}

void requireHead(const kodo_Head& head, std::size_t size, const char* type) {
    if (head.size == size && head.version == KODO_C_VERSION && head.realSize == sizeof(kodo_Real)) {
        return;
    }
    const std::string name(type);
    if (head.version == 0) {
        throw std::logic_error(name + ": is not initialised; the function named after it, as "
                                      "kodo_bodyDef() for kodo_BodyDef, makes one");
    }
    if (head.realSize != sizeof(kodo_Real)) {
        throw std::logic_error(name + (sizeof(kodo_Real) == 4
                                           ? ": comes from a program with KODO_DOUBLE, but this "
                                             "library computes in float"
                                           : ": comes from a program without KODO_DOUBLE, but this "
                                             "library computes in double"));
    }
    throw std::logic_error(name + ": has " + sizeText(head.size, head.version) +
                           ", but this library expects " + sizeText(size, KODO_C_VERSION) +
                           "; compile the program with the kodo.h of the library");
}

void requireKind(std::int32_t kind, std::int32_t count, const char* field) {
    if (kind < 0 || kind >= count) {
        refuse(field, "must be from 0 to " + std::to_string(count - 1) + ", but is " +
                          std::to_string(kind));
    }
}

} // namespace kodo_c

const char* kodo_errorText() {
    return kodo_c::errorText.data();
}

uint32_t kodo_version() {
    return KODO_VERSION;
}

uint32_t kodo_realSize() {
    return sizeof(kodo_Real);
}
