#include "model/scalars.hh"

#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace whittle::gltf {
namespace {

constexpr std::pair<std::size_t, ScalarType> component_types[] = {
    {5120, ScalarType::int8},  {5121, ScalarType::uint8},  {5122, ScalarType::int16},   {5123, ScalarType::uint16},
    {5124, ScalarType::int32}, {5125, ScalarType::uint32}, {5126, ScalarType::float32}, {5130, ScalarType::float64}};

const std::pair<const char*, ElementShape> shapes[] = {{"SCALAR", {1, 1}}, {"VEC2", {2, 1}}, {"VEC3", {3, 1}},
                                                       {"VEC4", {4, 1}},   {"MAT2", {2, 2}}, {"MAT3", {3, 3}},
                                                       {"MAT4", {4, 4}}};

float rounded_to_float(double value) {
  const auto rounded = static_cast<float>(value);
  if (!std::isfinite(rounded)) throw std::range_error("a number is too large for 32 bits");
  return rounded;
}

}  // namespace

std::size_t size_of(ScalarType type) {
  return with_scalar_type(type, [](auto scalar) { return sizeof scalar; });
}

bool is_integer(ScalarType type) { return type != ScalarType::float32 && type != ScalarType::float64; }

bool is_signed(ScalarType type) {
  return with_scalar_type(type, [](auto scalar) { return std::is_signed_v<decltype(scalar)>; });
}

double largest_of(ScalarType type) {
  return with_scalar_type(
      type, [](auto scalar) { return static_cast<double>(std::numeric_limits<decltype(scalar)>::max()); });
}

std::optional<ScalarType> scalar_type(std::size_t component_type) {
  for (const auto& [number, type] : component_types) {
    if (number == component_type) return type;
  }
  return {};
}

std::size_t component_type(ScalarType type) {
  return std::find_if(std::begin(component_types), std::end(component_types),
                      [&](const auto& row) { return row.second == type; })
      ->first;
}

double load_real(const char* bytes, ScalarType type, bool is_normalized) {
  const double value = with_scalar_type(
      type, [&](auto scalar) { return static_cast<double>(load_little_endian<decltype(scalar)>(bytes)); });
  if (!is_normalized || !is_integer(type)) return value;
  return std::max(value / largest_of(type), -1.0);
}

std::size_t load_whole(const char* bytes, ScalarType type) {
  switch (type) {
    case ScalarType::uint8:
      return load_little_endian<std::uint8_t>(bytes);
    case ScalarType::uint16:
      return load_little_endian<std::uint16_t>(bytes);
    case ScalarType::uint32:
      return load_little_endian<std::uint32_t>(bytes);
    default:
      return static_cast<std::size_t>(static_cast<std::int64_t>(load_real(bytes, type, false)));
  }
}

void append_real(std::string& bytes, double value, ScalarType type, bool is_normalized) {
  with_scalar_type(type, [&](auto scalar) {
    using Scalar = decltype(scalar);
    if constexpr (std::is_same_v<Scalar, float>) {
      append_little_endian(bytes, rounded_to_float(value));
    } else if constexpr (std::is_same_v<Scalar, double>) {
      append_little_endian(bytes, value);
    } else {
      using Limits = std::numeric_limits<Scalar>;
      const double scaled = is_normalized ? value * static_cast<double>(Limits::max()) : value;
      const double low =
          is_normalized && Limits::is_signed ? -static_cast<double>(Limits::max()) : static_cast<double>(Limits::min());
      const double rounded = std::isnan(scaled) ? 0 : std::round(scaled);
      append_little_endian(bytes, static_cast<Scalar>(std::clamp(rounded, low, static_cast<double>(Limits::max()))));
    }
  });
}

std::size_t ElementShape::column_stride(ScalarType type) const {
  const std::size_t packed = n_rows * size_of(type);
  return n_columns == 1 ? packed : (packed + 3) / 4 * 4;
}

std::size_t ElementShape::packed_stride(ScalarType type) const { return n_columns * column_stride(type); }

std::size_t ElementShape::n_bytes(ScalarType type) const {
  return (n_columns - 1) * column_stride(type) + n_rows * size_of(type);
}

std::optional<ElementShape> element_shape(const std::string& name) {
  for (const auto& [text, shape] : shapes) {
    if (name == text) return shape;
  }
  return {};
}

std::string name_of(const ElementShape& shape) {
  return std::find_if(std::begin(shapes), std::end(shapes), [&](const auto& row) { return row.second == shape; })
      ->first;
}

}  // namespace whittle::gltf
