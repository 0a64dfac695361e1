#include "whittle/engine/attributes.hh"

#include <array>
#include <utility>

#include "attributes/wedge_map.hh"
#include "whittle/core/attribute_blend.hh"
#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/geometry/vertex_normals.hh"

namespace whittle {
namespace {

/// Carries attributes along a map of wedges.
class AttributeCarrier {
 public:
  AttributeCarrier(const WedgeMap& map, const Frame& frame, IndexedMesh& mesh)
      : map_(map),
        frame_(frame),
        mesh_(mesh),
        n_(map.of_corners.empty() ? mesh.positions.size() : map.vertex_of.size()) {
    merged_ = detail::IndexLists<Index>(n_, [&map](const auto& emit) {
      for (Index w = 0; w < map.of_input.size(); ++w) {
        if (map.of_input[w] != invalid_index) emit(map.of_input[w], w);
      }
    });
  }

  template <std::size_t N>
  std::vector<std::array<float, N>> carried(AttributeKind kind, const std::vector<std::array<float, N>>& from) {
    std::vector<std::array<float, N>> to(from.empty() ? 0 : n_);
    std::array<double, N> value{};
    blend(
        kind, N, to.size(),
        [&](Index w) {
          return std::copy(from[w].begin(), from[w].end(), value.begin()), std::span<const double>(value);
        },
        [&](Index w, std::span<const double> result) {
          for (std::size_t i = 0; i < N; ++i) to[w][i] = static_cast<float>(result[i]);
        });
    return to;
  }

  Attribute carried(const Attribute& from) {
    Attribute to = from.without_values();
    to.values.resize(n_ * from.n_components);
    blend(
        from.kind, from.n_components, n_, [&](Index w) { return from.value(w); },
        [&](Index w, std::span<const double> result) { std::copy(result.begin(), result.end(), to.value(w).begin()); });
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
  /// \param value_of input wedge → its value \param store gets each wedge of the result with its value
  template <class ValueOf, class Store>
  void blend(AttributeKind kind, std::size_t n_components, std::size_t n, const ValueOf& value_of, const Store& store) {
    AttributeBlend mean(kind, n_components);
    std::vector<double> result(n_components);
    for (Index w = 0; w < n; ++w) {
      for (const Index merged : merged_.of(w)) mean.add(value_of(merged), 1);
      if (!mean.result(result)) {
        const std::array<float, 3>& normal = vertex_normals()[map_.of_corners.empty() ? w : map_.vertex_of[w]];
        std::copy(normal.begin(), normal.end(), result.begin());
      }
      store(w, result);
    }
  }

  const std::vector<std::array<float, 3>>& vertex_normals() {
    if (vertex_normals_.empty()) vertex_normals_ = whittle::vertex_normals(mesh_, frame_);
    return vertex_normals_;
  }

  const WedgeMap& map_;
  const Frame& frame_;
  const IndexedMesh& mesh_;
  std::size_t n_;                                     ///< wedges of the result
  detail::IndexLists<Index> merged_;                  ///< the input's wedges that became each
  std::vector<std::array<float, 3>> vertex_normals_;  ///< of the result's faces, made when they are first asked for
};

bool has_attributes(const IndexedMesh& mesh) {
  return !mesh.normals.empty() || !mesh.colors.empty() || !mesh.attributes.empty();
}

void carry_face_attributes(const IndexedMesh& input, std::span<const Index> face_origins, IndexedMesh& mesh) {
  mesh.face_attributes.clear();
  for (const Attribute& from : input.face_attributes) {
    Attribute to = from.without_values();
    for (const Index f : face_origins) {
      const std::span<const double> value = from.value(f);
      to.values.insert(to.values.end(), value.begin(), value.end());
    }
    mesh.face_attributes.push_back(std::move(to));
  }
  mesh.face_groups.clear();
  if (input.face_groups.empty()) return;
  for (const Index f : face_origins) mesh.face_groups.push_back(input.face_groups[f]);
  mesh.group_names = input.group_names;
}

}  // namespace

void carry_attributes(const IndexedMesh& input, const Frame& frame, Normals normals, std::span<const Index> vertex_map,
                      std::span<const Index> face_origins, IndexedMesh& mesh) {
  carry_face_attributes(input, face_origins, mesh);
  if (!has_attributes(input)) return;
  WedgeMap map = map_wedges(input, vertex_map, face_origins);
  AttributeCarrier carrier(map, frame, mesh);
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

}  // namespace whittle
