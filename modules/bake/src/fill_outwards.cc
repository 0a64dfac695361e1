#include "fill_outwards.hh"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace whittle::bake {

namespace {

/// Calls `use(neighbour)` for the up to eight pixels around one.
template <class Use>
void for_each_around(const render::Picture& picture, std::size_t pixel, const Use& use) {
  const std::size_t x = pixel % picture.width;
  const std::size_t y = pixel / picture.width;
  for (std::size_t row = y > 0 ? y - 1 : y; row <= std::min(y + 1, picture.height - 1); ++row) {
    for (std::size_t column = x > 0 ? x - 1 : x; column <= std::min(x + 1, picture.width - 1); ++column) {
      const std::size_t other = row * picture.width + column;
      if (other != pixel) use(other);
    }
  }
}

render::Rgb mean_around(const render::Picture& picture, const std::vector<std::uint8_t>& is_set, std::size_t pixel) {
  render::Rgb sum{};
  float n = 0;
  for_each_around(picture, pixel, [&](std::size_t other) {
    if (is_set[other] != 1) return;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += picture.pixels[other][i];
    ++n;
  });
  for (float& value : sum) value /= n;
  return sum;
}

}  // namespace

void fill_outwards(std::vector<std::uint8_t> is_set, render::Picture& picture) {
  constexpr std::uint8_t is_next = 2;
  std::vector<std::size_t> ring;
  const auto add_unset_around = [&](std::size_t pixel, std::vector<std::size_t>& list) {
    for_each_around(picture, pixel, [&](std::size_t other) {
      if (is_set[other] != 0) return;
      is_set[other] = is_next;
      list.push_back(other);
    });
  };
  for (std::size_t pixel = 0; pixel < is_set.size(); ++pixel) {
    if (is_set[pixel] == 1) add_unset_around(pixel, ring);
  }
  while (!ring.empty()) {
    for (const std::size_t pixel : ring) picture.pixels[pixel] = mean_around(picture, is_set, pixel);
    for (const std::size_t pixel : ring) is_set[pixel] = 1;
    std::vector<std::size_t> next;
    for (const std::size_t pixel : ring) add_unset_around(pixel, next);
    ring = std::move(next);
  }
}

}  // namespace whittle::bake
