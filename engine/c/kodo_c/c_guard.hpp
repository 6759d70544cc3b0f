// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world.hpp>

#include <cstring>
#include <kodo.h>
#include <string>
#include <utility>

namespace kodo_c {

/// Stores the sentence of the exception that is being handled, and returns its status.
kodo_Status storeError() noexcept;

/// Runs the body of a call of the C interface. No exception leaves it.
template <typename Call>
kodo_Status guarded(Call&& call) noexcept {
    try {
        std::forward<Call>(call)();
        return KODO_OK;
    } catch (...) {
        return storeError();
    }
}

/// Throws BadDefinition.
[[noreturn]] void refuse(const std::string& field, const std::string& reason);
/// Throws std::logic_error for a null pointer.
void requirePointer(const void* pointer, const char* name);
/// Throws std::logic_error unless a struct was initialised by the header of this library.
void requireHead(const kodo_Head& head, std::size_t size, const char* type);
/// Throws BadDefinition unless 0 <= kind < count.
void requireKind(std::int32_t kind, std::int32_t count, const char* field);

template <typename Pointer>
Pointer& required(Pointer* pointer, const char* name) {
    requirePointer(pointer, name);
    return *pointer;
}

/// A definition of the caller; null is refused.
template <typename Definition>
const Definition& checked(const Definition* definition, const char* name, const char* type) {
    requireHead(required(definition, name).head, sizeof(Definition), type);
    return *definition;
}

/// Begins the initialisation of a definition: zeroes it and records the head.
template <typename Definition>
void initialise(Definition* definition, kodo_Head head, const char* type) {
    requirePointer(definition, type);
    if (head.size >= sizeof(head)) { // of another size: the memory of the caller has that one
        std::memset(static_cast<void*>(definition), 0, head.size);
        definition->head = head;
    }
    requireHead(head, sizeof(Definition), type);
}

} // namespace kodo_c
