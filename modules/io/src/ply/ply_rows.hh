#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "ply/ply_header.hh"
#include "whittle/core/bytes/little_endian.hh"

namespace whittle::io {

/// Rows of binary data that all have their numbers at the same places.
struct PlyRows {
  const char* first;
  std::size_t size;  ///< bytes of a row
  std::endian order;

  PlyRows from(std::size_t row) const { return {first + row * size, size, order}; }
};

/// Calls `use(row, number)` for the number of each row at a place. \param place bytes from the beginning of a row
template <class Use>
void for_each_number(const PlyRows& rows, std::size_t n_rows, std::size_t place, PlyType type, const Use& use) {
  const auto read = [&]<class Number>(Number) {
    const char* at = rows.first + place;
    for (std::size_t row = 0; row < n_rows; ++row, at += rows.size) use(row, load<Number>(at, rows.order));
  };
  switch (type) {
    case PlyType::int8:
      return read(std::int8_t{});
    case PlyType::uint8:
      return read(std::uint8_t{});
    case PlyType::int16:
      return read(std::int16_t{});
    case PlyType::uint16:
      return read(std::uint16_t{});
    case PlyType::int32:
      return read(std::int32_t{});
    case PlyType::uint32:
      return read(std::uint32_t{});
    case PlyType::float32:
      return read(float{});
    case PlyType::float64:
      return read(double{});
  }
}

/// Whether the number of each row at a place is the same one.
inline bool all_are(std::int64_t number, const PlyRows& rows, std::size_t n_rows, std::size_t place, PlyType type) {
  bool are = true;
  for_each_number(rows, n_rows, place, type,
                  [&](std::size_t, auto of_row) { are &= static_cast<double>(of_row) == static_cast<double>(number); });
  return are;
}

}  // namespace whittle::io
