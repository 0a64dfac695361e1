#include "decimate/output.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "whittle/core/geometry/vertex_normals.hh"

namespace whittle {
namespace {

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
/// \param went_to vertices that the pass began with → vertices of the complex
std::vector<Index> write_vertices(const IndexedMesh& input, const Remainder* remainder, Pass& pass, const Frame& frame,
                                  bool with_quadrics, const std::vector<Index>& went_to, Decimation& out) {
  const TriangleComplex& complex = pass.complex();
  std::vector<Index> output_of(complex.n_vertex_slots(), invalid_index);
  IndexedMesh& mesh = out.mesh;
  mesh.positions.reserve(complex.n_vertices());
  mesh.origins.reserve(complex.n_vertices());
  if (with_quadrics) out.quadrics.reserve(complex.n_vertices());
  for (Index i = 0; i < went_to.size(); ++i) {
    const Index r = went_to[i];
    if (r == invalid_index || complex.identity(r) != i) continue;
    output_of[r] = static_cast<Index>(mesh.positions.size());
    const Index v = remainder ? remainder->origins[i] : i;
    const Vec3& before = input.positions[v];
    const bool is_unmoved = complex.position(r) == frame.to_frame(before);  // keeps every bit, that of −0 too
    mesh.positions.push_back(is_unmoved ? before : frame.to_model(complex.position(r)));
    mesh.origins.push_back(input.origins.empty() ? v : input.origins[v]);
    if (with_quadrics) out.quadrics.push_back(pass.cost().quadric(r));
  }
  return output_of;
}

}  // namespace

Decimation make_output(const IndexedMesh& input, const Remainder* remainder, Pass& pass, const Frame& frame,
                       const DecimateOptions& options) {
  Decimation out;
  IndexedMesh& mesh = out.mesh;
  const std::span<const Triangle> faces = remainder ? remainder->faces : input.faces;
  std::vector<Index> went_to = representatives(pass.complex());
  const std::vector<Index> output_of =
      write_vertices(input, remainder, pass, frame, options.keep_quadrics, went_to, out);
  out.face_origins = surviving_faces(faces, went_to, pass.complex());
  for (Index& r : went_to) {
    if (r != invalid_index) r = output_of[r];
  }
  mesh.faces.reserve(out.face_origins.size());
  for (Index& f : out.face_origins) {
    mesh.faces.push_back(mapped(faces[f], went_to));
    if (remainder) f = remainder->face_origins[f];
  }
  if (remainder) {
    out.vertex_map = remainder->vertex_map;
    for (Index& v : out.vertex_map) {
      if (v != invalid_index) v = went_to[v];
    }
  } else {
    out.vertex_map = std::move(went_to);
  }
  if (!input.colors.empty()) mesh.colors = merged_colors(input, out.vertex_map, mesh.positions.size());
  mesh.normals = output_normals(input, out.vertex_map, mesh, frame, options.normals);
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
