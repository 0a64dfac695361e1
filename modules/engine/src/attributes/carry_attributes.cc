#include "whittle/engine/attributes.hh"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "attributes/face_attributes.hh"
#include "attributes/wedge_map.hh"
#include "whittle/core/attribute_blend.hh"
#include "whittle/core/attribute_functions.hh"
#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/vertex_normals.hh"
#include "whittle/core/keep_in_charts.hh"
#include "whittle/core/local_functions.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

/// Carries attributes along a map of wedges.
class AttributeCarrier {
 public:
  AttributeCarrier(const IndexedMesh& input, const WedgeMap& map, const Frame& frame, const IndexedMesh& mesh,
                   unsigned threads, bool keeps_in_charts)
      : input_(input),
        map_(map),
        frame_(frame),
        mesh_(mesh),
        threads_(threads),
        keeps_in_charts_(keeps_in_charts),
        n_(map.of_corners.empty() ? mesh.positions.size() : map.vertex_of.size()),
        functions_(input, frame, map.of_input, n_, threads),
        input_vertex_of_(vertices_of_wedges(input)) {
    merged_ = detail::IndexLists<Index>(n_, [&map](const auto& emit) {
      for (Index w = 0; w < map.of_input.size(); ++w) {
        if (map.of_input[w] != invalid_index) emit(map.of_input[w], w);
      }
    });
  }

  template <std::size_t N>
  std::vector<std::array<float, N>> carried(AttributeKind kind, const std::vector<std::array<float, N>>& from) {
    std::vector<std::array<float, N>> to(from.empty() ? 0 : n_);
    if (to.empty()) return to;
    std::vector<double> values;
    values.reserve(N * from.size());
    for (const auto& value : from) values.insert(values.end(), value.begin(), value.end());
    const std::vector<double> carried = carry(kind, N, values);
    for (std::size_t i = 0; i < carried.size(); ++i) to[i / N][i % N] = static_cast<float>(carried[i]);
    return to;
  }

  Attribute carried(const Attribute& from) {
    Attribute to = from.without_values();
    to.values = carry(from.kind, from.n_components, from.values);
    return to;
  }

  /// Those of the faces of the result.
  std::vector<std::array<float, 3>> normals_of_faces() {
    if (map_.of_corners.empty()) return vertex_normals();
    std::vector<std::array<float, 3>> normals;
    for (const Index v : map_.vertex_of) normals.push_back(vertex_normals()[v]);
    return normals;
  }

 private:
  Index vertex_of(Index w) const { return map_.of_corners.empty() ? w : map_.vertex_of[w]; }
  const Vec3& input_position(Index w) const {
    return input_.positions[input_vertex_of_.empty() ? w : input_vertex_of_[w]];
  }

  /// The wedge merged into w that was nearest to where it is now; of several the first. \pre there is one
  Index nearest_merged(Index w) const {
    const Vec3& position = mesh_.positions[vertex_of(w)];
    const auto distance = [&](Index merged) { return (input_position(merged) - position).squaredNorm(); };
    const std::span<const Index> merged = merged_.of(w);
    return *std::min_element(merged.begin(), merged.end(), [&](Index a, Index b) { return distance(a) < distance(b); });
  }

  std::vector<double> carry(AttributeKind kind, std::size_t n_components, std::span<const double> values) {
    if (kind == AttributeKind::normal) vertex_normals();  // before threads ask for them
    const AttributeFunctions functions(functions_, kind, n_components, values, threads_);
    std::vector<double> carried(n_ * n_components);
    for_each_range(n_, threads_, [&](std::size_t begin, std::size_t end) {
      AttributeBlend mean(kind, n_components);
      for (auto w = static_cast<Index>(begin); w < end; ++w) {
        carry_to(w, kind, values, functions, mean, std::span(carried).subspan(w * n_components, n_components));
      }
    });
    if (keeps_in_charts_ && kind == AttributeKind::texcoord && n_components >= 2)
      keep_texture_in_charts(functions, n_components, values, carried);
    return carried;
  }

