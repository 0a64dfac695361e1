#include "encode/encode.hh"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace whittle::gltf {
namespace {

/// Exponent of compressed texture coordinates, and of morph targets of directions.
constexpr int fine_exponent = -16;

struct StoredType {
  ScalarType type = ScalarType::float32;
  bool is_normalized = false;
};

/// The attribute of a channel, also where it is a morph target's: "POSITION".
std::string_view attribute_name(std::string_view channel) {
  const std::size_t space = channel.rfind(' ');
  return channel.starts_with("target ") && space != std::string_view::npos ? channel.substr(space + 1) : channel;
}

bool is_of_target(const Channel& channel) { return attribute_name(channel.name) != channel.name; }

bool all_within(const std::vector<double>& values, double low, double high) {
  return std::all_of(values.begin(), values.end(), [&](double x) { return x >= low && x <= high; });
}

/// The type that an accessor has, or a larger one where its integers don't reach as far as the values.
StoredType documented_type(const Accessor& documented, const std::vector<double>& values) {
  const StoredType same{documented.type, documented.is_normalized};
  if (!is_integer(documented.type)) return same;
  if (same.is_normalized) return all_within(values, is_signed(same.type) ? -1 : 0, 1) ? same : StoredType{};
  const double largest = largest_of(same.type);
  if (all_within(values, is_signed(same.type) ? -largest - 1 : 0, largest)) return same;
  return all_within(values, 0, 65535) ? StoredType{ScalarType::uint16} : StoredType{};
}

/// The input's type, if glTF allows it without KHR_mesh_quantization.
StoredType stored_type(const Channel& channel, const Accessor& documented, const std::vector<double>& values) {
  const std::string_view name = attribute_name(channel.name);
  if (name == "POSITION" || name == "NORMAL" || name == "TANGENT") return {};
  const bool is_unsigned = documented.is_normalized && !is_signed(documented.type);
  if (name.starts_with("TEXCOORD_") && !is_of_target(channel) && !is_unsigned) return {};
  if (name.starts_with("COLOR_") && documented.is_normalized && !is_of_target(channel)) {
    return {documented.type, true};  // values beyond the range are clamped
  }
  return documented_type(documented, values);
}

std::optional<int> exponent_for(const Channel& channel, const Packing& packing) {
  const std::string_view name = attribute_name(channel.name);
  if (name == "POSITION") {
    if (packing.grid) return packing.grid->exponent;
    return {};
  }
  const bool is_fine =
      name.starts_with("TEXCOORD_") || (is_of_target(channel) && (name == "NORMAL" || name == "TANGENT"));
  return is_fine ? std::optional(fine_exponent) : std::nullopt;
}

void pad(std::string& bytes, std::size_t size) { bytes.append(size - bytes.size(), '\0'); }

/// Element by element, each beginning at a multiple of 4 bytes.
void append_values(Encoded& to, const std::vector<double>& values) {
  const std::size_t n = to.shape.n_components();
  to.stride = (to.shape.packed_stride(to.type) + 3) / 4 * 4;
  to.bytes.reserve(to.count * to.stride);
  for (std::size_t i = 0; i < to.count; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      if (k % to.shape.n_rows == 0) {
        pad(to.bytes, i * to.stride + k / to.shape.n_rows * to.shape.column_stride(to.type));
      }
      append_real(to.bytes, values[i * n + k], to.type, to.is_normalized);
    }
    pad(to.bytes, (i + 1) * to.stride);
  }
}

/// Values as whole multiples of a power of two, in the form of the exponential filter: 8 bits exponent, 24 bits number.
/// \return whether they all fit. `values` become the values read back.
bool append_on_grid(Encoded& to, std::vector<double>& values, int exponent) {
  const double step = std::ldexp(1.0, exponent);
  if (!all_within(values, -largest_mantissa * step, largest_mantissa * step)) return false;
  to.filter = MeshoptFilter::exponential;
  to.stride = 4 * to.shape.n_components();
  to.bytes.reserve(to.count * to.stride);
  for (double& value : values) {
    const auto number = static_cast<std::int32_t>(std::round(value / step));
    const auto bits = static_cast<std::uint32_t>(exponent) << 24U | (static_cast<std::uint32_t>(number) & 0xFFFFFFU);
    append_little_endian(to.bytes, bits);
    value = number * step;
  }
  return true;
}

/// Unit vectors as 8 bits a component, in the form of the octahedral filter; a fourth component is kept.
void append_directions(Encoded& to, const std::vector<double>& values) {
  const std::size_t n = to.shape.n_components();
  std::vector<float> vectors;
  for (std::size_t i = 0; i < to.count; ++i) {
    for (std::size_t k = 0; k < 4; ++k) vectors.push_back(k < n ? static_cast<float>(values[i * n + k]) : 0.F);
  }
  to.type = ScalarType::int8;
  to.is_normalized = true;
  to.filter = MeshoptFilter::octahedral;
  to.stride = 4;
  to.bytes = encode_octahedral(vectors);
}

