#include <algorithm>
#include <cmath>

#include "cost/attributes/scaled_attributes.hh"
#include "whittle/core/geometry/image_triangle.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

/// Of the length of the surface: what an error of 1 counts as, in normals (radians) and colours.
constexpr double length_of_radian = 5e-4;
constexpr double length_of_color = 3e-3;
/// Likewise: no error of attributes counts as more.
constexpr double most_error = 0.02;

Corners corners_in_frame(const IndexedMesh& mesh, const Frame& frame, std::size_t face) {
  return frame.to_frame(corners_of(mesh.positions, mesh.faces[face]));
}

/// Twice the area of a face in the texture, by the first two coordinates.
double double_area_in_texture(const IndexedMesh& mesh, const Attribute& texcoord, std::size_t face) {
  const auto at = [&](std::size_t k) { return detail::Vec2(texcoord.value(mesh.wedge(face, k)).data()); };
  return std::abs(detail::area_on_image(at(0), at(1), at(2)));
}

/// The length that others are shares of: of a square as large as the surface. Parts that lie far off make the box
/// around a mesh large, but not this.
double length_of_surface(const IndexedMesh& mesh, const Frame& frame) {
  double area = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) area += area_of(corners_in_frame(mesh, frame, f));
  return std::sqrt(area);
}

/// How long a texture's unit is on the surface, in the frame: the root of the ratio of areas. 0 without a texture.
double length_of_texture(const IndexedMesh& mesh, const Frame& frame, const Attribute& texcoord) {
  if (texcoord.n_components < 2) return 0;
  double surface = 0;
  double texture = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const double area = 0.5 * double_area_in_texture(mesh, texcoord, f);
    if (!(area > 0) || !std::isfinite(area)) continue;
    texture += area;
    surface += area_of(corners_in_frame(mesh, frame, f));
  }
  return texture > 0 ? std::sqrt(surface / texture) : 0;
}

/// Appends components to a table that is filled by columns.
class Columns {
 public:
  explicit Columns(std::size_t n_wedges) : n_wedges_(n_wedges) {}

  /// \param value (wedge, component) → number
  template <class Value>
  void add(std::size_t n, double length, const Value& value) {
    if (!(length > 0) || !std::isfinite(length)) return;
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<double>& column = columns_.emplace_back(n_wedges_);
      for (Index w = 0; w < n_wedges_; ++w) {
        const double number = length * value(w, i);
        column[w] = std::isfinite(number) ? number : 0;
      }
    }
  }

  ScaledAttributes rows(double farthest) const {
    ScaledAttributes attributes{columns_.size(), {}, farthest};
    const std::size_t stride = attributes.stride();
    attributes.values.resize(stride * n_wedges_);
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      for (std::size_t w = 0; w < n_wedges_; ++w) attributes.values[w * stride + j] = columns_[j][w];
    }
    return attributes;
  }

 private:
  std::size_t n_wedges_;
  std::vector<std::vector<double>> columns_;
};

/// Where the vertices of each joint lie in the mean. A blend of these points, by the weights of a wedge, stands for
/// the weights: what one joint's vertices take over from another's counts as the way between both.
class JointCenters {
 public:
  JointCenters(const Attribute& weights, std::span<const Vec3> position_of) : weights_(weights) {
    std::vector<double> totals;
    for (Index w = 0; w < position_of.size(); ++w) {
      for_each_joint(w, [&](std::size_t joint, double weight) {
        if (joint >= centers_.size()) centers_.resize(joint + 1, Vec3::Zero()), totals.resize(joint + 1);
        centers_[joint] += weight * position_of[w];
        totals[joint] += weight;
      });
    }
    for (std::size_t j = 0; j < centers_.size(); ++j) {
      if (totals[j] > 0) centers_[j] /= totals[j];
    }
  }

  Vec3 blend(Index wedge) const {
    Vec3 blend = Vec3::Zero();
    for_each_joint(wedge, [&](std::size_t joint, double weight) { blend += weight * centers_[joint]; });
    return blend;
  }

 private:
  template <class Visit>
  void for_each_joint(Index wedge, const Visit& visit) const {
    constexpr double most_joints = 65536;
    const std::span<const double> value = weights_.value(wedge);
    const std::size_t n = value.size() / 2;
    for (std::size_t i = 0; i < n; ++i) {
      const bool is_joint = value[i] >= 0 && value[i] < most_joints && value[n + i] > 0 && std::isfinite(value[n + i]);
      if (is_joint) visit(static_cast<std::size_t>(value[i]), value[n + i]);
    }
  }

  const Attribute& weights_;
  std::vector<Vec3> centers_;
};

std::vector<Vec3> positions_of_wedges(const IndexedMesh& mesh, const Frame& frame) {
  std::vector<Vec3> positions(n_wedges(mesh), Vec3::Zero());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) positions[mesh.wedge(f, k)] = frame.to_frame(mesh.positions[mesh.faces[f][k]]);
  }
  return positions;
}

void add_attribute(const IndexedMesh& mesh, const Frame& frame, double size, const AttributeWeights& weights,
                   const Attribute& attribute, Columns& columns) {
  const auto value = [&](Index w, std::size_t i) { return attribute.value(w)[i]; };
  switch (attribute.kind) {
    case AttributeKind::texcoord:
      if (weights.texcoord > 0) {
        columns.add(attribute.n_components, weights.texcoord * length_of_texture(mesh, frame, attribute), value);
      }
      break;
    case AttributeKind::normal:
      columns.add(attribute.n_components, weights.normal * length_of_radian * size, value);
      break;
    case AttributeKind::color:
      columns.add(attribute.n_components, weights.color * length_of_color * size, value);
      break;
    case AttributeKind::displacement:
      columns.add(attribute.n_components, weights.displacement * frame.scale, value);
      break;
    case AttributeKind::joint_weights:
      if (weights.joint_weights > 0) {
        const JointCenters centers(attribute, positions_of_wedges(mesh, frame));
        columns.add(3, weights.joint_weights,
                    [&](Index w, std::size_t i) { return centers.blend(w)[static_cast<Eigen::Index>(i)]; });
      }
      break;
    case AttributeKind::tangent:
    case AttributeKind::direction:
    case AttributeKind::scalar:
    case AttributeKind::category:
      break;
  }
}

}  // namespace

bool looks_at_attributes(const DecimateOptions& options, const IndexedMesh& mesh) {
  const bool has_quadrics = cost_traits(options.effective_cost()).has_quadrics;
  if (!has_quadrics || options.quadric.weights == Weights::uniform || options.isotropy > 0) return false;
  return !mesh.normals.empty() || !mesh.colors.empty() || !mesh.attributes.empty();
}

ScaledAttributes scaled_attributes(const IndexedMesh& input, const Frame& frame, const AttributeWeights& weights) {
  const double size = length_of_surface(input, frame);
  Columns columns(n_wedges(input));
  if (!input.normals.empty()) {
    columns.add(3, weights.normal * length_of_radian * size,
                [&](Index w, std::size_t i) { return input.normals[w][i]; });
  }
  if (!input.colors.empty()) {
    columns.add(3, weights.color * length_of_color * size, [&](Index w, std::size_t i) { return input.colors[w][i]; });
  }
  for (const Attribute& attribute : input.attributes) {
    add_attribute(input, frame, size, weights, attribute, columns);
  }
  return columns.rows(most_error * size);
}

}  // namespace whittle
