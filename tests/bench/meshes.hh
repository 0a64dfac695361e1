#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::bench {

/// A mesh to decimate. It is made or read when it is needed.
struct Case {
  std::string name;
  std::function<IndexedMesh()> make;
};

/// The meshes the benchmark makes by itself. Each name ends with the number of faces:
///   sphere-70k, sphere-1394k   noisy, round, closed; the two show how time grows with the number of faces
///   loop-346k, loop-1384k      a mesh after one and two steps of Loop subdivision, with noise
///   cube-307k                  flat sides, so nearly all costs are equal to 0
///   terrain-349k               open, rough at every scale
/// \param base mesh file of about 86,000 faces to subdivide; none: a knot
std::vector<Case> made_cases(const std::optional<std::filesystem::path>& base);

/// Reads files as the program does: exact duplicates on open borders are welded.
Case file_case(const std::filesystem::path& path);

/// Vertices and faces of the same mesh in random order.
Case permuted(const Case& original, std::uint64_t seed);

}  // namespace whittle::bench
