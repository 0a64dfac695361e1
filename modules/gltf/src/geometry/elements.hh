#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "model/model.hh"

namespace whittle::gltf {

/// The values of an accessor, or of an attribute that Draco has decoded.
class Elements {
 public:
  explicit Elements(const Accessor& accessor);

  std::size_t size() const { return accessor_.count; }
  ScalarType type() const { return accessor_.type; }
  const ElementShape& shape() const { return accessor_.shape; }

  /// Reads the first components of a value, up to the size of `components`.
  void read(std::size_t i, std::span<double> components) const;
  /// The first component as a whole number. \pre of an integer type
  std::size_t whole(std::size_t i) const;

 private:
  /// Null where the value is zero.
  const char* bytes_of(std::size_t i) const;

  Accessor accessor_;
  std::vector<std::pair<std::size_t, std::size_t>> replaced_;  // ascending; numbers into the sparse values
};

}  // namespace whittle::gltf
