#include "pictures/meshes/scales.hh"

#include <initializer_list>
#include <utility>

namespace whittle::app {
namespace {

ColorScale scale_of(std::initializer_list<std::uint32_t> numbers, std::vector<std::string> names = {}) {
  ColorScale scale{{}, std::move(names)};
  scale.colors.reserve(numbers.size());
  for (const std::uint32_t number : numbers) scale.colors.push_back(rgb_of(number));
  return scale;
}

}  // namespace

const ColorScale& error_scale() {
  static const ColorScale scale =
      scale_of({0x48186A, 0x424086, 0x33638D, 0x26828E, 0x1FA088, 0x3FBC73, 0x84D44B, 0xD8E219});
  return scale;
}

const ColorScale& shape_scale() {
  static const ColorScale scale =
      scale_of({0x012B65, 0x26426E, 0x51586E, 0x727071, 0x8C8877, 0xA9A177, 0xCEBD68, 0xF3DA4F});
  return scale;
}

const ColorScale& valence_scale() {
  static const ColorScale scale = scale_of({0x2D004B, 0x7259A0, 0xBEBADA, 0x969696, 0xFCC57F, 0xD07513, 0x7F3B08},
                                           {"3 or less", "4", "5", "6", "7", "8", "9 or more"});
  return scale;
}

}  // namespace whittle::app
