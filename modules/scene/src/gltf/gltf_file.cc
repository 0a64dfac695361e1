#include "gltf/gltf_file.hh"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <ostream>
#include <utility>

#include "gltf/screen_coverage.hh"
#include "whittle/core/float32_positions.hh"
#include "whittle/core/pieces.hh"
#include "whittle/core/text/text.hh"
#include "whittle/core/transform.hh"
#include "whittle/io/errors.hh"
#include "whittle/io/path_of.hh"
#include "whittle/io/repair.hh"

namespace whittle {
namespace {

/// The attribute of the same name and kind. Null if it was dropped.
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

/// Whether a map can be inverted precisely: it stretches no direction a million times as much as another.
bool can_be_undone(const Eigen::Affine3d& map) {
  if (!map.matrix().allFinite()) return false;
  const Vec3 stretches = Eigen::JacobiSVD<Eigen::Matrix3d>(map.linear()).singularValues();
  return stretches[0] < 1e100 && stretches[2] > 1e-100 && stretches[2] > 1e-6 * stretches[0];
}

/// The invertible place with the largest mesh; the identity without one.
Eigen::Affine3d largest_of(std::span<const Eigen::Affine3d> places) {
  const Eigen::Affine3d* largest = nullptr;
  const auto size = [](const Eigen::Affine3d& place) { return std::abs(place.linear().determinant()); };
  for (const Eigen::Affine3d& place : places) {
    // Of places equal up to rounding, the first one: so meshes below one node are taken below one node.
    if (can_be_undone(place) && (largest == nullptr || size(place) > (1 + 1e-6) * size(*largest))) largest = &place;
  }
  return largest == nullptr ? Eigen::Affine3d::Identity() : *largest;
}

/// Nodes and instances can repeat a mesh without end. A scene of this size takes 5 GB.
constexpr std::size_t largest_scene = std::size_t{1} << 27;

/// A mesh at several places, one copy after the other. All copies have the groups of the first one.
/// \param places one or more \param n_file_vertices that it had in the file \param first_origin of the first copy
IndexedMesh copies_at(std::span<const Eigen::Affine3d> places, IndexedMesh mesh, std::size_t n_file_vertices,
                      std::size_t first_origin) {
  const std::size_t n_groups = mesh.group_names.size();
  IndexedMesh all;
  const auto append_at = [&](const Eigen::Affine3d& place, IndexedMesh copy) {
    if (copy.origins.empty()) {
      copy.origins.resize(copy.positions.size());
      std::iota(copy.origins.begin(), copy.origins.end(), Index{0});
    }
    for (Index& origin : copy.origins) origin += static_cast<Index>(first_origin);
    first_origin += n_file_vertices;
    if (!all.group_names.empty()) copy.group_names.clear();  // else each copy would have its own
    transform_mesh(copy, place);
    append_mesh(all, std::move(copy));
  };
  for (const Eigen::Affine3d& place : places.first(places.size() - 1)) append_at(place, mesh);
  append_at(places.back(), std::move(mesh));
  for (Index& group : all.face_groups) group %= static_cast<Index>(n_groups);
  all.group_names.resize(n_groups);
  return all;
}

/// The largest coordinate of a mesh that a map turns and stretches, but doesn't move.
double farthest_of(const IndexedMesh& mesh, const Eigen::Matrix3d& linear) {
  double farthest = 0;
  for (const Vec3& p : mesh.positions) farthest = std::max(farthest, (linear * p).cwiseAbs().maxCoeff());
  return farthest;
}

/// Whether the scene of an asset shows a mesh with triangles. If not, all meshes are shown.
bool shows_meshes(const gltf::Asset& asset) {
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
    if (asset.n_triangles(m) > 0 && asset.n_instances(m) > 0) return true;
  }
  return false;
}

gltf::WriteOptions write_options(const SceneOutput& output) {
  gltf::WriteOptions options = output.gltf;
  options.shared_buffer = io::path_of(output.shared_path);
  return options;
}

}  // namespace

void write_asset(io::OutputFiles& files, const SceneOutput& output, const gltf::Asset& asset) {
  const std::filesystem::path main = io::path_of(output.path);
  for (const gltf::AssetFile& file : asset.files(main, write_options(output))) {
    if (file.path == main) {
      files.write(output.path, [&](std::ostream& out) { out << file.bytes; });
    } else {
      files.write_with_folders(file.path.string(), file.bytes);
    }
  }
}

