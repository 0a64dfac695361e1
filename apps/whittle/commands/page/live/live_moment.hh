#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "whittle/core/indexed_mesh.hh"

// What a page shows of a run while it goes on.

namespace whittle::app {

/// A mesh as such pages show it: a rough level of one that is large.
struct LiveMesh {
  std::string name;
  IndexedMesh mesh;
  std::size_t n_faces = 0;  ///< of all of it
};

/// \pre `has_page()` \throw std::invalid_argument as `bounds_of`
LiveMesh live_mesh(const IndexedMesh& mesh);

/// A moment of a run.
struct LiveMoment {
  const LiveMesh& input;
  const LiveMesh& now;
  std::string title;
  std::string target;
  std::string stage;
  double fraction = 0;        ///< of the stage, [0, 1]
  std::uint64_t n_faces = 0;  ///< that are left
  double seconds = 0;         ///< since the run began
  std::string problem;        ///< why it has ended; empty while it goes on
};

/// The page, as an HTML file. \pre `has_page()`
std::string page_of(const LiveMoment& moment);

}  // namespace whittle::app
