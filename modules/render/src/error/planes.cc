#include "error/planes.hh"

#include <algorithm>

namespace whittle::render {

namespace {

/// to += weight · from, for n numbers.
void add(float weight, const float* from, std::size_t n, float* to) {
  for (std::size_t i = 0; i < n; ++i) to[i] += weight * from[i];
}

Plane filter_rows(const Plane& plane, const Kernel& kernel) {
  const std::size_t r = kernel.size() / 2;
  Plane result(plane.width, plane.height);
  std::vector<float> padded(plane.width + 2 * r);
  for (std::size_t y = 0; y < plane.height; ++y) {
    const float* const row = &plane.values[y * plane.width];
    std::fill_n(padded.begin(), r, row[0]);
    std::copy_n(row, plane.width, padded.begin() + static_cast<std::ptrdiff_t>(r));
    std::fill(padded.end() - static_cast<std::ptrdiff_t>(r), padded.end(), row[plane.width - 1]);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      add(kernel[k], padded.data() + k, plane.width, &result.values[y * plane.width]);
    }
  }
  return result;
}

Plane filter_columns(const Plane& plane, const Kernel& kernel) {
  const std::size_t r = kernel.size() / 2;
  Plane result(plane.width, plane.height);
  for (std::size_t y = 0; y < plane.height; ++y) {
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const std::size_t from = std::min(y + k < r ? 0 : y + k - r, plane.height - 1);
      add(kernel[k], &plane.values[from * plane.width], plane.width, &result.values[y * plane.width]);
    }
  }
  return result;
}

}  // namespace

Plane filtered(const Plane& plane, const Kernel& along_rows, const Kernel& along_columns) {
  return filter_columns(filter_rows(plane, along_rows), along_columns);
}

}  // namespace whittle::render
