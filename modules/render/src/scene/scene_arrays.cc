#include "scene/scene_arrays.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "whittle/core/wedges.hh"
#include "whittle/render/srgb.hh"

namespace whittle::render {

namespace {

constexpr std::uint32_t no_vertex = ~std::uint32_t{0};

float finite_or(double value, float other) {
  const float rounded = static_cast<float>(value);
  return std::isfinite(rounded) ? rounded : other;
}

/// The unit vector of a direction; zero for one that has no length or isn't finite.
Vec3 unit_or_zero(const Vec3& direction) {
  const double largest = direction.cwiseAbs().maxCoeff();
  if (!(largest > 0) || !std::isfinite(largest)) return Vec3::Zero();
  return (direction / largest).normalized();
}

/// Turns normals as `matrix` turns surfaces: the inverse transposed, times a positive number, also of flat matrices.
Eigen::Matrix3d normal_matrix(const Eigen::Matrix3d& matrix) {
  Eigen::Matrix3d cofactors;
  cofactors << matrix.col(1).cross(matrix.col(2)), matrix.col(2).cross(matrix.col(0)),
      matrix.col(0).cross(matrix.col(1));
  return matrix.determinant() < 0 ? Eigen::Matrix3d(-cofactors) : cofactors;
}

/// The material of each face of a part.
class FaceMaterials {
 public:
  explicit FaceMaterials(const Part& part) : part_(part) {}

  /// Beyond all materials: the default one.
  std::size_t operator()(std::size_t face) const {
    const auto& groups = part_.mesh->face_groups;
    return std::min<std::size_t>(groups.empty() ? 0 : groups[face], part_.materials.size());
  }

 private:
  const Part& part_;
};

/// Faces by material, in their order: faces of material m at begin[m] … begin[m + 1].
struct SortedFaces {
  std::vector<std::size_t> begin;
  std::vector<std::size_t> faces;
};

SortedFaces sort_by_material(const Part& part, const std::vector<Vec3>& positions) {
  const FaceMaterials material_of(part);
  const std::vector<Triangle>& faces = part.mesh->faces;
  SortedFaces sorted{std::vector<std::size_t>(part.materials.size() + 2), {}};
  std::vector<bool> is_drawn(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    is_drawn[f] = can_be_drawn(faces[f], positions);
    if (is_drawn[f]) ++sorted.begin[material_of(f) + 1];
  }
  for (std::size_t m = 1; m < sorted.begin.size(); ++m) sorted.begin[m] += sorted.begin[m - 1];
  sorted.faces.resize(sorted.begin.back());
  std::vector<std::size_t> next = sorted.begin;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (is_drawn[f]) sorted.faces[next[material_of(f)]++] = f;
  }
  return sorted;
}

/// Adds the faces of one part, material by material.
class PartWriter {
 public:
  PartWriter(const Scene& scene, const Part& part, const Sphere& frame, SceneArrays& out)
      : scene_(scene),
        part_(part),
        mesh_(*part.mesh),
        frame_(frame),
        out_(out),
        positions_(placed_positions(part)),
        normal_matrix_(normal_matrix(part.transform.linear())),
        is_mirrored_(part.transform.linear().determinant() < 0),
        vertices_of_wedges_(n_wedges(mesh_)) {
    check_arrays();
  }

  void write() {
    const SortedFaces sorted = sort_by_material(part_, positions_);
    for (std::size_t m = 0; m + 1 < sorted.begin.size(); ++m) {
      if (sorted.begin[m] == sorted.begin[m + 1]) continue;
      begin_batch(m < part_.materials.size() ? part_.materials[m] : Material{});
      for (std::size_t i = sorted.begin[m]; i < sorted.begin[m + 1]; ++i) write_face(sorted.faces[i]);
      Batch& batch = out_.batches.back();
      batch.n_indices = out_.indices.size() - batch.first_index;
    }
  }

 private:
  struct WedgeVertex {
    std::size_t batch = ~std::size_t{0};
    std::uint32_t vertex = no_vertex;
  };

  void check_arrays() const {
    const std::size_t n = vertices_of_wedges_.size();
    const auto fits = [n](std::size_t size) { return size == 0 || size >= n; };
    if (!fits(mesh_.normals.size()) || !fits(mesh_.colors.size())) {
      throw std::invalid_argument("a mesh to draw has too few normals or colours");
    }
    if (!mesh_.wedges.empty() && mesh_.wedges.size() != 3 * mesh_.faces.size()) {
      throw std::invalid_argument("a mesh to draw has too few wedges");
    }
    if (!mesh_.face_groups.empty() && mesh_.face_groups.size() != mesh_.faces.size()) {
      throw std::invalid_argument("a mesh to draw has too few face groups");
    }
  }

  void begin_batch(const Material& material) {
    Batch& batch = out_.batches.emplace_back(Batch{material, pixels_of(material), out_.indices.size(), 0});
    texcoords_ = batch.pixels == nullptr ? nullptr : texcoords_of(mesh_, *material.base_color_texture);
    if (texcoords_ == nullptr) {
      batch.material.base_color_texture.reset();
      batch.pixels = nullptr;
    }
    if (texcoords_ != nullptr && texcoords_->size() < vertices_of_wedges_.size()) {
      throw std::invalid_argument("a mesh to draw has too few values of " + texcoords_->name);
    }
  }

