#pragma once

#include <string>
#include <vector>

#include "program/program.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::test {

/// A run that must succeed: its report and its result.
struct Simplified {
  Outcome outcome;
  nlohmann::json report;
  IndexedMesh mesh;
};

/// \param more targets and options
Simplified simplify(const std::string& input, const std::vector<std::string>& more);

}  // namespace whittle::test
