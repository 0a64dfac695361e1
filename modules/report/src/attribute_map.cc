#include "whittle/report/attribute_map.hh"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "whittle/core/detail/parallel.hh"
#include "whittle/core/wedges.hh"
#include "whittle/metrics/bounds.hh"
#include "whittle/metrics/closest_point.hh"

namespace whittle::report {
namespace {

using Value = Eigen::Vector3d;                      ///< two numbers, then 0; or three
using SheetPoint = Eigen::Matrix<double, 6, 1>;     ///< a position, then a value times s
using SheetCorners = std::array<SheetPoint, 3>;

const Attribute* first_texcoord(const IndexedMesh& mesh) {
  const auto found = std::find_if(mesh.attributes.begin(), mesh.attributes.end(), [](const Attribute& attribute) {
    return attribute.kind == AttributeKind::texcoord && attribute.n_components >= 2;
  });
  return found == mesh.attributes.end() ? nullptr : &*found;
}

std::vector<Value> values_of(SurfaceAttribute attribute, const IndexedMesh& mesh) {
  std::vector<Value> values;
  values.reserve(n_wedges(mesh));
  switch (attribute) {
    case SurfaceAttribute::texcoord: {
      const Attribute& texcoord = *first_texcoord(mesh);
      for (Index w = 0; w < texcoord.size(); ++w) values.emplace_back(texcoord.value(w)[0], texcoord.value(w)[1], 0);
      break;
    }
    case SurfaceAttribute::color:
      for (const Color& color : mesh.colors) values.emplace_back(color[0], color[1], color[2]);
      break;
    case SurfaceAttribute::normal:
      for (const auto& normal : mesh.normals) values.emplace_back(normal[0], normal[1], normal[2]);
      break;
  }
  return values;
}

double deviation(SurfaceAttribute attribute, const Value& a, const Value& b) {
  switch (attribute) {
    case SurfaceAttribute::texcoord:
      return (a - b).norm();
    case SurfaceAttribute::color:
      return (a - b).cwiseAbs().maxCoeff();
    case SurfaceAttribute::normal:
      break;
  }
  if (a.isZero() || b.isZero()) return 0;
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

/// The weights of the corners in the point of a triangle that is nearest to `p`.
std::array<double, 3> nearest_in(const SheetCorners& corners, const SheetPoint& p) {
  const SheetPoint u = corners[1] - corners[0];
  const SheetPoint v = corners[2] - corners[0];
  const SheetPoint to_p = p - corners[0];
  const double uu = u.squaredNorm();
  const double uv = u.dot(v);
  const double vv = v.squaredNorm();
  const double determinant = uu * vv - uv * uv;
  if (determinant > 0) {
    const double s = (vv * u.dot(to_p) - uv * v.dot(to_p)) / determinant;
    const double t = (uu * v.dot(to_p) - uv * u.dot(to_p)) / determinant;
    if (s >= 0 && t >= 0 && s + t <= 1) return {1 - s - t, s, t};
  }
  std::array<double, 3> best{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const SheetPoint side = corners[next] - corners[k];
    const double length_sq = side.squaredNorm();
    const double share = length_sq > 0 ? std::clamp(side.dot(p - corners[k]) / length_sq, 0.0, 1.0) : 0;
    const double distance_sq = (corners[k] + share * side - p).squaredNorm();
    if (!(distance_sq < least)) continue;
    least = distance_sq;
    best = {};
    best[k] = 1 - share;
    best[next] = share;
  }
  return best;
}

/// Twice the area of a triangle with corners of any dimension.
template <class Point>
double twice_area(const Point& a, const Point& b, const Point& c) {
  const double along = (b - a).dot(c - a);
  return std::sqrt(std::max(0.0, (b - a).squaredNorm() * (c - a).squaredNorm() - along * along));
}

double mean_edge(const IndexedMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    const Vec3& p = mesh.positions[a];
    sum += (mesh.positions[b] - p).norm() + (mesh.positions[c] - mesh.positions[b]).norm() +
           (p - mesh.positions[c]).norm();
  }
  return sum / (3 * static_cast<double>(mesh.faces.size()));
}

/// A surface and the values of its wedges.
class Sheet {
 public:
  Sheet(SurfaceAttribute attribute, const IndexedMesh& mesh)
      : attribute_(attribute), mesh_(mesh), tree_(mesh), values_(values_of(attribute, mesh)) {
    scale_ = attribute == SurfaceAttribute::texcoord ? texture_scale() / 4 : metrics::bounds(mesh).diagonal() / 100;
  }

  double edge() const { return mean_edge(mesh_); }
  /// How far a value is from that of the sheet near `position`. \param reach where to look, at most; model units
  double deviation_of(const Value& value, const Vec3& position, double reach, Index& hint) const;

 private:
  struct Nearest {
    double distance_sq = std::numeric_limits<double>::infinity();  ///< of position and value
    Value value;
  };

