#include "format/corner_values.hh"

#include <algorithm>
#include <bit>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "whittle/core/detail/large_array.hh"
#include "whittle/core/wedges.hh"

namespace whittle::io {
namespace {

template <class Numbers>
bool are_same_bits(const Numbers& a, const Numbers& b) {
  return std::equal(std::begin(a), std::end(a), std::begin(b), [](auto x, auto y) {
    return std::bit_cast<std::array<char, sizeof x>>(x) == std::bit_cast<std::array<char, sizeof y>>(y);
  });
}

/// Finds the wedges of each vertex, in the order of corners.
class WedgeFinder {
 public:
  WedgeFinder(std::size_t n_vertices, const CornerValues& values) : values_(values) {
    resize_large(first_, n_vertices, invalid_index);
    vertices_.reserve(n_vertices);
    items_.reserve(n_vertices);
    next_.reserve(n_vertices);
  }

  /// The wedge of a corner. Very many wedges at a vertex aren't searched: some of them may be equal then.
  Index at(Index vertex, const CornerItems& items) {
    constexpr int most_compared = 16;
    Index* link = &first_[vertex];
    for (int i = 0; *link != invalid_index && i < most_compared; ++i) {
      if (are_equal(items_[*link], items)) return *link;
      link = &next_[*link];
    }
    has_several_ = has_several_ || first_[vertex] != invalid_index;
    const auto wedge = static_cast<Index>(vertices_.size());
    const Index rest = std::exchange(*link, wedge);
    vertices_.push_back(vertex);
    items_.push_back(items);
    next_.push_back(rest);
    return wedge;
  }

  bool has_several() const { return has_several_; }  ///< at some vertex
  std::span<const Index> vertices() const { return vertices_; }
  std::span<const CornerItems> items() const { return items_; }
  /// The only wedge of a vertex, if it has one.
  Index only(std::size_t vertex) const { return first_[vertex]; }

 private:
  bool are_equal(const CornerItems& a, const CornerItems& b) const {
    if (a == b) return true;
    return are_same_texcoords(a.texcoord, b.texcoord) && are_same_normals(a.normal, b.normal);
  }
  bool are_same_texcoords(Index a, Index b) const {
    if (a == b) return true;
    if (a == invalid_index || b == invalid_index) return false;
    return are_same_bits(values_.texcoords.value(a), values_.texcoords.value(b));
  }
  bool are_same_normals(Index a, Index b) const {
    if (a == b) return true;
    if (a == invalid_index || b == invalid_index) return false;
    return are_same_bits(values_.normals[a], values_.normals[b]);
  }

  const CornerValues& values_;
  std::vector<Index> first_;        // Of a vertex.
  std::vector<Index> vertices_;     // Of a wedge.
  std::vector<CornerItems> items_;  // Of a wedge.
  std::vector<Index> next_;         // Of a wedge, at the same vertex.
  bool has_several_ = false;
};

/// \param items of each wedge
void add_values(IndexedMesh& mesh, CornerValues& values, std::span<const CornerItems> items) {
  const auto is_any = [&](auto has) { return std::any_of(items.begin(), items.end(), has); };
  if (is_any([](const CornerItems& i) { return i.normal != invalid_index; })) {
    resize_large(mesh.normals, items.size());
    for (std::size_t w = 0; w < items.size(); ++w) {
      const Index n = items[w].normal;
      mesh.normals[w] = n == invalid_index ? std::array<float, 3>{0, 0, 0} : values.normals[n];
    }
  }
  if (!is_any([](const CornerItems& i) { return i.texcoord != invalid_index; })) return;
  const std::size_t n = values.texcoords.n_components;
  std::vector<double> of_wedges(n * items.size(), 0);
  for (std::size_t w = 0; w < items.size(); ++w) {
    if (items[w].texcoord == invalid_index) continue;
    const auto value = std::span<const double>(values.texcoords.values).subspan(n * items[w].texcoord, n);
    std::copy(value.begin(), value.end(), of_wedges.begin() + static_cast<std::ptrdiff_t>(n * w));
  }
  values.texcoords.values = std::move(of_wedges);
  mesh.attributes.push_back(std::move(values.texcoords));
}

/// The items of each vertex, if all its corners have equal items: the common case without seams.
std::optional<std::vector<CornerItems>> items_of_vertices(const IndexedMesh& mesh,
                                                          const std::vector<CornerItems>& corners) {
  std::vector<CornerItems> items(mesh.positions.size());
  std::vector<char> is_known(items.size(), 0);
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    const Index v = mesh.faces[corner / 3][corner % 3];
    if (is_known[v] != 0 && items[v] != corners[corner]) return std::nullopt;
    items[v] = corners[corner];
    is_known[v] = 1;
  }
  return items;
}

}  // namespace

void set_corner_values(IndexedMesh& mesh, CornerValues values) {
  if (values.corners.empty()) return;
  if (const auto items = items_of_vertices(mesh, values.corners)) return add_values(mesh, values, *items);
  WedgeFinder finder(mesh.positions.size(), values);
  std::vector<Index> wedges;
  resize_large(wedges, values.corners.size());
  for (std::size_t corner = 0; corner < wedges.size(); ++corner) {
    wedges[corner] = finder.at(mesh.faces[corner / 3][corner % 3], values.corners[corner]);
  }
  if (finder.has_several()) {
    gather_wedges(mesh, finder.vertices());
    mesh.wedges = std::move(wedges);
    add_values(mesh, values, finder.items());
    return;
  }
  std::vector<CornerItems> items(mesh.positions.size());
  for (std::size_t v = 0; v < items.size(); ++v) {
    if (finder.only(v) != invalid_index) items[v] = finder.items()[finder.only(v)];
  }
  add_values(mesh, values, items);
}

void set_vertex_normals(IndexedMesh& mesh, const CornerValues& values, bool& are_summed) {
  struct VertexNormal {
    Index vertex;
    Index normal;
    auto operator<=>(const VertexNormal&) const = default;
  };
  std::vector<Index> first(mesh.positions.size(), invalid_index);
  std::vector<VertexNormal> further;
  for (std::size_t corner = 0; corner < values.corners.size(); ++corner) {
    const Index vertex = mesh.faces[corner / 3][corner % 3];
    const Index normal = values.corners[corner].normal;
    if (normal == invalid_index || first[vertex] == normal) continue;
    if (first[vertex] == invalid_index) {
      first[vertex] = normal;
    } else {
      further.push_back({vertex, normal});
    }
  }
  mesh.normals.assign(first.size(), {0, 0, 0});
  for (std::size_t v = 0; v < first.size(); ++v) {
    if (first[v] != invalid_index) mesh.normals[v] = values.normals[first[v]];
  }
  std::sort(further.begin(), further.end());
  further.erase(std::unique(further.begin(), further.end()), further.end());
  are_summed = !further.empty();
  for (const auto& [vertex, normal] : further) {
    for (std::size_t i = 0; i < 3; ++i) mesh.normals[vertex][i] += values.normals[normal][i];
  }
}

}  // namespace whittle::io
