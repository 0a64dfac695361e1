#include "geometry/split.hh"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <string>

#include "geometry/joint_weights.hh"
#include "geometry/layout.hh"
#include "whittle/core/wedges.hh"

namespace whittle::gltf {
namespace {

[[noreturn]] void refuse(std::size_t mesh, const std::string& problem) {
  throw std::invalid_argument("mesh " + std::to_string(mesh) + ": " + problem);
}

std::vector<std::size_t> surfaces_of(const Mesh& mesh) {
  std::vector<std::size_t> surfaces;
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
    if (mesh.primitives[p].is_surface()) surfaces.push_back(p);
  }
  return surfaces;
}

/// The primitive of each face.
std::vector<Index> groups_of(const Mesh& mesh, const IndexedMesh& triangles) {
  if (!triangles.face_groups.empty()) return triangles.face_groups;
  const std::vector<std::size_t> surfaces = surfaces_of(mesh);
  return std::vector<Index>(triangles.faces.size(), surfaces.empty() ? 0 : static_cast<Index>(surfaces.front()));
}

void check_groups(const Mesh& mesh, std::size_t number, const IndexedMesh& triangles) {
  if (triangles.faces.empty()) return;
  if (triangles.face_groups.empty()) {
    if (surfaces_of(mesh).size() != 1) refuse(number, "its faces have no groups, and not one primitive has triangles");
    return;
  }
  if (triangles.face_groups.size() != triangles.faces.size()) refuse(number, "there is not a group for each face");
  for (const Index group : triangles.face_groups) {
    if (group >= mesh.primitives.size() || !mesh.primitives[group].is_surface()) {
      refuse(number, "group " + std::to_string(group) + " is not a primitive with triangles");
    }
  }
}

void check_indices_and_sizes(std::size_t number, const IndexedMesh& triangles) {
  const std::size_t n = n_wedges(triangles);
  for (const Triangle& face : triangles.faces) {
    for (const Index v : face) {
      if (v >= triangles.positions.size()) refuse(number, "an index is above the vertices");
    }
  }
  if (!triangles.wedges.empty() && triangles.wedges.size() != 3 * triangles.faces.size()) {
    refuse(number, "there is not a wedge for each corner");
  }
  for (const Index wedge : triangles.wedges) {
    if (wedge >= n) refuse(number, "an index is above the wedges");
  }
  const auto check = [&](std::size_t size, const std::string& name) {
    if (size != n) refuse(number, name + " has " + std::to_string(size) + " values for " + std::to_string(n));
  };
  if (!triangles.normals.empty()) check(triangles.normals.size(), "NORMAL");
  if (!triangles.colors.empty()) check(triangles.colors.size(), "COLOR_0");
  for (const Attribute& attribute : triangles.attributes) check(attribute.size(), attribute.name);
}

/// \param numbers `invalid_index` for each wedge, before and after
Piece piece_of(const IndexedMesh& triangles, std::size_t primitive, std::span<const Index> faces,
               std::vector<Index>& numbers) {
  Piece piece;
  piece.primitive = primitive;
  std::vector<std::pair<Index, Index>> used;  // wedges and their vertices
  for (const Index f : faces) {
    Triangle face;
    for (std::size_t c = 0; c < 3; ++c) {
      face[c] = triangles.wedge(f, c);
      if (numbers[face[c]] == invalid_index) used.emplace_back(face[c], triangles.faces[f][c]);
      numbers[face[c]] = 0;
    }
    piece.faces.push_back(face);
  }
  std::sort(used.begin(), used.end());
  for (const auto& [wedge, vertex] : used) {
    numbers[wedge] = static_cast<Index>(piece.wedges.size());
    piece.wedges.push_back(wedge);
    piece.vertices.push_back(vertex);
  }
  for (Triangle& face : piece.faces) {
    for (Index& v : face) v = numbers[v];
  }
  for (const Index wedge : piece.wedges) numbers[wedge] = invalid_index;
  return piece;
}

/// The values of an attribute that has an array of its own.
template <class Values>
std::vector<double> gathered(const Values& values, std::span<const Index> numbers, std::size_t n) {
  std::vector<double> all;
  all.reserve(numbers.size() * n);
  for (const Index i : numbers) {
    for (std::size_t k = 0; k < n; ++k) all.push_back(static_cast<double>(values[i][static_cast<Index>(k)]));
  }
  return all;
}

/// Some components of an attribute; missing ones are zero.
std::vector<double> gathered(const Attribute& attribute, std::span<const Index> numbers, const Place& place) {
  std::vector<double> all;
  all.reserve(numbers.size() * place.n);
  for (const Index i : numbers) {
    const std::span<const double> value = attribute.value(i);
    for (std::size_t k = place.first; k < place.first + place.n; ++k) all.push_back(k < value.size() ? value[k] : 0);
  }
  return all;
}

/// A set of joints or of weights.
std::vector<double> gathered_joints(const Attribute& attribute, std::span<const Index> numbers,
                                    const Primitive& primitive, const Channel& channel, const Accessor& accessor) {
  const std::size_t n_sets = n_joint_sets(primitive);
  const bool are_weights = channel.name.starts_with("WEIGHTS_");
  std::size_t set = 0;
  while (!channel.name.ends_with('_' + std::to_string(set))) ++set;
  std::vector<double> all;
  all.reserve(numbers.size() * joints_a_set);
  for (const Index i : numbers) {
    JointWeights kept = kept_joints(attribute.value(i), joints_a_set * n_sets);
    kept.joints.resize(joints_a_set * n_sets);
    kept.weights.resize(joints_a_set * n_sets);
    if (are_weights && is_integer(accessor.type)) round_weights(kept.weights, largest_of(accessor.type));
    const auto first =
        (are_weights ? kept.weights : kept.joints).begin() + static_cast<std::ptrdiff_t>(joints_a_set * set);
    all.insert(all.end(), first, first + joints_a_set);
  }
  return all;
}

}  // namespace

