// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/large_pages.h"

#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace sightline::detail {

namespace {
constexpr std::size_t page = std::size_t{1} << 21;
}  // namespace

bool takes_large_pages(std::size_t bytes) { return bytes >= page; }

void* allocate_large_pages(std::size_t bytes) {
    const std::size_t whole = (bytes + page - 1) / page * page;
    void* const memory = whole < bytes ? nullptr : std::aligned_alloc(page, whole);
    if (!memory) throw std::bad_alloc();
#if defined(MADV_HUGEPAGE)
    madvise(memory, whole, MADV_HUGEPAGE);  // where the system has none, the usual ones do
#endif
    return memory;
}

void free_large_pages(void* memory) { std::free(memory); }

}  // namespace sightline::detail
