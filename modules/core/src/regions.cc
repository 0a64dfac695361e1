#include "whittle/core/regions.hh"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

#include "whittle/core/detail/disjoint_sets.hh"
#include "whittle/core/detail/edge_table.hh"

namespace whittle {
namespace {

/// Largest number of values that may name parts, if they may also shade a surface: more can't be told apart by eye.
constexpr std::size_t most_shades = 256;
/// Least mean number of faces. A face has three neighbours: areas of eight faces have about as many inner edges as
/// border edges.
constexpr std::size_t least_faces_of_shade = 8;
/// Least mean number of faces, as of the sides of a box.
constexpr std::size_t least_faces_of_thing = 2;

/// Number by number, by their bits.
struct Less {
  using is_transparent = void;

  template <class A, class B>
  bool operator()(const A& a, const B& b) const {
    const auto less = [](double x, double y) { return std::strong_order(x, y) < 0; };
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less);
  }
};

/// The number of each face's value, by their first appearance. \param most values; if there are more: empty
std::vector<Index> numbered(const Attribute& attribute, std::size_t most) {
  std::vector<Index> numbers;
  numbers.reserve(attribute.size());
  std::map<std::vector<double>, Index, Less> number_of;
  for (std::size_t f = 0; f < attribute.size(); ++f) {
    const std::span<const double> value = attribute.value(f);
    auto found = number_of.find(value);
    if (found == number_of.end()) {
      if (number_of.size() == most) return {};
      found = number_of.emplace(std::vector(value.begin(), value.end()), static_cast<Index>(number_of.size())).first;
    }
    numbers.push_back(found->second);
  }
  return numbers;
}

/// Sets of faces that are connected over edges, as far as `connects(edge, f, g)` says.
template <class Connects>
detail::DisjointSets<Index> connected_faces(const IndexedMesh& mesh, const Connects& connects) {
  detail::DisjointSets<Index> sets(mesh.faces.size());
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::span<const Index> sides = edges.sides(e);
    for (std::size_t i = 1; i < sides.size(); ++i) {
      const Index f = detail::face_of(sides[i - 1]);
      const Index g = detail::face_of(sides[i]);
      if (connects(edges[e], f, g)) sets.join(f, g);
    }
  }
  return sets;
}

/// \param numbers of the faces' values
std::size_t n_areas(const IndexedMesh& mesh, const std::vector<Index>& numbers) {
  detail::DisjointSets<Index> sets =
      connected_faces(mesh, [&](const VertexPair&, Index f, Index g) { return numbers[f] == numbers[g]; });
  std::size_t n = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f) n += sets.find(f) == f ? 1U : 0U;
  return n;
}

bool are_whole(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x) && x == std::floor(x); });
}

bool is_real(ScalarType type) { return type == ScalarType::float32 || type == ScalarType::float64; }

/// Gives faces one number that had the same of both, by their first appearance.
void refine(std::vector<Index>& numbers, const std::vector<Index>& by) {
  std::map<std::pair<Index, Index>, Index> number_of;
  for (std::size_t f = 0; f < numbers.size(); ++f) {
    const auto next = static_cast<Index>(number_of.size());
    numbers[f] = number_of.try_emplace({numbers[f], by[f]}, next).first->second;
  }
}

}  // namespace

bool has_name(const Attribute& attribute, const std::string& name) {
  if (attribute.name == name) return true;
  if (attribute.n_components == 1) return false;
  std::string_view names = attribute.name;
  for (std::size_t comma = names.find(','); comma != names.npos; comma = names.find(',')) {
    if (names.substr(0, comma) == name) return true;
    names.remove_prefix(comma + 1);
  }
  return names == name;
}

bool names_regions(const IndexedMesh& mesh, const Attribute& attribute) {
  const std::size_t n_faces = mesh.faces.size();
  const bool names_things = attribute.kind == AttributeKind::category;
  const bool is_shade =
      attribute.kind == AttributeKind::color ||
      (attribute.kind == AttributeKind::scalar && is_real(attribute.type) && are_whole(attribute.values));
  if (!names_things && !is_shade) return false;
  const std::size_t least = names_things ? least_faces_of_thing : least_faces_of_shade;
  const std::size_t most_areas = n_faces / least;
  const std::vector<Index> numbers = numbered(attribute, names_things ? most_areas : std::min(most_areas, most_shades));
  return numbers.size() == n_faces && n_areas(mesh, numbers) <= most_areas;
}

std::vector<Index> face_regions(const IndexedMesh& mesh, const RegionNames& names) {
  const std::size_t n_faces = mesh.faces.size();
  std::vector<Index> regions(n_faces);
  if (!mesh.face_groups.empty()) refine(regions, mesh.face_groups);
  const auto is_named = [&](const Attribute& attribute) {
    return std::any_of(names->begin(), names->end(),
                       [&](const std::string& name) { return has_name(attribute, name); });
  };
  for (const Attribute& attribute : mesh.face_attributes) {
    if (names ? is_named(attribute) : names_regions(mesh, attribute)) refine(regions, numbered(attribute, n_faces));
  }
  const bool is_one = std::all_of(regions.begin(), regions.end(), [](Index region) { return region == 0; });
  return is_one ? std::vector<Index>{} : regions;
}

std::vector<Index> seam_areas(const IndexedMesh& mesh, std::span<const VertexPair> seams) {
  if (seams.empty()) return {};
  std::vector<std::uint8_t> has_seam(mesh.faces.size());
  detail::DisjointSets<Index> sets = connected_faces(mesh, [&](const VertexPair& edge, Index f, Index g) {
    if (!std::binary_search(seams.begin(), seams.end(), edge)) return true;
    has_seam[f] = has_seam[g] = 1;
    return false;
  });
  for (Index f = 0; f < mesh.faces.size(); ++f) has_seam[sets.find(f)] |= has_seam[f];
  std::vector<Index> areas(mesh.faces.size());
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Index first = sets.find(f);
    areas[f] = has_seam[first] != 0 ? first : invalid_index;
  }
  return areas;
}

}  // namespace whittle