void check_replacement(const Model& model, std::size_t mesh, const IndexedMesh& triangles) {
  const Mesh& old = model.meshes.at(mesh);
  check_groups(old, mesh, triangles);
  check_indices_and_sizes(mesh, triangles);
  const std::vector<bool> lost = lost_primitives(model, old, triangles);
  if (!lost.empty() && std::all_of(lost.begin(), lost.end(), [](bool is_lost) { return is_lost; })) {
    refuse(mesh, "no triangle is left, and glTF has no empty meshes");
  }
}

std::vector<bool> primitives_with_faces(const Mesh& mesh, const IndexedMesh& triangles) {
  std::vector<bool> with_faces(mesh.primitives.size());
  for (const Index group : groups_of(mesh, triangles)) with_faces[group] = true;
  return with_faces;
}

std::vector<bool> lost_primitives(const Model& model, const Mesh& mesh, const IndexedMesh& triangles) {
  std::vector<bool> lost = primitives_with_faces(mesh, triangles);
  for (std::size_t p = 0; p < lost.size(); ++p) lost[p] = !lost[p] && n_triangles_of(model, mesh.primitives[p]) > 0;
  return lost;
}

std::vector<Piece> split_by_primitive(const Mesh& mesh, const IndexedMesh& triangles) {
  const std::vector<Index> groups = groups_of(mesh, triangles);
  std::vector<std::vector<Index>> faces_of(mesh.primitives.size());
  for (Index f = 0; f < groups.size(); ++f) faces_of[groups[f]].push_back(f);
  std::vector<Piece> pieces;
  std::vector<Index> numbers(n_wedges(triangles), invalid_index);
  for (std::size_t p = 0; p < faces_of.size(); ++p) {
    if (!faces_of[p].empty()) pieces.push_back(piece_of(triangles, p, faces_of[p], numbers));
  }
  return pieces;
}

std::optional<std::vector<double>> values_of(const Model& model, const Mesh& mesh, const IndexedMesh& triangles,
                                             const Piece& piece, const Channel& channel, const Accessor& accessor) {
  const Primitive& primitive = mesh.primitives[piece.primitive];
  const std::size_t n = accessor.shape.n_components();
  if (channel.name == "POSITION") return gathered(triangles.positions, piece.vertices, n);
  if (channel.name == "NORMAL") {
    if (triangles.normals.empty()) return {};
    return gathered(triangles.normals, piece.wedges, n);
  }
  if (channel.name == "COLOR_0") {
    if (triangles.colors.empty()) return {};
    return gathered(triangles.colors, piece.wedges, n);
  }
  const Place place = place_of(model, channel, primitive, n_joint_sets(mesh));
  const auto found = std::find_if(triangles.attributes.begin(), triangles.attributes.end(),
                                  [&](const Attribute& attribute) { return attribute.name == place.attribute; });
  if (found == triangles.attributes.end()) return {};
  if (place.attribute == joints_and_weights) {
    return gathered_joints(*found, piece.wedges, primitive, channel, accessor);
  }
  return gathered(*found, piece.wedges, place);
}

}  // namespace whittle::gltf
