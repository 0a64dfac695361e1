#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace whittle {

/// Meaning of an attribute's numbers. It decides how values are blended and compared.
enum class AttributeKind : std::uint8_t {
  texcoord,       ///< Two or three coordinates in a texture.
  normal,         ///< A direction of unit length.
  tangent,        ///< A direction of unit length, and ±1: the side of the bitangent. The latter is never blended.
  color,          ///< Each component in [0, 1].
  joint_weights,  ///< Numbers of k joints, then the k weights of these. Weights are not negative; their sum is 1.
  displacement,   ///< A vector that a morph target adds to a position.
  direction,      ///< A vector that a morph target adds to a normal or a tangent.
  scalar,         ///< Any real numbers.
  category        ///< Identifiers. Never blended: one of the values survives.
};

/// How a file stores a number.
enum class ScalarType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Calls `function` with a value of the type.
template <class Function>
decltype(auto) with_scalar_type(ScalarType type, const Function& function) {
  switch (type) {
    case ScalarType::int8:
      return function(std::int8_t{});
    case ScalarType::uint8:
      return function(std::uint8_t{});
    case ScalarType::int16:
      return function(std::int16_t{});
    case ScalarType::uint16:
      return function(std::uint16_t{});
    case ScalarType::int32:
      return function(std::int32_t{});
    case ScalarType::uint32:
      return function(std::uint32_t{});
    case ScalarType::float32:
      return function(float{});
    case ScalarType::float64:
      break;
  }
  return function(double{});
}

/// A named attribute, with one value per wedge, or per face, of a mesh.
struct Attribute {
  std::string name{};  ///< from the file: "TEXCOORD_0", "quality"
  AttributeKind kind = AttributeKind::scalar;
  std::size_t n_components = 1;  ///< At least 1.
  std::vector<double> values{};  ///< `n_components` per wedge or face, in turn.
  ScalarType type = ScalarType::float32;
  bool is_normalized = false;  ///< Whether a file stores integers that stand for [0, 1] or [-1, 1]; `values` are reals.

  Attribute without_values() const { return {name, kind, n_components, {}, type, is_normalized}; }
  std::size_t size() const { return values.size() / n_components; }
  std::span<const double> value(std::size_t i) const { return {values.data() + i * n_components, n_components}; }
  std::span<double> value(std::size_t i) { return {values.data() + i * n_components, n_components}; }
};

}  // namespace whittle
