#include "encode/grid.hh"

#include <algorithm>
#include <cmath>

#include "whittle/core/geometry/box.hh"

namespace whittle::gltf {
namespace {

constexpr int grid_bits = 16;
constexpr double largest_integer = 65535;
constexpr double largest_offset = 32767;
/// Smaller meshes have no grid.
constexpr double least_extent = 0x1p-80;

/// Whole numbers up to here are exact, and so are sums of two.
constexpr double largest_whole = 0x1p52;

/// Whether coordinates up to `farthest` are at most `largest` steps.
bool is_in_reach(double farthest, double largest, int exponent) {
  return exponent <= 100 && farthest < std::ldexp(largest, exponent);
}

/// The largest number of a morph target of positions.
double largest_offset_of(const IndexedMesh& mesh) {
  double largest = 0;
  for (const Attribute& attribute : mesh.attributes) {
    if (!attribute.name.starts_with("target ") || !attribute.name.ends_with(" POSITION")) continue;
    for (const double value : attribute.values) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

/// Coordinates in steps.
Vec3 in_steps(const Vec3& point, int exponent) {
  return {std::round(std::ldexp(point.x(), -exponent)), std::round(std::ldexp(point.y(), -exponent)),
          std::round(std::ldexp(point.z(), -exponent))};
}

}  // namespace

double Grid::step() const { return std::ldexp(1.0, exponent); }

std::optional<Grid> grid_of(const IndexedMesh& triangles) {
  if (triangles.positions.empty()) return {};
  const Box box = bounds_of(triangles.positions);
  const double extent = box.sizes().maxCoeff();
  const double farthest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (!(extent > least_extent)) return {};
  const int exponent = std::ilogb(extent) - grid_bits;
  if (!is_in_reach(farthest, largest_mantissa, exponent)) return {};
  return Grid{exponent, {}};
}

std::optional<Grid> integer_grid_of(std::span<const IndexedMesh* const> meshes) {
  Box box;
  double offset = 0;
  for (const IndexedMesh* const mesh : meshes) {
    for (const Vec3& p : mesh->positions) box.extend(p);
    offset = std::max(offset, largest_offset_of(*mesh));
  }
  if (box.isEmpty() || !(box.sizes().maxCoeff() > least_extent)) return {};
  int exponent = std::ilogb(box.sizes().maxCoeff()) - grid_bits;
  const auto fits = [&] {
    return (in_steps(box.max(), exponent) - in_steps(box.min(), exponent)).maxCoeff() <= largest_integer &&
           std::ldexp(offset, -exponent) <= largest_offset;
  };
  while (!fits()) ++exponent;
  const double farthest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (!is_in_reach(farthest, largest_whole, exponent)) return {};
  return Grid{exponent, in_steps(box.min(), exponent) * std::ldexp(1.0, exponent)};
}

}  // namespace whittle::gltf
