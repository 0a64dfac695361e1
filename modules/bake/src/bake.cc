#include "whittle/bake/bake.hh"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fill_outwards.hh"
#include "look.hh"
#include "texels.hh"
#include "unwrapped_mesh.hh"
#include "whittle/bake/unwrap.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/render/srgb.hh"

namespace whittle::bake {

namespace {

constexpr std::size_t largest_default_size = 4096;

void check_size(std::size_t size) {
  if (size < least_texture_size || size > largest_texture_size || !std::has_single_bit(size)) {
    throw std::invalid_argument("a texture size of " + std::to_string(size) + " is no power of two from " +
                                std::to_string(least_texture_size) + " to " + std::to_string(largest_texture_size));
  }
}

/// The power of two next to the size that has a number of texels on a mesh.
std::size_t size_for(double texels, double fill) {
  const double least = least_texture_size;
  const double size = std::clamp(std::sqrt(texels / fill), least, double{largest_default_size});
  const std::size_t below = std::bit_floor(static_cast<std::size_t>(size));
  return size * size > 2 * static_cast<double>(below * below) ? 2 * below : below;
}

/// About one sample for each of `texels`.
std::size_t texel_samples(double texels, double fill, std::size_t size) {
  constexpr double most = 4;
  const double covered = fill * static_cast<double>(size * size);
  return static_cast<std::size_t>(std::clamp(std::round(std::sqrt(texels / covered)), 1.0, most));
}

struct Layout {
  std::size_t size;
  Unwrapping unwrapping;
};

Layout layout_of(const IndexedMesh& coarse, const std::optional<std::size_t>& size, double texels) {
  if (size) return {*size, unwrap(coarse, *size)};
  const std::size_t fitting = size_for(texels, unwrap(coarse, largest_default_size).fill);
  return {fitting, unwrap(coarse, fitting)};
}

render::Rgb encoded_light(const Texel& texel) {
  render::Rgb color{};
  for (std::size_t k = 0; k < 3; ++k) {
    const float light = texel.light[static_cast<Eigen::Index>(k)] / static_cast<float>(texel.n_samples);
    color[k] = static_cast<float>(render::srgb8_of_linear(light)) / 255;
  }
  return color;
}

render::Rgb encoded_normal(const Texel& texel) {
  const Eigen::Vector3f normal = texel.normal.normalized();
  return {0.5F * normal.x() + 0.5F, 0.5F * normal.y() + 0.5F, 0.5F * normal.z() + 0.5F};
}

/// An image of texels, also where there are no samples.
template <class Encode>
render::Picture image_of(const std::vector<Texel>& texels, std::size_t size, const Encode& encode) {
  render::Picture picture{size, size, std::vector<render::Rgb>(texels.size()), {}};
  std::vector<std::uint8_t> is_set(texels.size());
  for (std::size_t i = 0; i < texels.size(); ++i) {
    is_set[i] = texels[i].n_samples > 0 ? 1 : 0;
    if (is_set[i] != 0) picture.pixels[i] = encode(texels[i]);
  }
  fill_outwards(std::move(is_set), picture);
  return picture;
}

}  // namespace

Baked bake(const render::Scene& detailed, const IndexedMesh& coarse, const BakeOptions& options) {
  if (options.texture_size) check_size(*options.texture_size);
  if (!(options.reach_rel > 0)) throw std::invalid_argument("the reach is not above 0");
  detail::ProgressMeter meter(options.progress);
  meter.start("laying out", 0.1);
  const Look look(detailed, options.reach_rel);
  const double texels = look.texels();
  const auto [size, layout] = layout_of(coarse, options.texture_size, texels);
  Baked baked;
  baked.mesh = unwrapped_mesh(coarse, layout, options.makes_normal_map);
  baked.n_charts = layout.right.size();
  meter.start("looking up", 0.9);
  const ImageGrid grid{size, texel_samples(texels, layout.fill, size)};
  const Texels found = look_up_texels(look, baked.mesh, grid, {options.threads, &meter});
  baked.n_samples = found.n_samples;
  baked.n_missed = found.n_missed;
  meter.start("filling", 1);
  baked.base_color = image_of(found.texels, size, encoded_light);
  if (options.makes_normal_map) baked.normal_map = image_of(found.texels, size, encoded_normal);
  meter.finish();
  return baked;
}

}  // namespace whittle::bake
