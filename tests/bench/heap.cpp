// SPDX-License-Identifier: MIT
#include "heap.hpp"

#include <atomic>
#include <cstdlib>
#include <malloc.h>
#include <new>

namespace {

std::atomic<std::uint64_t> allocations{0};
std::atomic<std::size_t> live{0}; // bytes

void* counted(void* memory) {
    allocations.fetch_add(1, std::memory_order_relaxed);
    live.fetch_add(malloc_usable_size(memory), std::memory_order_relaxed);
    return memory;
}

void* allocate(std::size_t size) {
    return counted(std::malloc(size == 0 ? 1 : size));
}

void* allocate(std::size_t size, std::align_val_t alignment) {
    const auto unit = static_cast<std::size_t>(alignment); // aligned_alloc requires a multiple of
                                                           // the alignment
    return counted(std::aligned_alloc(unit, (size + unit - 1) / unit * unit));
}

void release(void* memory) {
    live.fetch_sub(malloc_usable_size(memory), std::memory_order_relaxed);
    std::free(memory);
}

void* orThrow(void* memory) {
    return memory != nullptr ? memory : throw std::bad_alloc();
}

} // namespace

// The array forms call these.
void* operator new(std::size_t size) {
    return orThrow(allocate(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return orThrow(allocate(size, alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    return allocate(size, alignment);
}
void operator delete(void* memory) noexcept {
    release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    release(memory);
}

namespace bench {

std::uint64_t allocationCount() {
    return allocations.load(std::memory_order_relaxed);
}

std::size_t liveBytes() {
    return live.load(std::memory_order_relaxed);
}

std::size_t heapBytes() {
#ifdef __GLIBC__
    const struct mallinfo2 now = mallinfo2();
    return now.uordblks + now.hblkhd;
#else
    return 0;
#endif
}

} // namespace bench
