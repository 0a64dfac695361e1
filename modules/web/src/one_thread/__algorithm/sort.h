// Stands in front of libc++'s <__algorithm/sort.h>, whose sort takes 3 kB for each type that is sorted, 150 kB in all.
// Its only change: a short sort is declared before the long one, and is chosen as it has a constraint. Keys that are
// sorted are unique (docs/dev/machines.md), so results are the same.
#pragma once

#include <__config>
#include <__iterator/iterator_traits.h>
#include <__utility/move.h>
#include <__utility/swap.h>

_LIBCPP_BEGIN_NAMESPACE_STD

template <class Iterator, class Less>
void whittle_sift(Iterator first, long root, long n, Less less) {
  for (long child = 2 * root + 1; child < n; child = 2 * root + 1) {
    if (child + 1 < n && less(first[child], first[child + 1])) ++child;
    if (!less(first[root], first[child])) return;
    swap(first[root], first[child]);
    root = child;
  }
}

template <class Iterator, class Less>
[[gnu::noinline]] void whittle_sort(Iterator first, long n, Less less, long depth) {
  constexpr long few = 12;
  for (; n > few && depth > 0; --depth) {  // quicksort, by the median of three
    const Iterator middle = first + n / 2;
    if (less(*middle, *first)) swap(*middle, *first);
    if (less(first[n - 1], *middle)) swap(first[n - 1], *middle);
    if (less(*middle, *first)) swap(*middle, *first);
    auto pivot = *middle;
    long i = 0;
    long j = n - 1;
    do {
      while (less(first[i], pivot)) ++i;
      while (less(pivot, first[j])) --j;
      if (i <= j) swap(first[i++], first[j--]);
    } while (i <= j);
    std::whittle_sort<Iterator, Less>(first, j + 1, less, depth - 1);
    first += i;
    n -= i;
  }
  if (n > few) {  // heapsort, where the medians were bad
    for (long i = n / 2; i-- > 0;) std::whittle_sift<Iterator, Less>(first, i, n, less);
    for (long i = n; i-- > 1;) {
      swap(first[0], first[i]);
      std::whittle_sift<Iterator, Less>(first, 0, i, less);
    }
    return;
  }
  for (long i = 1; i < n; ++i) {  // insertion
    auto value = std::move(first[i]);
    long j = i;
    for (; j > 0 && less(value, first[j - 1]); --j) first[j] = std::move(first[j - 1]);
    first[j] = std::move(value);
  }
}

template <class _AlgPolicy, class _Compare, class _RandomAccessIterator, bool _UseBitSetPartition>
  requires true
void __introsort(_RandomAccessIterator first, _RandomAccessIterator last, _Compare less,
                 typename iterator_traits<_RandomAccessIterator>::difference_type depth, bool /*leftmost*/ = true) {
  std::whittle_sort<_RandomAccessIterator, _Compare>(first, static_cast<long>(last - first), less,
                                                     static_cast<long>(depth));
}

_LIBCPP_END_NAMESPACE_STD

#include_next <__algorithm/sort.h>
