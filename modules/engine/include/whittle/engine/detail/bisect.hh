#pragma once

#include <algorithm>
#include <cstddef>

namespace whittle::detail {

/// A number from `least` on that holds, and that is followed, before `most`, by one that doesn't: `most` counts as one.
/// If those that hold come before all others, it is the last of them.
/// \param gap `gap()` is how many numbers after it may be left undecided, at least 1; asked after each try
/// \param holds `holds(number)`; `least` is known to hold
template <class Gap, class Holds>
std::size_t bisect(std::size_t least, std::size_t most, const Gap& gap, const Holds& holds) {
  while (most - least > gap()) {
    const std::size_t middle = least + (most - least) / 2;
    (holds(middle) ? least : most) = middle;
  }
  return least;
}

/// The same for numbers below `end`, the last of which are likely to hold: it begins there, in steps that grow.
/// \param holds 0 is known to hold
template <class Gap, class Holds>
std::size_t bisect_from_end(std::size_t end, const Gap& gap, const Holds& holds) {
  std::size_t most = end;
  std::size_t least = end - 1;
  for (std::size_t step = gap(); least > 0 && !holds(least); step *= 2) {
    most = least;
    least -= std::min(least, step);
  }
  return bisect(least, most, gap, holds);
}

}  // namespace whittle::detail