GltfFile::GltfFile(const std::filesystem::path& path) : GltfFile(path, gltf::Asset::read(path)) {}

GltfFile::GltfFile(std::filesystem::path path, gltf::Asset asset) : path_(std::move(path)), asset_(std::move(asset)) {}

std::vector<Eigen::Affine3d> GltfFile::places_of(std::size_t mesh) const {
  std::vector<Eigen::Affine3d> places;
  for (const Eigen::Matrix4d& matrix : asset_.world_transforms(mesh)) places.emplace_back(matrix);
  return places;
}

GltfFile::Part GltfFile::part_of(std::size_t number, const Eigen::Affine3d& place, const IndexedMesh& mesh,
                                 const IndexedMesh& all) const {
  Part part{number,
            place,
            static_cast<Index>(all.group_names.size()),
            static_cast<Index>(mesh.group_names.size()),
            !mesh.normals.empty(),
            !mesh.colors.empty(),
            {},
            0,
            {}};
  for (const Attribute& attribute : mesh.attributes) part.attributes.push_back(attribute.without_values());
  return part;
}

/// The place of a mesh in the whole. A scene counts from its first mesh if it lies 2^22 times as far as that is long:
/// this leaves 30 bits. A mesh that its way would still leave fewer than 25 bits stays where it is.
Eigen::Affine3d GltfFile::place_of_one(std::span<const Eigen::Affine3d> places, const IndexedMesh& mesh) {
  Eigen::Affine3d place = largest_of(places);
  const double farthest = farthest_of(mesh, place.linear());
  const auto is_farther = [&](double times) {
    return !(place.translation().cwiseAbs().maxCoeff() <= times * farthest);
  };
  if (parts_.empty() && is_farther(0x1p22) && place.translation().allFinite()) scene_origin_ = place.translation();
  place.translation() -= scene_origin_;
  if (is_farther(0x1p28)) place.translation().setZero();
  return place;
}

void GltfFile::read_mesh(std::size_t number, std::vector<Eigen::Affine3d> places, const io::ReadOptions& options,
                         io::ReadResult& all) {
  IndexedMesh mesh = asset_.triangles(number);
  reach_ = std::max(reach_, farthest_of(mesh, largest_of(places).linear()));
  if (scope_ != SceneScope::scene) places = {place_of_one(places, mesh)};
  std::vector<Vec3> file_positions = scope_ == SceneScope::scene ? std::vector<Vec3>{} : mesh.positions;
  const std::size_t n_file_vertices = mesh.positions.size();
  const auto n_file_faces = mesh.faces.size();
  std::vector<Index> joined_to;
  all.repairs += io::repair(mesh, options.weld, &joined_to, options.threads);
  const std::vector<Index> vertex_map = io::vertex_map_of(mesh, n_file_vertices, joined_to);
  auto first = static_cast<Index>(all.mesh.positions.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    copies_.push_back({first, !can_be_undone(places[i])});
    for (const Index v : vertex_map) all.vertex_map.push_back(v == invalid_index ? v : first + v);
    first += static_cast<Index>(mesh.positions.size());
  }
  if (!mesh.faces.empty()) {
    const std::string prefix = asset_.mesh_name(number) + ": ";
    for (std::string& group : mesh.group_names) group.insert(0, prefix);
    parts_.push_back(part_of(number, places.front(), mesh, all.mesh));
    parts_.back().first_origin = all.file_vertices;
    parts_.back().file_positions = std::move(file_positions);
    append_mesh(all.mesh, copies_at(places, std::move(mesh), n_file_vertices, all.file_vertices));
  }
  all.file_vertices += places.size() * n_file_vertices;
  all.file_faces += places.size() * n_file_faces;
}

bool GltfFile::leaves_out(std::size_t mesh) const {
  if (asset_.n_instances(mesh) > 0) return false;
  return scope_ != SceneScope::meshes || asset_.is_level(mesh);
}

void GltfFile::warn_of_left_out(std::span<const std::size_t> meshes, io::ReadResult& result) const {
  if (meshes.empty()) return;
  const bool is_one = meshes.size() == 1;
  const std::string names = asset_.mesh_name(meshes.front()) +
                            (is_one ? "" : " and " + counted(meshes.size() - 1, "mesh", "meshes") + " more");
  result.warnings.push_back(
      scope_ == SceneScope::meshes
          ? names + (is_one ? " stays as it is: a level" : " stay as they are: levels") + " of detail (MSFT_lod)"
          : names + (is_one ? " is" : " are") + " left out: the scene doesn't show " + (is_one ? "it" : "them"));
}

