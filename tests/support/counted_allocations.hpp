// SPDX-License-Identifier: Apache-2.0
//
// Replaces operator new of the whole program by one that counts. For one source of a program.
#pragma once
#include <cstddef>
#include <cstdlib>
#include <new>

namespace keikan::test {

/// How often memory was asked for since the program began. Of one thread.
inline std::size_t allocations = 0;

inline void* counted_memory(std::size_t size) {
    ++allocations;
    return std::malloc(size == 0 ? 1 : size);
}

}  // namespace keikan::test

void* operator new(std::size_t size) {
    if (void* const memory = keikan::test::counted_memory(size)) return memory;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {  // std::stable_sort's buffer
    return keikan::test::counted_memory(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
    std::free(memory);
}
