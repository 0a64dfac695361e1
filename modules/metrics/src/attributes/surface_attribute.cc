#include "attributes/surface_attribute.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/wedges.hh"

namespace whittle::metrics {

namespace {

bool is_unit_vector(AttributeKind kind) { return kind == AttributeKind::normal || kind == AttributeKind::tangent; }

std::vector<Index> first_equal_wedges(const IndexedMesh& mesh, const Attribute& attribute) {
  std::vector<Index> first(n_wedges(mesh));
  std::iota(first.begin(), first.end(), Index{0});
  if (mesh.wedges.empty()) return first;
  const detail::IndexLists<Index, std::size_t> wedges_of(mesh.positions.size(), [&](const auto& emit) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) emit(mesh.faces[f][k], mesh.wedge(f, k));
    }
  });
  const auto are_equal = [&](Index a, Index b) {
    const auto of_a = attribute.value(a), of_b = attribute.value(b);
    return std::equal(of_a.begin(), of_a.end(), of_b.begin());
  };
  std::vector<Index> distinct;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    distinct.clear();
    for (const Index w : wedges_of.of(v)) {
      const auto same = std::find_if(distinct.begin(), distinct.end(), [&](Index d) { return are_equal(d, w); });
      first[w] = same == distinct.end() ? w : *same;
      if (first[w] == w) distinct.push_back(w);
    }
  }
  return first;
}

double euclidean(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

double angle_deg(std::span<const double> a, std::span<const double> b) {
  const Vec3 u(a[0], a[1], a[2]), v(b[0], b[1], b[2]);
  return std::atan2(u.cross(v).norm(), u.dot(v)) * (180.0 / std::numbers::pi);
}

/// Half the sum of |a_j - b_j| over all joints j. \pre no joint has two weights above 0 in the same value
double joint_difference(std::span<const double> a, std::span<const double> b) {
  const std::size_t n_a = a.size() / 2, n_b = b.size() / 2;
  const auto weights_a = a.last(n_a), weights_b = b.last(n_b);
  double sum = std::accumulate(weights_a.begin(), weights_a.end(), 0.0);
  sum = std::accumulate(weights_b.begin(), weights_b.end(), sum);
  double common = 0;
  for (std::size_t i = 0; i < n_a; ++i) {
    for (std::size_t j = 0; j < n_b; ++j) common += a[i] == b[j] ? std::min(weights_a[i], weights_b[j]) : 0.0;
  }
  return std::max(0.0, 0.5 * sum - common);
}

}  // namespace

SurfaceAttribute::SurfaceAttribute(const IndexedMesh& mesh, const Attribute& attribute)
    : mesh_(mesh), attribute_(attribute), first_equal_(first_equal_wedges(mesh, attribute)) {}

std::size_t SurfaceAttribute::n_components() const {
  return attribute_.kind == AttributeKind::joint_weights ? 3 * attribute_.n_components : attribute_.n_components;
}

bool SurfaceAttribute::value(std::size_t face, const std::array<double, 3>& barycentric, AttributeBlend& blend,
                             std::span<double> to) const {
  for (std::size_t k = 0; k < 3; ++k) blend.add(attribute_.value(mesh_.wedge(face, k)), barycentric[k]);
  return blend.result(to);
}

double deviation(AttributeKind kind, std::span<const double> a, std::span<const double> b) {
  if (is_unit_vector(kind)) return angle_deg(a, b);
  if (kind == AttributeKind::joint_weights) return joint_difference(a, b);
  if (kind == AttributeKind::category) return std::equal(a.begin(), a.end(), b.begin()) ? 0.0 : 1.0;
  return euclidean(a, b);
}

}  // namespace whittle::metrics
