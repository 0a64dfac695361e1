// Replaces the program's operators new and delete. They have a file of their own, so that GCC inlines neither. With
// only one inlined it warns of a mismatch.
#include "fuzz/largest_allocation.hh"

#include <cstdlib>
#include <new>

namespace whittle::test {

std::atomic<std::size_t> largest_allocation = 0;

}  // namespace whittle::test

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  using whittle::test::largest_allocation;
  std::size_t largest = largest_allocation;
  while (size > largest && !largest_allocation.compare_exchange_weak(largest, size)) {
  }
  return std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
  if (void* const memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
