#include "sides/wedges_of_sides.hh"

#include <algorithm>
#include <numeric>
#include <utility>

#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

template <std::size_t N>
Attribute as_attribute(AttributeKind kind, const std::vector<std::array<float, N>>& values) {
  Attribute attribute{.kind = kind, .n_components = N};
  attribute.values.reserve(N * values.size());
  for (const auto& value : values) attribute.values.insert(attribute.values.end(), value.begin(), value.end());
  return attribute;
}

/// Puts the values of backs behind those of fronts.
template <std::size_t N>
void set_backs(const Attribute& of_backs, std::vector<std::array<float, N>>& values) {
  const std::size_t n = values.size() - of_backs.size();
  for (std::size_t w = 0; w < of_backs.size(); ++w) {
    for (std::size_t i = 0; i < N; ++i) values[n + w][i] = static_cast<float>(of_backs.value(w)[i]);
  }
}

}  // namespace

bool join_sides_of_wedges(std::span<const Index> back_wedges, IndexedMesh& mesh) {
  if (std::equal(back_wedges.begin(), back_wedges.end(), mesh.wedges.begin(), mesh.wedges.end())) return false;
  std::vector<std::pair<Index, Index>> both;
  for (std::size_t c = 0; c < back_wedges.size(); ++c) both.emplace_back(mesh.wedges[c], back_wedges[c]);
  std::vector<std::pair<Index, Index>> all = both;
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (std::size_t c = 0; c < both.size(); ++c) {
    mesh.wedges[c] = static_cast<Index>(std::lower_bound(all.begin(), all.end(), both[c]) - all.begin());
  }
  std::vector<Index> of_fronts;
  std::vector<Index> of_backs;
  for (const auto& [front, back] : all) {
    of_fronts.push_back(front);
    of_backs.push_back(back);
  }
  IndexedMesh backs;
  backs.normals = mesh.normals;
  backs.colors = mesh.colors;
  backs.attributes = mesh.attributes;
  gather_wedges(backs, of_backs);
  gather_wedges(mesh, of_fronts);
  if (!backs.normals.empty()) mesh.attributes.push_back(as_attribute(AttributeKind::normal, backs.normals));
  if (!backs.colors.empty()) mesh.attributes.push_back(as_attribute(AttributeKind::color, backs.colors));
  std::move(backs.attributes.begin(), backs.attributes.end(), std::back_inserter(mesh.attributes));
  return true;
}

void part_sides_of_wedges(const IndexedMesh& input, bool are_joined, bool turns_normals, IndexedMesh& mesh) {
  const std::size_t n = n_wedges(mesh);
  const auto first_of_backs = mesh.attributes.begin() + static_cast<std::ptrdiff_t>(input.attributes.size());
  std::vector<Attribute> of_backs(std::make_move_iterator(first_of_backs),
                                  std::make_move_iterator(mesh.attributes.end()));
  mesh.attributes.erase(first_of_backs, mesh.attributes.end());
  std::vector<Index> twice(2 * n);
  std::iota(twice.begin(), twice.begin() + static_cast<std::ptrdiff_t>(n), Index{0});
  std::iota(twice.begin() + static_cast<std::ptrdiff_t>(n), twice.end(), Index{0});
  make_wedge_table(mesh);
  gather_wedges(mesh, twice);
  if (are_joined) {
    auto next = of_backs.begin();
    if (!input.normals.empty()) {
      if (!mesh.normals.empty()) set_backs(*next, mesh.normals);
      ++next;
    }
    if (!input.colors.empty()) set_backs(*next++, mesh.colors);
    for (Attribute& attribute : mesh.attributes) {
      const Attribute& back = *next++;
      std::copy(back.values.begin(), back.values.end(), attribute.value(n).data());
    }
  }
  if (!turns_normals || mesh.normals.empty()) return;
  for (std::size_t w = n; w < 2 * n; ++w) {
    for (std::size_t i = 0; i < 3; ++i) mesh.normals[w][i] = -mesh.normals[w - n][i];
  }
}

}  // namespace whittle
