#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace whittle {

inline constexpr std::size_t huge_page = std::size_t{1} << 21;

/// Asks for huge pages for memory that isn't filled yet. That may fail: the memory is valid all the same.
inline void prefer_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t size) {
#ifdef __linux__
  const std::size_t before = (huge_page - reinterpret_cast<std::uintptr_t>(memory) % huge_page) % huge_page;
  if (size < before + huge_page) return;
  madvise(static_cast<char*>(memory) + before, (size - before) / huge_page * huge_page, MADV_HUGEPAGE);
#endif
}

/// `vector.reserve(n)` with huge pages, for vectors whose type is given. Small pages take the system longer than a loop
/// that fills them.
template <class T>
void reserve_large(std::vector<T>& vector, std::size_t n) {
  if (n <= vector.capacity()) return;
  vector.reserve(n);
  prefer_huge_pages(vector.data() + vector.size(), (vector.capacity() - vector.size()) * sizeof(T));
}

/// `vector.resize(n, value...)` with huge pages.
template <class T, class... Value>
void resize_large(std::vector<T>& vector, std::size_t n, const Value&... value) {
  reserve_large(vector, n);
  vector.resize(n, value...);
}

/// Asks for huge pages for large arrays. With small pages, most accesses in random order miss the address caches.
template <class T>
struct LargeAllocator {
  using value_type = T;

  LargeAllocator() = default;
  template <class U>
  LargeAllocator(const LargeAllocator<U>&) {}

  T* allocate(std::size_t n) {
    if (n > (~std::size_t{0} - huge_page) / sizeof(T)) throw std::bad_array_new_length();
#ifdef __linux__
    if (is_large(n)) return static_cast<T*>(map(n * sizeof(T)));
#endif
    return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{64}));
  }
  void deallocate(T* memory, [[maybe_unused]] std::size_t n) {
#ifdef __linux__
    if (is_large(n)) {
      munmap(memory, n * sizeof(T));
      return;
    }
#endif
    ::operator delete (memory, std::align_val_t{64});
  }

  /// Elements without a given value stay uninitialised.
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

 private:
#ifdef __linux__
  static bool is_large(std::size_t n) { return n * sizeof(T) >= 2 * huge_page; }

  /// Maps pages that are not shared with other memory, so that freeing them returns them. They begin at a huge page.
  static void* map(std::size_t size) {
    const std::size_t reserved = size + huge_page;
    void* begin = mmap(nullptr, reserved, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (begin == MAP_FAILED) throw std::bad_alloc();
    auto* const bytes = static_cast<char*>(begin);
    const std::size_t before = (huge_page - reinterpret_cast<std::uintptr_t>(begin) % huge_page) % huge_page;
    if (before > 0) munmap(bytes, before);
    const std::size_t page = 4096;
    const std::size_t end = before + (size + page - 1) / page * page;
    if (end < reserved) munmap(bytes + end, reserved - end);
    prefer_huge_pages(bytes + before, size);
    return bytes + before;
  }
#endif
};

/// A vector for large arrays; `resize` leaves new elements of plain types undefined.
template <class T>
using LargeArray = std::vector<T, LargeAllocator<T>>;

}  // namespace whittle
