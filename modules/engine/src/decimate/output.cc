#include "decimate/output.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "whittle/core/geometry/vertex_normals.hh"

namespace whittle {
namespace {

/// Where each input vertex went, as a vertex of the complex; `invalid_index` for those without a face.
std::vector<Index> representatives(TriangleComplex& complex) {
  std::vector<Index> result(complex.n_vertex_slots(), invalid_index);
  for (Index v = 0; v < complex.n_vertex_slots(); ++v) {
    const Index r = complex.representative(v);
    if (complex.has_faces(r)) result[complex.origin(v)] = r;
  }
  return result;
}

Triangle mapped(const Triangle& face, const std::vector<Index>& vertex_map) {
  return {vertex_map[face[0]], vertex_map[face[1]], vertex_map[face[2]]};
}

/// Numbers of the input's faces whose corners are still three vertices. \param vertex_map to the complex
std::vector<Index> surviving_faces(std::span<const Triangle> faces, const std::vector<Index>& vertex_map,
                                   std::size_t n_surviving) {
  std::vector<Index> result;
  result.reserve(n_surviving);
  for (Index f = 0; f < faces.size(); ++f) {
    if (has_three_corners(mapped(faces[f], vertex_map))) result.push_back(f);
  }
  return result;
}

/// Drops from `faces` those that the complex no longer has. Of several coincident ones the first are kept.
void leave_out_coincident(std::vector<Index>& faces, std::span<const Triangle> input,
                          const std::vector<Index>& vertex_map, TriangleComplex& complex) {
  const std::vector<Triangle> live = complex.live_faces();
  std::vector<bool> is_found(live.size());
  std::erase_if(faces, [&](Index f) {
    Triangle face = mapped(input[f], vertex_map);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    const auto [begin, end] = std::equal_range(live.begin(), live.end(), face);
    for (auto it = begin; it != end; ++it) {
      const auto slot = static_cast<std::size_t>(it - live.begin());
      if (is_found[slot]) continue;
      is_found[slot] = true;
      return false;
    }
    return true;
  });
}

/// The sum of an attribute over the vertices merged into each vertex of the result, and their number.
template <std::size_t N>
struct MergedSum {
  MergedSum(const std::vector<std::array<float, N>>& values, const std::vector<Index>& vertex_map,
            std::size_t n_vertices)
      : sums(n_vertices), counts(n_vertices) {
    for (std::size_t v = 0; v < vertex_map.size(); ++v) {
      if (vertex_map[v] == invalid_index) continue;
      for (std::size_t i = 0; i < N; ++i) sums[vertex_map[v]][i] += values[v][i];
      ++counts[vertex_map[v]];
    }
  }

  std::vector<std::array<double, N>> sums;
  std::vector<std::size_t> counts;
};

/// The mean colour of the vertices merged into each vertex of the result.
std::vector<Color> merged_colors(const IndexedMesh& input, const std::vector<Index>& vertex_map,
                                 std::size_t n_vertices) {
  const MergedSum<4> merged(input.colors, vertex_map, n_vertices);
  std::vector<Color> colors(n_vertices);
  for (std::size_t v = 0; v < n_vertices; ++v) {
    for (std::size_t channel = 0; channel < 4; ++channel) {
      colors[v][channel] = static_cast<float>(merged.sums[v][channel] / static_cast<double>(merged.counts[v]));
    }
  }
  return colors;
}

/// The mean direction of the normals merged into each vertex of `mesh`, the result. Where they cancel out it is that of
/// the faces of `mesh`.
std::vector<std::array<float, 3>> merged_normals(const IndexedMesh& input, const std::vector<Index>& vertex_map,
                                                 const IndexedMesh& mesh, const Frame& frame) {
  constexpr double least_mean = 1e-3;  // below that the mean of unit vectors has no direction to speak of
  const MergedSum<3> merged(input.normals, vertex_map, mesh.positions.size());
  std::vector<std::array<float, 3>> normals = vertex_normals(mesh, frame);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const auto& sum = merged.sums[v];
    const double length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    const bool is_alone = merged.counts[v] == 1;  // then it keeps every bit
    if (!is_alone && !(length >= least_mean * static_cast<double>(merged.counts[v]))) continue;
    for (std::size_t i = 0; i < 3; ++i) normals[v][i] = static_cast<float>(is_alone ? sum[i] : sum[i] / length);
  }
  return normals;
}

std::vector<std::array<float, 3>> output_normals(const IndexedMesh& input, const std::vector<Index>& vertex_map,
                                                 const IndexedMesh& mesh, const Frame& frame, Normals normals) {
  if (input.normals.empty() || normals == Normals::drop) return {};
  return normals == Normals::keep ? merged_normals(input, vertex_map, mesh, frame) : vertex_normals(mesh, frame);
}

/// Fills in vertices and quadrics. \return vertices of the complex → vertices of the output
std::vector<Index> write_vertices(const IndexedMesh& input, TriangleComplex& complex, const Frame& frame,
                                  const PairCost* quadrics_of, Decimation& out) {
  std::vector<Index> output_of(complex.n_vertex_slots(), invalid_index);
  IndexedMesh& mesh = out.mesh;
  mesh.positions.reserve(complex.n_vertices());
  mesh.origins.reserve(complex.n_vertices());
  if (quadrics_of) out.quadrics.reserve(complex.n_vertices());
  for (Index v = 0; v < out.vertex_map.size(); ++v) {
    const Index r = out.vertex_map[v];
    if (r == invalid_index || complex.identity(r) != v) continue;
    output_of[r] = static_cast<Index>(mesh.positions.size());
    const Vec3& before = input.positions[v];
    const bool is_unmoved = complex.position(r) == frame.to_frame(before);  // keeps every bit, that of −0 too
    mesh.positions.push_back(is_unmoved ? before : frame.to_model(complex.position(r)));
    mesh.origins.push_back(input.origins.empty() ? v : input.origins[v]);
    if (quadrics_of) out.quadrics.push_back(quadrics_of->quadric(r));
  }
  return output_of;
}

}  // namespace

Decimation make_output(const IndexedMesh& input, TriangleComplex& complex, const Frame& frame, Normals normals,
                       const PairCost* quadrics_of) {
  Decimation out;
  out.vertex_map = representatives(complex);
  const std::vector<Index> output_of = write_vertices(input, complex, frame, quadrics_of, out);
  out.face_origins = surviving_faces(input.faces, out.vertex_map, complex.n_faces());
  if (complex.n_coincident_faces() > 0) leave_out_coincident(out.face_origins, input.faces, out.vertex_map, complex);
  for (Index& r : out.vertex_map) {
    if (r != invalid_index) r = output_of[r];
  }
  IndexedMesh& mesh = out.mesh;
  mesh.faces.reserve(out.face_origins.size());
  for (const Index f : out.face_origins) mesh.faces.push_back(mapped(input.faces[f], out.vertex_map));
  if (!input.colors.empty()) mesh.colors = merged_colors(input, out.vertex_map, mesh.positions.size());
  mesh.normals = output_normals(input, out.vertex_map, mesh, frame, normals);
  return out;
}

std::vector<Warning> warnings_about_attributes(const IndexedMesh& input) {
  std::vector<Warning> warnings;
  if (!input.corner_texcoords.empty()) {
    warnings.push_back({WarningKind::texcoords_dropped, "texture coordinates are not carried"});
  }
  if (!input.face_groups.empty()) warnings.push_back({WarningKind::groups_dropped, "groups are not carried"});
  return warnings;
}

}  // namespace whittle
