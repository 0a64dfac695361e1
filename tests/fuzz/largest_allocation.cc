// Replaces the program's operators new and delete. They have a file of their own, so that GCC inlines neither. With
// only one inlined it warns of a mismatch.
#include "fuzz/largest_allocation.hh"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace whittle::test {

std::size_t largest_allocation = 0;

}  // namespace whittle::test

void* operator new(std::size_t size) {
  using whittle::test::largest_allocation;
  largest_allocation = std::max(largest_allocation, size);
  if (void* const memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
