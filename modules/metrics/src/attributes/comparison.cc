#include "attributes/comparison.hh"

#include <Eigen/Geometry>
#include <tuple>

#include "whittle/core/geometry/segment.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle::metrics {

namespace {

template <class Value>
Attribute copied(const char* name, AttributeKind kind, const std::vector<Value>& values) {
  Attribute attribute{.name = name, .kind = kind, .n_components = std::tuple_size_v<Value>, .values = {}};
  attribute.values.reserve(values.size() * attribute.n_components);
  for (const Value& value : values) attribute.values.insert(attribute.values.end(), value.begin(), value.end());
  return attribute;
}

bool are_numbers(AttributeKind kind) { return kind == AttributeKind::scalar || kind == AttributeKind::category; }

/// Numbers of one name are compared as the reference has them: categories that were blended are none any more.
bool are_comparable(const Attribute& a, const Attribute& b) {
  return a.name == b.name && (a.kind == b.kind || (are_numbers(a.kind) && are_numbers(b.kind))) &&
         (a.n_components == b.n_components || a.kind == AttributeKind::joint_weights);
}

}  // namespace

std::vector<Shared> shared_attributes(const IndexedMesh& reference, const IndexedMesh& test,
                                      std::deque<Attribute>& copies) {
  std::vector<Shared> shared;
  const auto add_copies = [&](const char* name, AttributeKind kind, const auto& of_reference, const auto& of_test) {
    if (of_reference.empty() || of_test.empty()) return;
    const Attribute& first = copies.emplace_back(copied(name, kind, of_reference));
    shared.push_back({&first, &copies.emplace_back(copied(name, kind, of_test))});
  };
  add_copies("NORMAL", AttributeKind::normal, reference.normals, test.normals);
  add_copies("COLOR_0", AttributeKind::color, reference.colors, test.colors);
  for (const Attribute& attribute : reference.attributes) {
    const auto other = std::find_if(test.attributes.begin(), test.attributes.end(),
                                    [&](const Attribute& a) { return are_comparable(attribute, a); });
    if (other != test.attributes.end()) shared.push_back({&attribute, &*other});
  }
  return shared;
}

std::array<double, 3> barycentric(const std::array<Vec3, 3>& corners, const Vec3& point) {
  const auto& [a, b, c] = corners;
  const Vec3 normal = trusted_normal(a, b, c);
  std::array<double, 3> weights{};
  if (normal.isZero(0.0)) {
    std::size_t from = 0;
    for (const std::size_t k : {1U, 2U}) {
      if ((corners[(k + 1) % 3] - corners[k]).squaredNorm() > (corners[(from + 1) % 3] - corners[from]).squaredNorm()) {
        from = k;
      }
    }
    const double t = nearest_share(point, corners[from], corners[(from + 1) % 3]);
    weights[from] = 1.0 - t;
    weights[(from + 1) % 3] = t;
    return weights;
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &next = corners[(k + 1) % 3], &last = corners[(k + 2) % 3];
    weights[k] = std::max(0.0, normal.dot((last - next).cross(point - next)));
    sum += weights[k];
  }
  if (!(sum > 0.0)) return {1.0, 0.0, 0.0};
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace whittle::metrics
