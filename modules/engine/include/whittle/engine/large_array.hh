#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace whittle {

/// Asks for huge pages for large arrays: looked at in random order, most looks at small pages miss the address caches.
template <class T>
struct LargeAllocator {
  using value_type = T;
  static constexpr std::size_t huge_page = std::size_t{1} << 21;

  LargeAllocator() = default;
  template <class U>
  LargeAllocator(const LargeAllocator<U>&) {}

  T* allocate(std::size_t n) {
    if (n > (~std::size_t{0} - huge_page) / sizeof(T)) throw std::bad_array_new_length();
    const bool is_large = n * sizeof(T) >= huge_page;
    const std::size_t alignment = is_large ? huge_page : 64;
    const std::size_t size = (n * sizeof(T) + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, size);
    if (!memory) throw std::bad_alloc();
#ifdef __linux__
    if (is_large) madvise(memory, n * sizeof(T) / huge_page * huge_page, MADV_HUGEPAGE);  // no matter if it fails
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  /// Elements not given a value are left without one.
  template <class U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Args>
  void construct(U* place, Args&&... args) {
    ::new (static_cast<void*>(place)) U(std::forward<Args>(args)...);
  }

  template <class U>
  bool operator==(const LargeAllocator<U>&) const {
    return true;
  }
};

/// A vector for large arrays; `resize` leaves new elements of plain types undefined.
template <class T>
using LargeArray = std::vector<T, LargeAllocator<T>>;

}  // namespace whittle
