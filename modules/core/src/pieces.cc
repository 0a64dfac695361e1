#include "whittle/core/pieces.hh"

#include <algorithm>
#include <iterator>
#include <utility>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

template <class T>
std::vector<T> gathered(const std::vector<T>& values, std::span<const Index> kept) {
  std::vector<T> some;
  if (values.empty()) return some;
  some.reserve(kept.size());
  for (const Index i : kept) some.push_back(values[i]);
  return some;
}

std::vector<Attribute> gathered(const std::vector<Attribute>& attributes, std::span<const Index> kept) {
  std::vector<Attribute> some;
  for (const Attribute& attribute : attributes) {
    Attribute& values = some.emplace_back(attribute.without_values());
    values.values.reserve(kept.size() * attribute.n_components);
    for (const Index i : kept) {
      const std::span<const double> value = attribute.value(i);
      values.values.insert(values.values.end(), value.begin(), value.end());
    }
  }
  return some;
}

/// Numbers the `items` in ascending order.
/// \param numbers gets the number of each
/// \return `items`, ascending, each once
std::vector<Index> renumbered(std::vector<Index> items, std::vector<Index>& numbers) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
  for (Index i = 0; i < items.size(); ++i) numbers[items[i]] = i;
  return items;
}

/// \param numbers scratch, as long as the mesh has vertices, or wedges
MeshPiece piece_with(const IndexedMesh& mesh, std::vector<Index> faces, std::vector<Index>& numbers) {
  MeshPiece piece;
  IndexedMesh& own = piece.mesh;
  piece.faces = std::move(faces);
  std::vector<Index> corners;
  corners.reserve(3 * piece.faces.size());
  for (const Index f : piece.faces) corners.insert(corners.end(), mesh.faces[f].begin(), mesh.faces[f].end());
  piece.vertices = renumbered(corners, numbers);
  own.faces.reserve(piece.faces.size());
  for (const Index f : piece.faces) {
    const auto [a, b, c] = mesh.faces[f];
    own.faces.push_back({numbers[a], numbers[b], numbers[c]});
  }
  std::vector<Index> wedges = piece.vertices;
  if (!mesh.wedges.empty()) {
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = mesh.wedge(piece.faces[i / 3], i % 3);
    wedges = renumbered(corners, numbers);
    for (const Index w : corners) own.wedges.push_back(numbers[w]);
  }
  own.positions = gathered(mesh.positions, piece.vertices);
  own.origins = gathered(mesh.origins, piece.vertices);
  own.normals = gathered(mesh.normals, wedges);
  own.colors = gathered(mesh.colors, wedges);
  own.attributes = gathered(mesh.attributes, wedges);
  own.face_attributes = gathered(mesh.face_attributes, piece.faces);
  own.face_groups = gathered(mesh.face_groups, piece.faces);
  own.group_names = mesh.group_names;
  return piece;
}

/// Adds values, or as many of `absent` where there are none.
template <class T>
void append_values(std::vector<T>& all, std::size_t n_before, std::vector<T>&& more, std::size_t n_more,
                   const T& absent) {
  if (all.empty() && more.empty()) return;
  all.resize(n_before, absent);
  if (more.empty()) more.assign(n_more, absent);
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void append_attributes(std::vector<Attribute>& all, std::size_t n_before, const std::vector<Attribute>& more,
                       std::size_t n_more) {
  for (const Attribute& attribute : more) {
    auto same = std::find_if(all.begin(), all.end(), [&](const auto& other) { return is_same_kind(other, attribute); });
    if (same == all.end()) {
      same = all.insert(same, attribute.without_values());
      same->values.resize(n_before * attribute.n_components);
    }
    same->values.insert(same->values.end(), attribute.values.begin(), attribute.values.end());
  }
  for (Attribute& attribute : all) attribute.values.resize((n_before + n_more) * attribute.n_components);
}

}  // namespace

bool is_same_kind(const Attribute& a, const Attribute& b) {
  return a.name == b.name && a.kind == b.kind && a.n_components == b.n_components && a.type == b.type &&
         a.is_normalized == b.is_normalized;
}

std::vector<MeshPiece> split_mesh(const IndexedMesh& mesh, std::span<const Index> piece_of, std::size_t n_pieces) {
  const detail::IndexLists<Index> faces(n_pieces, [&](const auto& emit) {
    for (Index f = 0; f < mesh.faces.size(); ++f) emit(piece_of[f], f);
  });
  std::vector<Index> numbers(std::max(mesh.positions.size(), n_wedges(mesh)));
  std::vector<MeshPiece> pieces;
  pieces.reserve(n_pieces);
  for (Index i = 0; i < n_pieces; ++i) {
    const auto of_piece = faces.of(i);
    pieces.push_back(piece_with(mesh, {of_piece.begin(), of_piece.end()}, numbers));
  }
  return pieces;
}

void append_mesh(IndexedMesh& all, IndexedMesh more) {
  if (all.positions.empty() && all.attributes.empty() && all.face_attributes.empty() && all.group_names.empty()) {
    all = std::move(more);
    return;
  }
  const std::size_t n_before = n_wedges(all);
  const std::size_t n_more = n_wedges(more);
  if (!more.wedges.empty() || !all.wedges.empty()) {
    make_wedge_table(all);
    make_wedge_table(more);
    for (const Index w : more.wedges) all.wedges.push_back(static_cast<Index>(n_before) + w);
  }
  append_values(all.normals, n_before, std::move(more.normals), n_more, {0, 0, 0});
  append_values(all.colors, n_before, std::move(more.colors), n_more, {1, 1, 1, 1});
  append_attributes(all.attributes, n_before, more.attributes, n_more);
  append_attributes(all.face_attributes, all.faces.size(), more.face_attributes, more.faces.size());
  const auto first_group = static_cast<Index>(all.group_names.size());
  for (Index& group : more.face_groups) group += first_group;
  append_values(all.face_groups, all.faces.size(), std::move(more.face_groups), more.faces.size(), Index{0});
  all.group_names.insert(all.group_names.end(), more.group_names.begin(), more.group_names.end());
  const auto first = static_cast<Index>(all.positions.size());
  all.positions.insert(all.positions.end(), more.positions.begin(), more.positions.end());
  all.origins.insert(all.origins.end(), more.origins.begin(), more.origins.end());
  for (const auto& [a, b, c] : more.faces) all.faces.push_back({first + a, first + b, first + c});
}

}  // namespace whittle
