// Memory of large arrays that are read here and there, in large pages where the system has them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace sightline {

namespace detail {
/// At least as large as one large page.
bool takes_large_pages(std::size_t bytes);
void* allocate_large_pages(std::size_t bytes);  ///< throws std::bad_alloc
void free_large_pages(void* memory);
}  // namespace detail

/// Of std::vector. A traversal that touches a line of every page waits longer for addresses than for memory.
template <typename T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <typename Other>
    LargePages(const LargePages<Other>&) {}

    T* allocate(std::size_t count) {
        if (!detail::takes_large_pages(count * sizeof(T))) return std::allocator<T>().allocate(count);
        return static_cast<T*>(detail::allocate_large_pages(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t count) {
        if (detail::takes_large_pages(count * sizeof(T)))
            detail::free_large_pages(memory);
        else
            std::allocator<T>().deallocate(memory, count);
    }
    bool operator==(const LargePages&) const { return true; }
};

template <typename T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace sightline
