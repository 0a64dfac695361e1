#include "run/vanished.hh"

#include <algorithm>
#include <map>
#include <set>

#include "whittle/core/text/text.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

/// Of more regions the first are named.
constexpr std::size_t most_named = 5;

std::string value_text(std::span<const double> value) {
  std::string text;
  for (const double x : value) text.append(text.empty() ? "" : ",").append(shortest(x));
  return text;
}

/// Materials that have faces before and none after. Several groups may have one.
std::vector<std::string> vanished_materials(const IndexedMesh& mesh, std::span<const Index> face_origins) {
  if (mesh.face_groups.empty()) return {};
  const auto name_of = [&](Index f) {
    const Index group = mesh.face_groups[f];
    const bool is_named = group < mesh.group_names.size() && !mesh.group_names[group].empty();
    return "material " + (is_named ? mesh.group_names[group] : std::to_string(group));
  };
  std::set<Index> groups;
  std::set<std::string> names;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (groups.insert(mesh.face_groups[f]).second) names.insert(name_of(f));
  }
  groups.clear();
  for (const Index f : face_origins) {
    if (groups.insert(mesh.face_groups[f]).second) names.erase(name_of(f));
  }
  return {names.begin(), names.end()};
}

/// Values that faces have before and none has after.
std::vector<std::string> vanished_values(const Scene& scene, std::span<const Index> face_origins,
                                         const Attribute& attribute) {
  std::set<std::vector<double>> values;
  for (std::size_t f = 0; f < attribute.size(); ++f) {
    const std::span<const double> value = attribute.value(f);
    values.emplace(value.begin(), value.end());
  }
  for (const Index f : face_origins) {
    const std::span<const double> value = attribute.value(f);
    values.erase({value.begin(), value.end()});
  }
  const auto& all_names = scene.read.notes.face_names;
  const auto names = all_names.find(attribute.name);
  std::vector<std::string> texts;
  for (const std::vector<double>& value : values) {
    const bool is_named = names != all_names.end() && value[0] >= 0 &&
                          value[0] < static_cast<double>(names->second.size()) && attribute.name != "s";
    texts.push_back(attribute.name + " " +
                    (is_named ? names->second[static_cast<std::size_t>(value[0])] : value_text(value)));
  }
  return texts;
}

/// Areas of which no face is left, though their region has one.
std::size_t n_vanished_charts(const IndexedMesh& mesh, std::span<const Index> face_origins,
                              const std::vector<Index>& regions) {
  const std::vector<Index> areas = seam_areas(mesh, seam_edges(mesh, regions));
  if (areas.empty()) return 0;
  const auto region_of = [&](Index f) { return regions.empty() ? Index{0} : regions[f]; };
  std::map<Index, Index> vanished;  // area → region
  for (Index f = 0; f < areas.size(); ++f) {
    if (areas[f] != invalid_index) vanished.try_emplace(areas[f], region_of(f));
  }
  std::set<Index> left;
  for (const Index f : face_origins) {
    vanished.erase(areas[f]);
    left.insert(region_of(f));
  }
  return static_cast<std::size_t>(
      std::count_if(vanished.begin(), vanished.end(), [&](const auto& area) { return left.contains(area.second); }));
}

}  // namespace

Vanished find_vanished(const Scene& scene, const Decimation& result, const RegionNames& names) {
  const IndexedMesh& mesh = scene.read.mesh;
  Vanished vanished;
  if (result.face_origins.empty()) return vanished;
  vanished.regions = vanished_materials(mesh, result.face_origins);
  for (const Attribute& attribute : mesh.face_attributes) {
    const auto is_named = [&](const std::string& name) { return has_name(attribute, name); };
    if (names ? std::none_of(names->begin(), names->end(), is_named) : !names_regions(mesh, attribute)) continue;
    const std::vector<std::string> more = vanished_values(scene, result.face_origins, attribute);
    vanished.regions.insert(vanished.regions.end(), more.begin(), more.end());
  }
  vanished.n_charts = n_vanished_charts(mesh, result.face_origins, face_regions(mesh, names));
  return vanished;
}

std::vector<std::string> texts_of(const Vanished& vanished) {
  std::vector<std::string> texts;
  if (const std::size_t n = vanished.regions.size(); n > 0) {
    std::vector<std::string> first = vanished.regions;
    first.resize(std::min(n, most_named));
    const std::string more = n > most_named ? " and " + std::to_string(n - most_named) + " more" : "";
    texts.push_back("nothing is left of " + listed(first) + more);
  }
  if (const std::size_t n = vanished.n_charts; n > 0) {
    texts.push_back("nothing is left of " + std::to_string(n) + (n == 1 ? " piece" : " pieces") +
                    " of the surface between seams of textures, materials or regions");
  }
  return texts;
}

}  // namespace whittle
