#include "files/gltf_file.hh"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>
#include <utility>

#include "files/companions.hh"
#include "whittle/core/pieces.hh"
#include "whittle/io/repair.hh"

namespace whittle::app {
namespace {

/// The attribute of `attributes` with the values that one of a part has. Null if it was dropped.
const Attribute* find_same_kind(const std::vector<Attribute>& attributes, const Attribute& attribute) {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const Attribute& other) { return is_same_kind(other, attribute); });
  return found == attributes.end() ? nullptr : &*found;
}

/// A triangle whose corners are all the first corner of the first face. \pre there is a face
IndexedMesh a_point_of(IndexedMesh mesh) {
  const Index v = mesh.faces.front().front();
  mesh.faces = {{v, v, v}};
  mesh.face_groups.resize(1);
  return mesh;
}

}  // namespace

bool is_gltf(const std::string& path) { return gltf::has_gltf_extension(path); }

void flip_texcoords(IndexedMesh& mesh) {
  for (Attribute& attribute : mesh.attributes) {
    if (attribute.kind != AttributeKind::texcoord || attribute.n_components < 2) continue;
    for (std::size_t w = 0; w < attribute.size(); ++w) attribute.value(w)[1] = 1 - attribute.value(w)[1];
  }
}

std::string why_no_faces(const io::ReadResult& read) {
  if (read.file_faces == 0) return "there are no triangles in it";
  return "there are only degenerate triangles in it (" + std::to_string(read.file_faces) + ")";
}

void write_asset(OutputFiles& files, const std::string& path, const gltf::Asset& asset, bool compress) {
  for (const gltf::AssetFile& file : asset.files(path, {.compress = compress})) {
    if (file.path == path) {
      files.write(path, [&](std::ostream& out) { out << file.bytes; });
    } else {
      write_with_folders(files, file.path, file.bytes);
    }
  }
}

GltfFile::GltfFile(const std::filesystem::path& path) : path_(path), asset_(gltf::Asset::read(path)) {}

/// A power of two near the largest scale that the scene has for the mesh.
double GltfFile::scale_of(std::size_t mesh) const {
  double largest = 0;
  for (const Eigen::Matrix4d& transform : asset_.world_transforms(mesh)) {
    const double determinant = std::abs(transform.topLeftCorner<3, 3>().determinant());
    largest = std::max(largest, std::cbrt(determinant));
  }
  if (!(largest > 1e-100 && largest < 1e100)) return 1;
  return std::exp2(std::round(std::log2(largest)));
}

void GltfFile::append(std::size_t number, IndexedMesh mesh, IndexedMesh& all) {
  Part part{number,
            scale_of(number),
            static_cast<Index>(all.group_names.size()),
            static_cast<Index>(mesh.group_names.size()),
            !mesh.normals.empty(),
            !mesh.colors.empty(),
            {}};
  for (const Attribute& attribute : mesh.attributes) part.attributes.push_back(attribute.without_values());
  for (Vec3& p : mesh.positions) p *= part.scale;
  const std::string prefix = asset_.mesh_name(number) + ": ";
  for (std::string& group : mesh.group_names) group.insert(0, prefix);
  append_mesh(all, std::move(mesh));
  parts_.push_back(std::move(part));
}

io::ReadResult GltfFile::read(const io::ReadOptions& options) {
  io::ReadResult result;
  parts_.clear();
  for (std::size_t m = 0; m < asset_.n_meshes(); ++m) {
    if (asset_.n_triangles(m) == 0) continue;
    IndexedMesh mesh = asset_.triangles(m);
    const std::size_t n_before = mesh.positions.size();
    std::vector<Index> joined_to;
    result.file_faces += mesh.faces.size();
    result.repairs += io::repair(mesh, options.weld, &joined_to, options.threads);
    const auto first = static_cast<Index>(result.mesh.positions.size());
    for (const Index v : io::vertex_map_of(mesh, n_before, joined_to)) {
      result.vertex_map.push_back(v == invalid_index ? v : first + v);
    }
    if (mesh.origins.empty()) {
      mesh.origins.resize(mesh.positions.size());
      std::iota(mesh.origins.begin(), mesh.origins.end(), Index{0});
    }
    for (Index& origin : mesh.origins) origin += static_cast<Index>(result.file_vertices);
    result.file_vertices += n_before;
    if (!mesh.faces.empty()) append(m, std::move(mesh), result.mesh);
  }
  return result;
}

std::vector<GltfFile::Group> GltfFile::groups() const {
  std::vector<Group> groups;
  for (const Part& part : parts_) {
    for (Index i = 0; i < part.n_groups; ++i) groups.push_back({part.mesh, i, part.scale});
  }
  return groups;
}

std::vector<Index> GltfFile::meshes_of_faces(const IndexedMesh& mesh) const {
  std::vector<Index> part_of_group;
  for (Index i = 0; i < parts_.size(); ++i) part_of_group.resize(part_of_group.size() + parts_[i].n_groups, i);
  std::vector<Index> meshes;
  meshes.reserve(mesh.faces.size());
  for (const Index group : mesh.face_groups) meshes.push_back(part_of_group[group]);
  return meshes;
}

std::vector<IndexedMesh> GltfFile::split(const IndexedMesh& mesh) const {
  std::vector<IndexedMesh> split;
  std::vector<MeshPiece> pieces = split_mesh(mesh, meshes_of_faces(mesh), parts_.size());
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    IndexedMesh& own = split.emplace_back(std::move(pieces[i].mesh));
    for (Vec3& p : own.positions) p /= part.scale;
    for (Index& group : own.face_groups) group -= part.first_group;
    if (!part.has_normals) own.normals.clear();
    if (!part.has_colors) own.colors.clear();
    std::vector<Attribute> attributes;
    for (const Attribute& attribute : part.attributes) {
      const Attribute* const values = find_same_kind(own.attributes, attribute);
      if (values != nullptr) attributes.push_back(*values);
    }
    own.attributes = std::move(attributes);
  }
  return split;
}

std::vector<std::string> GltfFile::write(OutputFiles& files, const std::string& path, const IndexedMesh& mesh,
                                         bool compress) {
  std::vector<std::string> warnings;
  std::vector<IndexedMesh> meshes = split(mesh);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const std::size_t number = parts_[i].mesh;
    if (meshes[i].faces.empty()) {
      warnings.push_back(asset_.mesh_name(number) +
                         " has vanished; a triangle without area stands for it, as glTF has no empty meshes");
      meshes[i] = a_point_of(asset_.triangles(number));
    }
    asset_.set_triangles(number, std::move(meshes[i]));
  }
  write_asset(files, path, asset_, compress);
  const std::vector<std::string> lost = asset_.warnings();
  warnings.insert(warnings.end(), lost.begin(), lost.end());
  return warnings;
}

}  // namespace whittle::app