  const Pixels* pixels_of(const Material& material) const {
    if (!material.base_color_texture) return nullptr;
    const auto found = scene_.images.find(material.base_color_texture->image);
    return found == scene_.images.end() ? nullptr : &found->second;
  }

  void write_face(std::size_t face) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = vertex_at(face, k);
    if (is_mirrored_) std::swap(corners[1], corners[2]);
    const std::size_t batch = out_.batches.size() - 1;
    if (out_.batches[batch].material.alpha_mode == Alpha::blend) {
      out_.blend_faces.push_back({corners, static_cast<std::uint32_t>(batch)});
    } else {
      out_.indices.insert(out_.indices.end(), corners.begin(), corners.end());
    }
  }

  /// Corners of one wedge share a vertex, if the wedge has a normal.
  std::uint32_t vertex_at(std::size_t face, std::size_t corner) {
    const Index wedge = mesh_.wedge(face, corner);
    if (wedge >= vertices_of_wedges_.size()) throw std::invalid_argument("a face to draw has a wedge that isn't there");
    const Vec3 normal = mesh_.normals.empty() ? Vec3::Zero() : wedge_normal(wedge);
    if (normal.isZero(0)) return add_vertex(mesh_.faces[face][corner], wedge, face_normal_of(face));
    WedgeVertex& known = vertices_of_wedges_[wedge];
    const std::size_t batch = out_.batches.size() - 1;
    if (known.batch != batch) known = {batch, add_vertex(mesh_.faces[face][corner], wedge, normal)};
    return known.vertex;
  }

  Vec3 wedge_normal(Index wedge) const {
    const std::array<float, 3>& n = mesh_.normals[wedge];
    return unit_or_zero(normal_matrix_ * unit_or_zero({n[0], n[1], n[2]}));
  }

  /// Normal of the placed face, outwards also if the transform mirrors.
  Vec3 face_normal_of(std::size_t face) const {
    const Triangle& t = mesh_.faces[face];
    const Vec3 ab = (positions_[t[1]] - positions_[t[0]]) / frame_.radius;
    const Vec3 ac = (positions_[t[2]] - positions_[t[0]]) / frame_.radius;
    return unit_or_zero(is_mirrored_ ? ac.cross(ab) : ab.cross(ac));
  }

  std::uint32_t add_vertex(Index vertex, Index wedge, const Vec3& normal) {
    if (out_.vertices.size() >= no_vertex) throw std::invalid_argument("a scene to draw has too many vertices");
    // Far beyond the picture OpenGL's clipping would lose its digits.
    const Vec3 place = ((positions_[vertex] - frame_.center) / frame_.radius).cwiseMax(-1e6).cwiseMin(1e6);
    const Eigen::Vector3f position = place.cast<float>();
    const Eigen::Vector3f direction = normal.cast<float>();
    out_.vertices.push_back({{position[0], position[1], position[2]},
                             {direction[0], direction[1], direction[2]},
                             texcoord_of(wedge),
                             color_of(wedge)});
    return static_cast<std::uint32_t>(out_.vertices.size() - 1);
  }

  std::array<float, 2> texcoord_of(Index wedge) const {
    if (texcoords_ == nullptr) return {0, 0};
    const auto value = texcoords_->value(wedge);
    const Texture& texture = *out_.batches.back().material.base_color_texture;
    const Eigen::Vector2d uv = texture.transform * Eigen::Vector2d(value[0], value[1]);
    return {finite_or(uv[0], 0), finite_or(uv[1], 0)};
  }

  std::array<float, 4> color_of(Index wedge) const {
    if (mesh_.colors.empty()) return {1, 1, 1, 1};
    Color color = mesh_.colors[wedge];
    for (float& number : color) number = std::clamp(finite_or(number, 1), 0.0F, 1.0F);
    if (part_.vertex_colors == ColorEncoding::srgb) {
      for (std::size_t i = 0; i < 3; ++i) color[i] = linear_of_srgb(color[i]);
    }
    return color;
  }

  const Scene& scene_;
  const Part& part_;
  const IndexedMesh& mesh_;
  Sphere frame_;
  SceneArrays& out_;
  std::vector<Vec3> positions_;
  Eigen::Matrix3d normal_matrix_;
  bool is_mirrored_;
  std::vector<WedgeVertex> vertices_of_wedges_;
  const Attribute* texcoords_ = nullptr;  ///< of the batch
};

}  // namespace

std::vector<Vec3> placed_positions(const Part& part) {
  std::vector<Vec3> positions;
  positions.reserve(part.mesh->positions.size());
  for (const Vec3& position : part.mesh->positions) positions.push_back(part.transform * position);
  return positions;
}

bool can_be_drawn(const Triangle& face, const std::vector<Vec3>& positions) {
  for (const Index v : face) {
    if (v >= positions.size()) throw std::invalid_argument("a face to draw names a vertex that isn't there");
  }
  return has_three_corners(face) &&
         std::all_of(face.begin(), face.end(), [&](Index v) { return positions[v].allFinite(); });
}

SceneArrays scene_arrays(const Scene& scene, const Sphere& frame) {
  SceneArrays arrays;
  for (const Part& part : scene.parts) {
    if (part.mesh == nullptr) throw std::invalid_argument("a part of a scene to draw has no mesh");
    PartWriter(scene, part, frame, arrays).write();
  }
  return arrays;
}

}  // namespace whittle::render