  double texture_scale() const;
  SheetPoint point(const Vec3& position, const Value& value) const {
    SheetPoint p;
    p << position - tree_.origin(), scale_ * value;
    return p;
  }
  void look_at(Index face, const SheetPoint& p, Nearest& nearest) const;

  SurfaceAttribute attribute_;
  const IndexedMesh& mesh_;
  metrics::TriangleTree tree_;
  std::vector<Value> values_;
  double scale_ = 0;  ///< s
};

/// The length on the surface of one unit in the texture; 0 if the texture has no area.
double Sheet::texture_scale() const {
  double area = 0;
  double in_texture = 0;
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
    const auto& [a, b, c] = mesh_.faces[f];
    area += twice_area(mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]);
    in_texture += twice_area(values_[mesh_.wedge(f, 0)], values_[mesh_.wedge(f, 1)], values_[mesh_.wedge(f, 2)]);
  }
  return in_texture > 0 ? std::sqrt(area / in_texture) : 0;
}

void Sheet::look_at(Index face, const SheetPoint& p, Nearest& nearest) const {
  SheetCorners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = point(mesh_.positions[mesh_.faces[face][k]], values_[mesh_.wedge(face, k)]);
  }
  const auto [x, y, z] = nearest_in(corners, p);
  const double distance_sq = (x * corners[0] + y * corners[1] + z * corners[2] - p).squaredNorm();
  if (!(distance_sq < nearest.distance_sq)) return;
  nearest.distance_sq = distance_sq;
  nearest.value =
      x * values_[mesh_.wedge(face, 0)] + y * values_[mesh_.wedge(face, 1)] + z * values_[mesh_.wedge(face, 2)];
}

double Sheet::deviation_of(const Value& value, const Vec3& position, double reach, Index& hint) const {
  const metrics::ClosestPoint closest = tree_.nearest(position, hint);
  hint = closest.face;
  const SheetPoint p = point(position, value);
  Nearest nearest;
  look_at(closest.face, p, nearest);
  const Vec3 local = position - tree_.origin();
  const double distance = std::sqrt(closest.distance_sq);
  // A face with a nearer point has a box that meets the cube, once that is as large as the nearest point is far.
  for (double half = distance + reach / 16; half <= distance + reach; half *= 2) {
    const double enough = std::min(half, std::sqrt(nearest.distance_sq));
    const Vec3 corner = Vec3::Constant(enough);
    tree_.visit_boxes({local - corner, local + corner}, [&](Index face) { look_at(face, p, nearest); });
    if (nearest.distance_sq <= half * half) break;
  }
  return deviation(attribute_, value, nearest.value);
}

/// 99 % of the area has less.
double usual_of(const std::vector<double>& deviations, const std::vector<double>& areas) {
  constexpr double share = 0.99;
  std::vector<Index> order(deviations.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return deviations[a] != deviations[b] ? deviations[a] < deviations[b] : a < b;
  });
  const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  double so_far = 0;
  for (const Index w : order) {
    so_far += areas[w];
    if (so_far >= share * total) return deviations[w];
  }
  return order.empty() ? 0 : deviations[order.back()];
}

}  // namespace

bool has_attribute(const IndexedMesh& mesh, SurfaceAttribute attribute) {
  switch (attribute) {
    case SurfaceAttribute::texcoord:
      return first_texcoord(mesh) != nullptr;
    case SurfaceAttribute::color:
      return !mesh.colors.empty();
    case SurfaceAttribute::normal:
      break;
  }
  return !mesh.normals.empty();
}

AttributeMap attribute_map(SurfaceAttribute attribute, const IndexedMesh& mesh, const IndexedMesh& other,
                           unsigned threads) {
  if (mesh.faces.empty() || other.faces.empty()) throw std::invalid_argument("attribute_map: a mesh has no faces");
  const Sheet sheet(attribute, other);
  const std::vector<Value> values = values_of(attribute, mesh);
  std::vector<Index> vertices(values.size(), invalid_index);
  std::vector<double> areas(values.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    const double area = twice_area(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    for (std::size_t k = 0; k < 3; ++k) {
      vertices[mesh.wedge(f, k)] = mesh.faces[f][k];
      areas[mesh.wedge(f, k)] += area;
    }
  }
  AttributeMap map{attribute, std::vector<double>(values.size()), 0, 0};
  const double reach = 4 * std::max(sheet.edge(), mean_edge(mesh));
  for_each_range(values.size(), threads, [&](std::size_t begin, std::size_t end) {
    Index hint = invalid_index;
    for (std::size_t w = begin; w < end; ++w) {
      if (vertices[w] == invalid_index) continue;
      map.deviations[w] = sheet.deviation_of(values[w], mesh.positions[vertices[w]], reach, hint);
    }
  });
  map.max = *std::max_element(map.deviations.begin(), map.deviations.end());
  map.usual = usual_of(map.deviations, areas);
  return map;
}

}  // namespace whittle::report