io::ReadResult GltfFile::read(const io::ReadOptions& options, SceneScope scope) {
  io::ReadResult result;
  scope_ = scope;
  parts_.clear();
  scene_origin_.setZero();
  copies_.clear();
  reach_ = 0;
  const bool shows_any = shows_meshes(asset_);
  std::vector<std::size_t> left_out;
  for (std::size_t m = 0; m < asset_.n_meshes(); ++m) {
    if (asset_.n_triangles(m) == 0) continue;
    if (shows_any && leaves_out(m)) {
      left_out.push_back(m);
      continue;
    }
    std::vector<Eigen::Affine3d> places = places_of(m);
    if (places.empty()) places.push_back(Eigen::Affine3d::Identity());
    if (scope == SceneScope::scene &&
        places.size() * asset_.n_triangles(m) > largest_scene - std::min(largest_scene, result.file_faces)) {
      throw io::ReadError(path_.string(), "the scene has more than 2^27 triangles");
    }
    read_mesh(m, std::move(places), options, result);
  }
  weld_borders(options, result);
  warn_of_left_out(left_out, result);
  result.notes.has_float32_positions = fit_float32(result.mesh.positions);
  return result;
}

const Vec3* GltfFile::Part::unmoved(Index origin, const Vec3& position) const {
  if (origin >= first_origin && origin - first_origin < file_positions.size()) {
    const Vec3& before = file_positions[origin - first_origin];
    return place * before == position ? &before : nullptr;
  }
  const auto found = std::lower_bound(welded.begin(), welded.end(), origin,
                                      [](const Welded& w, Index number) { return w.origin < number; });
  if (found == welded.end() || found->origin != origin || found->position != position) return nullptr;
  return &file_positions[found->file_vertex];
}

Vec3 GltfFile::Part::as_written(Index origin, const Vec3& position) const {
  const Vec3* const as_it_was = unmoved(origin, position);
  return place * rounded_to_float32(as_it_was != nullptr ? *as_it_was : place.inverse() * position);
}

std::vector<GltfFile::Group> GltfFile::groups() const {
  std::vector<Group> groups;
  for (const Part& part : parts_) {
    for (Index i = 0; i < part.n_groups; ++i) groups.push_back({part.mesh, i});
  }
  return groups;
}

std::vector<Material> GltfFile::materials() const {
  const std::vector<std::vector<Material>> of_meshes = asset_.materials();
  std::vector<Material> materials;
  for (const auto& [mesh, primitive] : groups()) materials.push_back(of_meshes[mesh][primitive]);
  return materials;
}

std::vector<PlacedMesh> GltfFile::shown_meshes() const {
  const bool shows_any = shows_meshes(asset_);
  std::vector<std::vector<Material>> materials = asset_.materials();
  std::vector<PlacedMesh> shown;
  for (std::size_t m = 0; m < asset_.n_meshes(); ++m) {
    if (asset_.n_triangles(m) == 0) continue;
    std::vector<Eigen::Affine3d> places = places_of(m);
    if (!shows_any) places.push_back(Eigen::Affine3d::Identity());
    if (!places.empty()) shown.push_back({asset_.triangles(m), std::move(materials[m]), std::move(places)});
  }
  return shown;
}

std::string GltfFile::left_out_of_one_mesh(const IndexedMesh& mesh) const {
  const std::vector<Group> groups = this->groups();
  const bool has_looks = std::any_of(mesh.face_groups.begin(), mesh.face_groups.end(), [&](Index group) {
    return asset_.has_look(groups[group].mesh, groups[group].primitive);
  });
  std::string others = listed(asset_.other_content());
  if (!has_looks) return others;
  return "the materials, with their colours and images" + (others.empty() ? "" : "; " + others);
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
    const std::vector<Vec3> placed = own.positions;
    transform_mesh(own, part.place.inverse());
    for (Index v = 0; v < placed.size(); ++v) {
      if (const Vec3* const as_it_was = part.unmoved(own.origins[v], placed[v])) own.positions[v] = *as_it_was;
    }
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

IndexedMesh GltfFile::as_written(IndexedMesh mesh) const {
  const std::vector<Index> part_of_face = meshes_of_faces(mesh);
  std::vector<std::uint8_t> is_rounded(mesh.positions.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const Index v : mesh.faces[f]) {
      if (std::exchange(is_rounded[v], std::uint8_t{1}) != 0) continue;
      mesh.positions[v] = parts_[part_of_face[f]].as_written(mesh.origins[v], mesh.positions[v]);
    }
  }
  return mesh;
}