/// Positions as whole numbers of steps from the grid's origin; those of morph targets are differences.
void append_integers(Encoded& to, const Channel& channel, std::vector<double>& values, const Grid& grid) {
  const bool is_difference = is_of_target(channel);
  to.type = is_difference ? ScalarType::int16 : ScalarType::uint16;
  const Vec3 origin = is_difference ? Vec3::Zero() : *grid.origin;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = std::round(std::ldexp(values[i], -grid.exponent)) -
                std::ldexp(origin[static_cast<Eigen::Index>(i % 3)], -grid.exponent);
  }
  append_values(to, values);
}

bool is_direction(const Channel& channel, const ElementShape& shape) {
  return (channel.name == "NORMAL" && shape == ElementShape{3, 1}) ||
         (channel.name == "TANGENT" && shape == ElementShape{4, 1});
}

/// The smallest integers that hold values in [-1, 1] or [0, 1] well enough; none if they stay as they are.
std::optional<StoredType> packed_type(const Channel& channel, const StoredType& stored,
                                      const std::vector<double>& values, const Packing& packing) {
  const std::string_view name = attribute_name(channel.name);
  if (is_of_target(channel)) {
    const bool fits = packing.quantizes && (name == "NORMAL" || name == "TANGENT") && all_within(values, -1, 1);
    return fits ? std::optional(StoredType{ScalarType::int8, true}) : std::nullopt;
  }
  if (name.starts_with("COLOR_") && packing.quantizes) {
    const bool fits = stored.type != ScalarType::float32 || all_within(values, 0, 1);
    return fits ? std::optional(StoredType{ScalarType::uint8, true}) : std::nullopt;
  }
  if (stored.type != ScalarType::float32 || !(name.starts_with("COLOR_") || name.starts_with("TEXCOORD_"))) return {};
  if (all_within(values, 0, 1)) return StoredType{ScalarType::uint16, true};
  return packing.quantizes && name.starts_with("TEXCOORD_") && all_within(values, -1, 1)
             ? std::optional(StoredType{ScalarType::int16, true})
             : std::nullopt;
}

/// \param values become the values read back, of positions
void append_packed(Encoded& to, const Channel& channel, std::vector<double>& values, const Packing& packing) {
  const bool is_integer_position =
      packing.grid && packing.grid->origin && attribute_name(channel.name) == "POSITION" && to.shape.n_rows == 3;
  if (is_integer_position) return append_integers(to, channel, values, *packing.grid);
  if (is_direction(channel, to.shape)) {
    if (packing.compresses) return append_directions(to, values);
    to.type = ScalarType::int8;
    to.is_normalized = true;
  } else if (const auto type = packed_type(channel, {to.type, to.is_normalized}, values, packing)) {
    to.type = type->type;
    to.is_normalized = type->is_normalized;
  } else if (packing.compresses && to.type == ScalarType::float32) {
    const std::optional<int> exponent = exponent_for(channel, packing);
    if (exponent && append_on_grid(to, values, *exponent)) return;
  }
  append_values(to, values);
}

/// The range of the values, rounded to 32 bits.
void find_range(Encoded& of, const std::vector<double>& values) {
  const std::size_t n = of.shape.n_components();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = static_cast<float>(values[i]);
    if (i < n) {
      of.low.push_back(value);
      of.high.push_back(value);
    }
    of.low[i % n] = std::min(of.low[i % n], value);
    of.high[i % n] = std::max(of.high[i % n], value);
  }
}

}  // namespace

Encoded encode_channel(const Channel& channel, const Accessor& documented, const std::vector<double>& values,
                       const Packing& packing) {
  Encoded encoded;
  const StoredType stored = stored_type(channel, documented, values);
  encoded.type = stored.type;
  encoded.is_normalized = stored.is_normalized;
  encoded.shape = documented.shape;
  encoded.count = values.size() / documented.shape.n_components();
  std::vector<double> read_back = values;
  if (packing.compresses || packing.quantizes) {
    append_packed(encoded, channel, read_back, packing);
  } else {
    append_values(encoded, values);
  }
  if (attribute_name(channel.name) == "POSITION") find_range(encoded, read_back);
  return encoded;
}

Encoded encode_indices(const std::vector<Triangle>& faces, std::size_t n_vertices, const Accessor* documented,
                       const Packing& packing) {
  // The largest number of each type is left out: it means that a strip begins anew.
  Encoded encoded;
  encoded.type = n_vertices <= 65535 ? ScalarType::uint16 : ScalarType::uint32;
  if (documented && documented->type == ScalarType::uint8 && n_vertices <= 255 && !packing.compresses) {
    encoded.type = ScalarType::uint8;
  }
  encoded.mode = MeshoptMode::triangles;
  encoded.count = 3 * faces.size();
  encoded.stride = size_of(encoded.type);
  encoded.bytes.reserve(encoded.count * encoded.stride);
  for (const Triangle& face : faces) {
    for (const Index v : face) append_real(encoded.bytes, v, encoded.type, false);
  }
  return encoded;
}

}  // namespace whittle::gltf