  /// Where all vertices are the input's, as in an index buffer, so are all values.
  void keep_texture_in_charts(const AttributeFunctions& functions, std::size_t n_components,
                              std::span<const double> values, std::span<double> carried) const {
    std::vector<Index> wedges(n_);
    std::iota(wedges.begin(), wedges.end(), Index{0});
    const bool is_subset = std::all_of(wedges.begin(), wedges.end(), [&](Index w) {
      return input_position(nearest_merged(w)) == mesh_.positions[vertex_of(w)];
    });
    if (is_subset) return;
    std::vector<Triangle> faces(mesh_.faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        faces[f][k] = map_.of_corners.empty() ? mesh_.faces[f][k] : map_.of_corners[3 * f + k];
      }
    }
    const std::vector<Index> maps = functions.maps();
    keep_in_charts({input_, values, map_.of_input, n_components, faces, maps, threads_}, carried);
  }

  /// A wedge that has gone to the place of one merged into it has its value, to the bit. A category is that of the
  /// nearest. All others have what the input has around that place.
  void carry_to(Index w, AttributeKind kind, std::span<const double> values, const AttributeFunctions& functions,
                AttributeBlend& mean, std::span<double> to) {
    const auto value_of = [&](Index merged) { return values.subspan(merged * to.size(), to.size()); };
    const Index nearest = nearest_merged(w);
    const Vec3& position = mesh_.positions[vertex_of(w)];
    if (kind == AttributeKind::category || input_position(nearest) == position) {
      std::copy_n(value_of(nearest).begin(), to.size(), to.begin());
      return;
    }
    for (const Index merged : merged_.of(w)) mean.add(value_of(merged), 1);
    if (mean.result(to)) {
      functions.move(w, frame_.to_frame(position), to);
    } else {
      const std::array<float, 3>& normal = vertex_normals()[vertex_of(w)];
      std::copy(normal.begin(), normal.end(), to.begin());
    }
  }

  const std::vector<std::array<float, 3>>& vertex_normals() {
    if (vertex_normals_.empty()) vertex_normals_ = whittle::vertex_normals(mesh_, frame_);
    return vertex_normals_;
  }

  const IndexedMesh& input_;
  const WedgeMap& map_;
  const Frame& frame_;
  const IndexedMesh& mesh_;
  unsigned threads_;
  bool keeps_in_charts_;
  std::size_t n_;  ///< wedges of the result
  LocalFunctions functions_;
  std::vector<Index> input_vertex_of_;  ///< wedges of the input → its vertices; empty if they are the same
  detail::IndexLists<Index> merged_;    ///< the input's wedges that became each
  std::vector<std::array<float, 3>> vertex_normals_;  ///< of the result's faces, made when they are first asked for
};

bool has_attributes(const IndexedMesh& mesh) {
  return !mesh.normals.empty() || !mesh.colors.empty() || !mesh.attributes.empty();
}

}  // namespace

void carry_attributes(const IndexedMesh& input, const Frame& frame, Normals normals, std::span<const Index> vertex_map,
                      std::span<const Index> face_origins, IndexedMesh& mesh, unsigned threads, bool keeps_in_charts) {
  carry_face_attributes(input, face_origins, mesh);
  if (!has_attributes(input)) return;
  WedgeMap map = map_wedges(input, vertex_map, face_origins);
  AttributeCarrier carrier(input, map, frame, mesh, threads, keeps_in_charts);
  mesh.colors = carrier.carried(AttributeKind::color, input.colors);
  mesh.attributes.clear();
  for (const Attribute& attribute : input.attributes) mesh.attributes.push_back(carrier.carried(attribute));
  mesh.normals.clear();
  if (!input.normals.empty() && normals == Normals::keep) {
    mesh.normals = carrier.carried(AttributeKind::normal, input.normals);
  } else if (!input.normals.empty() && normals == Normals::recompute) {
    mesh.normals = carrier.normals_of_faces();
  }
  mesh.wedges = std::move(map.of_corners);
}

void break_normals(const Frame& frame, Normals normals, double crease_angle_deg, IndexedMesh& mesh) {
  if (normals == Normals::recompute && !mesh.normals.empty()) recompute_normals(mesh, frame, crease_angle_deg);
}

}  // namespace whittle
