#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::test {

/// One result to be the same everywhere.
struct Case {
  std::string name;  ///< without blanks
  std::function<IndexedMesh()> result;
};

/// \param data the folder data/ of the project
std::vector<Case> cases(const std::filesystem::path& data);

}  // namespace whittle::test
