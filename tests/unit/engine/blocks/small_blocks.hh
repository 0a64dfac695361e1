#pragma once

#include "decimate/run.hh"

namespace whittle::test {

/// Two levels, of blocks so small that most vertices are shared or next to shared ones.
inline constexpr BlockPlan small_blocks{.fewest_faces = 1,
                                        .fewest_faces_in_detail = 1,
                                        .fewest_faces_again = 1,
                                        .faces_per_block = 100,
                                        .fewest_faces_left = 2,
                                        .fewest_faces_left_before_rounds = 2,
                                        .fewest_faces_in_exact_order = 1,
                                        .fewest_faces_again_in_exact_order = 1,
                                        .faces_per_block_in_exact_order = {400, 300},
                                        .least_done_in_exact_order = 0};
inline constexpr BlockPlan no_blocks{.fewest_faces = ~std::size_t{0}, .fewest_faces_in_exact_order = ~std::size_t{0}};

inline DecimateOptions memoryless(unsigned threads = 1) {
  DecimateOptions options;
  options.cost = Cost::memoryless;
  options.threads = threads;
  return options;
}

inline DecimateOptions plain_quadrics(unsigned threads) {
  DecimateOptions options;
  options.cost = Cost::quadric;
  options.threads = threads;
  return options;
}

}  // namespace whittle::test
