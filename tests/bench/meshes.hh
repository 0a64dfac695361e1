#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::bench {

/// A mesh to decimate, made or read when it is needed.
struct Case {
  std::string name;
  std::function<IndexedMesh()> make;
};

/// The meshes the benchmark makes by itself; each name ends with the number of faces:
///   sphere-70k, sphere-1394k   noisy, round, closed; the two make the growth with the number of faces
///   loop-346k, loop-1384k      a mesh after one and two steps of Loop subdivision, with noise
///   cube-307k                  flat sides, so that nearly all costs are tied at 0
///   terrain-349k               open, rough at every scale
/// \param base mesh file of about 86,000 faces to subdivide; none: a knot
std::vector<Case> made_cases(const std::optional<std::filesystem::path>& base);

/// As files are read by the program: exact duplicates on open borders welded.
Case file_case(const std::filesystem::path& path);

/// Vertices and faces of the same mesh in random order.
Case permuted(const Case& original, std::uint64_t seed);

}  // namespace whittle::bench
