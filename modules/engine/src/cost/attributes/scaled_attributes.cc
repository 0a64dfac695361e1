#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "cost/attributes/scaled_attributes.hh"
#include "whittle/core/detail/parallel.hh"
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

/// Σ number(face), the same on any number of threads.
template <class Number>
double sum_over_faces(const IndexedMesh& mesh, unsigned threads, const Number& number) {
  const std::size_t n = mesh.faces.size();
  std::vector<double> sums((n + range_length - 1) / range_length);
  for_each_range(n, threads, [&](std::size_t begin, std::size_t end) {
    double& sum = sums[begin / range_length];
    for (std::size_t f = begin; f < end; ++f) sum += number(f);
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// The length that others are shares of: of a square as large as the surface. Parts that lie far off make the box
/// around a mesh large, but not this.
double length_of_surface(const IndexedMesh& mesh, const Frame& frame, unsigned threads) {
  return std::sqrt(
      sum_over_faces(mesh, threads, [&](std::size_t f) { return area_of(corners_in_frame(mesh, frame, f)); }));
}

/// How long a texture's unit is on the surface, in the frame: the root of the ratio of areas. 0 without a texture.
double length_of_texture(const IndexedMesh& mesh, const Frame& frame, const Attribute& texcoord, unsigned threads) {
  if (texcoord.n_components < 2) return 0;
  const auto area_in_texture = [&](std::size_t f) {
    const double area = 0.5 * double_area_in_texture(mesh, texcoord, f);
    return std::isfinite(area) ? area : 0;
  };
  const double texture = sum_over_faces(mesh, threads, area_in_texture);
  const double surface = sum_over_faces(mesh, threads, [&](std::size_t f) {
    return area_in_texture(f) > 0 ? area_of(corners_in_frame(mesh, frame, f)) : 0;
  });
  return texture > 0 ? std::sqrt(surface / texture) : 0;
}

/// The columns of the table, some for each attribute.
class Columns {
 public:
  using Value = std::function<double(Index wedge, std::size_t component)>;

  void add(std::size_t n, double length, Value value) {
    if (!(length > 0) || !std::isfinite(length)) return;
    all_.push_back({n, length, std::move(value)});
    n_components_ += n;
  }

  ScaledAttributes rows(std::size_t n_wedges, double farthest, unsigned threads) const {
    ScaledAttributes attributes{n_components_, {}, farthest};
    const std::size_t stride = attributes.stride();
    attributes.values.resize(stride * n_wedges);
    for_each_range(n_wedges, threads, [&](std::size_t begin, std::size_t end) {
      for (auto w = static_cast<Index>(begin); w < end; ++w) fill(w, attributes.values.data() + w * stride);
    });
    return attributes;
  }

 private:
  struct Some {
    std::size_t n;
    double length;
    Value value;
  };

  void fill(Index w, double* row) const {
    for (const auto& [n, length, value] : all_) {
      for (std::size_t i = 0; i < n; ++i) {
        const double number = length * value(w, i);
        *row++ = std::isfinite(number) ? number : 0;
      }
    }
  }

  std::vector<Some> all_;
  std::size_t n_components_ = 0;
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
                   const Attribute& attribute, unsigned threads, Columns& columns) {
  const auto value = [&attribute](Index w, std::size_t i) { return attribute.value(w)[i]; };
  switch (attribute.kind) {
    case AttributeKind::texcoord:
      if (weights.texcoord > 0) {
        const double length = length_of_texture(mesh, frame, attribute, threads);
        columns.add(attribute.n_components, weights.texcoord * length, value);
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
        columns.add(3, weights.joint_weights,
                    [centers = JointCenters(attribute, positions_of_wedges(mesh, frame))](Index w, std::size_t i) {
                      return centers.blend(w)[static_cast<Eigen::Index>(i)];
                    });
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

ScaledAttributes scaled_attributes(const IndexedMesh& input, const Frame& frame, const AttributeWeights& weights,
                                   unsigned threads) {
  const double size = length_of_surface(input, frame, threads);
  Columns columns;
  if (!input.normals.empty()) {
    columns.add(3, weights.normal * length_of_radian * size,
                [&input](Index w, std::size_t i) { return input.normals[w][i]; });
  }
  if (!input.colors.empty()) {
    columns.add(3, weights.color * length_of_color * size,
                [&input](Index w, std::size_t i) { return input.colors[w][i]; });
  }
  for (const Attribute& attribute : input.attributes) {
    add_attribute(input, frame, size, weights, attribute, threads, columns);
  }
  return columns.rows(n_wedges(input), most_error * size, threads);
}

}  // namespace whittle
