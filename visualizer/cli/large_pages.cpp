#include "visualizer/cli/large_pages.hpp"

#include <cstdint>
#include <cstdlib>
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

namespace rayscope::cli {

// The allocator grows its heap by so much at once: addresses, which cost nothing until they are touched. What does not fit
// there comes in small pages, as it would without this; so do blocks above the largest that glibc can be told to take from
// the heap, which have a mapping of their own and give it back.
void use_large_pages() {
    constexpr int heap = 1 << 28, page = 1 << 21, largest_block = 1 << 25, more_than_at_start = 1 << 20;
    const auto end = [] { return reinterpret_cast<std::uintptr_t>(sbrk(0)); };
    const std::uintptr_t before = end();
    mallopt(M_TOP_PAD, heap);
    mallopt(M_TRIM_THRESHOLD, 2 * heap);
    mallopt(M_MMAP_THRESHOLD, largest_block);
    void* volatile grown = std::malloc(more_than_at_start); // NOLINT: makes the heap grow now
    std::free(grown);                                       // NOLINT
    const std::uintptr_t first = (before + page - 1) / page * page;
    if (end() > first) madvise(reinterpret_cast<void*>(first), end() - first, MADV_HUGEPAGE); // NOLINT
}

} // namespace rayscope::cli
