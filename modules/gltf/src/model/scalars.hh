#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "whittle/core/attribute.hh"
#include "whittle/core/bytes/little_endian.hh"

namespace whittle::gltf {

std::size_t size_of(ScalarType type);
bool is_integer(ScalarType type);
bool is_signed(ScalarType type);
/// The largest value of an integer type.
double largest_of(ScalarType type);

/// The type of `componentType`; empty for other numbers. Beyond glTF 2.0: 5124 and 5130.
std::optional<ScalarType> scalar_type(std::size_t component_type);
std::size_t component_type(ScalarType type);

/// \param is_normalized whether integers stand for [0, 1] or [-1, 1]
double load_real(const char* bytes, ScalarType type, bool is_normalized);
/// An integer. Negative ones become larger than any count.
std::size_t load_whole(const char* bytes, ScalarType type);
/// Rounds to the nearest that the type has. \throw std::range_error for a real number beyond 32 bits
void append_real(std::string& bytes, double value, ScalarType type, bool is_normalized);

/// The elements of an accessor.
struct ElementShape {
  std::size_t n_rows = 1;     ///< of a column
  std::size_t n_columns = 1;  ///< of a matrix; 1 for scalars and vectors

  std::size_t n_components() const { return n_rows * n_columns; }
  /// Columns of matrices begin at multiples of 4 bytes.
  std::size_t column_stride(ScalarType type) const;
  /// Bytes from one element to the next, if nothing else is between them.
  std::size_t packed_stride(ScalarType type) const;
  /// Bytes of an element, without padding after the last component.
  std::size_t n_bytes(ScalarType type) const;

  friend bool operator==(const ElementShape&, const ElementShape&) = default;
};

/// The shape by a type's name: "VEC3".
std::optional<ElementShape> element_shape(const std::string& name);
std::string name_of(const ElementShape& shape);

}  // namespace whittle::gltf
