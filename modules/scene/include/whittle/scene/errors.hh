#pragma once

#include <stdexcept>
#include <string>

namespace whittle {

/// A mesh was read, but the request isn't supported for it. `what()` names the file.
class UnsupportedMesh : public std::runtime_error {
 public:
  explicit UnsupportedMesh(const std::string& problem) : std::runtime_error(problem) {}
};

}  // namespace whittle