double GltfFile::widest_gap_as_written(const IndexedMesh& mesh) const {
  const IndexedMesh written = as_written(mesh);
  const std::vector<Index> part_of_face = meshes_of_faces(mesh);
  double widest = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const Index v : mesh.faces[f]) {
      const Vec3 here = parts_[part_of_face[f]].as_written(mesh.origins[v], mesh.positions[v]);
      widest = std::max(widest, (here - written.positions[v]).norm());
    }
  }
  return widest;
}

double GltfFile::widest_stretch() const {
  double widest = 1;
  for (const Part& part : parts_) {
    for (const Eigen::Affine3d& place : places_of(part.mesh)) {
      const Eigen::Matrix3d from_whole = place.linear() * part.place.linear().inverse();
      if (!from_whole.allFinite()) continue;
      widest = std::max(widest, Eigen::JacobiSVD<Eigen::Matrix3d>(from_whole).singularValues()[0]);
    }
  }
  return widest;
}

IndexedMesh GltfFile::scene_as_written(const IndexedMesh& mesh, const gltf::WriteOptions& writing,
                                       const io::ReadOptions& reading) const {
  std::vector<std::string> warnings;
  std::vector<IndexedMesh> meshes = split_for_file(mesh, "", warnings);
  std::map<std::size_t, IndexedMesh> triangles;
  for (std::size_t i = 0; i < parts_.size(); ++i) triangles.emplace(parts_[i].mesh, std::move(meshes[i]));
  GltfFile written(path_, asset_.as_written(std::move(triangles), writing));
  return written.read(reading, SceneScope::scene).mesh;
}

/// The meshes for a file; vanished meshes become a point. \param level beginning of warnings
std::vector<IndexedMesh> GltfFile::split_for_file(const IndexedMesh& mesh, const std::string& level,
                                                  std::vector<std::string>& warnings) const {
  std::vector<IndexedMesh> meshes = split(mesh);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (!meshes[i].faces.empty()) continue;
    const std::size_t number = parts_[i].mesh;
    warnings.push_back(level + asset_.mesh_name(number) +
                       " has vanished; a triangle without area stands for it, as glTF has no empty meshes");
    meshes[i] = a_point_of(asset_.triangles(number));
  }
  return meshes;
}

std::string GltfFile::mesh_with_levels() const {
  const auto found =
      std::find_if(parts_.begin(), parts_.end(), [this](const Part& part) { return asset_.has_levels(part.mesh); });
  return found == parts_.end() ? std::string() : asset_.mesh_name(found->mesh);
}

void GltfFile::add_levels(CoarserLevels levels, const SceneOutput& output, std::vector<std::string>& warnings) {
  std::vector<gltf::MeshLevels> coarser(parts_.size());
  for (std::size_t k = 0; k < levels.size(); ++k) {
    std::vector<IndexedMesh> meshes = split_for_file(*levels[k], "level " + std::to_string(k + 1) + ": ", warnings);
    for (std::size_t i = 0; i < parts_.size(); ++i) coarser[i].coarser.push_back(std::move(meshes[i]));
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    coarser[i].mesh = parts_[i].mesh;
    coarser[i].screen_coverage =
        screen_coverages(asset_.triangles(parts_[i].mesh), coarser[i].coarser, places_of(parts_[i].mesh), output);
  }
  asset_.add_levels(std::move(coarser));
}

std::vector<std::string> GltfFile::write(io::OutputFiles& files, const SceneOutput& output, const IndexedMesh* mesh,
                                         CoarserLevels levels) {
  std::vector<std::string> warnings;
  if (!levels.empty()) add_levels(levels, output, warnings);
  if (mesh != nullptr) {
    std::vector<IndexedMesh> meshes = split_for_file(*mesh, "", warnings);
    for (std::size_t i = 0; i < parts_.size(); ++i) asset_.set_triangles(parts_[i].mesh, std::move(meshes[i]));
  }
  write_asset(files, output, asset_);
  const std::vector<std::string> lost = asset_.warnings(output.gltf);
  warnings.insert(warnings.end(), lost.begin(), lost.end());
  return warnings;
}

}  // namespace whittle
