#pragma once

#include "accel/core/isa.h"

#include <cstddef>
#include <new>
#include <vector>

/// Memory for the large arrays that rays jump about in.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Rays jump about in a `dense` array; a `passing` one is freed before they come; of a `sparse` one
/// much is never touched.
enum class PageUse : unsigned char { dense, passing, sparse };

/// Bytes aligned for the largest use; from 2 MiB upward on huge pages where the system grants them,
/// which spares most of the address translations. No huge pages for sparse arrays, nor for the end
/// of a passing one where that would be less than half full. Throws std::bad_alloc.
void* allocate_pages(std::size_t bytes, PageUse use = PageUse::dense);
void free_pages(void* pages) noexcept;

template <class T>
struct PageAllocator {
    using value_type = T;

    PageAllocator() = default;
    template <class U>
    PageAllocator(const PageAllocator<U>&) {}

    T* allocate(std::size_t n) {
        if (n > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
        return static_cast<T*>(allocate_pages(n * sizeof(T)));
    }
    void deallocate(T* pages, std::size_t) noexcept { free_pages(pages); }
    bool operator==(const PageAllocator&) const = default;
};

template <class T>
using PagedVector = std::vector<T, PageAllocator<T>>;

}  // namespace rayshoot::inline RAYSHOOT_ISA
