#include "files/gltf_file.hh"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/wedges.hh"
#include "whittle/io/repair.hh"

namespace whittle::app {
namespace {

/// Adds the values of another mesh, or as many of `absent` where that has none.
template <class T>
void append_values(std::vector<T>& all, std::size_t n_before, std::vector<T>&& more, std::size_t n_more,
                   const T& absent) {
  if (all.empty() && more.empty()) return;
  all.resize(n_before, absent);
  if (more.empty()) more.assign(n_more, absent);
  all.insert(all.end(), more.begin(), more.end());
}

bool is_same_kind(const Attribute& a, const Attribute& b) {
  return a.name == b.name && a.kind == b.kind && a.n_components == b.n_components && a.type == b.type &&
         a.is_normalized == b.is_normalized;
}

/// \return the attribute of `all` that takes the values of one of a part
std::size_t slot_of(const Attribute& attribute, std::size_t n_wedges, IndexedMesh& all) {
  const auto found = std::find_if(all.attributes.begin(), all.attributes.end(),
                                  [&](const Attribute& other) { return is_same_kind(other, attribute); });
  if (found != all.attributes.end()) return static_cast<std::size_t>(found - all.attributes.begin());
  all.attributes.push_back(attribute.without_values());
  all.attributes.back().values.resize(n_wedges * attribute.n_components);
  return all.attributes.size() - 1;
}

}  // namespace

bool is_gltf(const std::string& path) { return gltf::has_gltf_extension(path); }

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
  const std::size_t n_before = n_wedges(all);
  const std::size_t n_more = n_wedges(mesh);
  Part part{number,
            scale_of(number),
            static_cast<Index>(all.group_names.size()),
            static_cast<Index>(mesh.group_names.size()),
            !mesh.normals.empty(),
            !mesh.colors.empty(),
            {},
            {}};
  if (!mesh.wedges.empty() || !all.wedges.empty()) {
    make_wedge_table(all);
    make_wedge_table(mesh);
    for (const Index w : mesh.wedges) all.wedges.push_back(static_cast<Index>(n_before) + w);
  }
  append_values(all.normals, n_before, std::move(mesh.normals), n_more, {0, 0, 0});
  append_values(all.colors, n_before, std::move(mesh.colors), n_more, {1, 1, 1, 1});
  for (const Attribute& attribute : mesh.attributes) {
    part.attributes.push_back(attribute.without_values());
    part.slots.push_back(slot_of(attribute, n_before, all));
    std::vector<double>& values = all.attributes[part.slots.back()].values;
    values.insert(values.end(), attribute.values.begin(), attribute.values.end());
  }
  for (Attribute& attribute : all.attributes) attribute.values.resize((n_before + n_more) * attribute.n_components);
  const auto first = static_cast<Index>(all.positions.size());
  for (const Vec3& p : mesh.positions) all.positions.push_back(part.scale * p);
  for (const auto& [a, b, c] : mesh.faces) all.faces.push_back({first + a, first + b, first + c});
  for (const Index group : mesh.face_groups) all.face_groups.push_back(part.first_group + group);
  const std::string prefix = asset_.mesh_name(number) + ": ";
  for (const std::string& group : mesh.group_names) all.group_names.push_back(prefix + group);
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
    for (Index v = 0; v < mesh.positions.size(); ++v) {
      const Index origin = mesh.origins.empty() ? v : mesh.origins[v];
      result.mesh.origins.push_back(static_cast<Index>(result.file_vertices) + origin);
    }
    result.file_vertices += n_before;
    if (!mesh.faces.empty()) append(m, std::move(mesh), result.mesh);
  }
  if (result.mesh.faces.empty()) throw io::ReadError(path_.string(), "there are no triangles in it");
  return result;
}

std::vector<GltfFile::Group> GltfFile::groups() const {
  std::vector<Group> groups;
  for (const Part& part : parts_) {
    for (Index i = 0; i < part.n_groups; ++i) groups.push_back({part.mesh, i, part.scale});
  }
  return groups;
}

std::vector<IndexedMesh> GltfFile::split(const IndexedMesh& mesh) const {
  std::vector<Index> part_of_group;
  for (Index i = 0; i < parts_.size(); ++i) part_of_group.resize(part_of_group.size() + parts_[i].n_groups, i);
  const detail::IndexLists<Index> faces(parts_.size(), [&](const auto& emit) {
    for (Index f = 0; f < mesh.faces.size(); ++f) emit(part_of_group[mesh.face_groups[f]], f);
  });
  std::vector<Index> vertices(mesh.positions.size(), invalid_index);
  std::vector<Index> wedges(n_wedges(mesh), invalid_index);
  std::vector<IndexedMesh> split(parts_.size());
  for (Index i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    IndexedMesh& own = split[i];
    std::vector<Index> kept;  // wedges
    for (const Index f : faces.of(i)) {
      Triangle& face = own.faces.emplace_back();
      own.face_groups.push_back(mesh.face_groups[f] - part.first_group);
      for (std::size_t k = 0; k < 3; ++k) {
        Index& v = vertices[mesh.faces[f][k]];
        if (v == invalid_index) {
          v = static_cast<Index>(own.positions.size());
          own.positions.push_back(mesh.positions[mesh.faces[f][k]] / part.scale);
        }
        Index& w = wedges[mesh.wedge(f, k)];
        if (w == invalid_index) {
          w = static_cast<Index>(kept.size());
          kept.push_back(mesh.wedge(f, k));
        }
        face[k] = v;
        own.wedges.push_back(w);
      }
    }
    for (const Index w : kept) {
      if (part.has_normals && !mesh.normals.empty()) own.normals.push_back(mesh.normals[w]);
      if (part.has_colors && !mesh.colors.empty()) own.colors.push_back(mesh.colors[w]);
    }
    for (std::size_t a = 0; a < part.slots.size() && !mesh.attributes.empty(); ++a) {
      Attribute& attribute = own.attributes.emplace_back(part.attributes[a]);
      for (const Index w : kept) {
        const auto value = mesh.attributes[part.slots[a]].value(w);
        attribute.values.insert(attribute.values.end(), value.begin(), value.end());
      }
    }
  }
  return split;
}

std::vector<std::string> GltfFile::write(OutputFiles& files, const std::string& path, const IndexedMesh& mesh,
                                         bool compress) {
  std::vector<std::string> warnings;
  std::vector<IndexedMesh> meshes = split(mesh);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (meshes[i].faces.empty()) {
      warnings.push_back(asset_.mesh_name(parts_[i].mesh) + " would have no faces left, it stays as it was");
    } else {
      asset_.set_triangles(parts_[i].mesh, std::move(meshes[i]));
    }
  }
  for (const gltf::AssetFile& file : asset_.files(path, {.compress = compress})) {
    std::error_code error;
    if (file.path != path && file.path.has_parent_path()) {
      std::filesystem::create_directories(file.path.parent_path(), error);
    }
    files.write(file.path.string(), [&](std::ostream& out) { out << file.bytes; });
  }
  const std::vector<std::string> lost = asset_.warnings();
  warnings.insert(warnings.end(), lost.begin(), lost.end());
  return warnings;
}

}  // namespace whittle::app
