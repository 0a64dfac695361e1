#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/attribute.hh"

namespace whittle::io {

using PlyType = ScalarType;

constexpr std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      return 8;
  }
  return 0;
}

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type{};  ///< Type of the length, if the property is a list.
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string_view> remarks;  ///< The lines of comments and `obj_info`, as they stand.
  std::size_t data_start = 0;             ///< Byte after the header.
};

/// \throw ReadError if the header is incomplete or invalid, or has more vertices or faces than a mesh can hold.
PlyHeader read_ply_header(std::string_view bytes, std::string_view name);

}  // namespace whittle::io
