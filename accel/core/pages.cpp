#include "accel/core/pages.h"

#include <cstdlib>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

constexpr std::size_t huge_page = std::size_t(2) << 20;
constexpr std::size_t cache_line = 64;

}  // namespace

void* allocate_pages(std::size_t bytes, PageUse use) {
    const bool huge = use != PageUse::sparse && bytes >= huge_page;
    const std::size_t alignment = huge ? huge_page : cache_line;
    const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
    if (rounded < bytes) throw std::bad_alloc();
    void* pages = std::aligned_alloc(alignment, rounded == 0 ? alignment : rounded);
    if (pages == nullptr) throw std::bad_alloc();
#if defined(__linux__)
    // A wish, not a need: without huge pages everything works, only slower.
    const std::size_t filled = (bytes + huge_page / 2) / huge_page * huge_page;
    if (huge) madvise(pages, use == PageUse::passing ? filled : rounded, MADV_HUGEPAGE);
#endif
    return pages;
}

void free_pages(void* pages) noexcept { std::free(pages); }

}  // namespace rayshoot::inline RAYSHOOT_ISA
