#include "whittle/core/transform.hh"

#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "whittle/core/detail/portable_math.hh"

namespace whittle {
namespace {

/// The three numbers from the first on, moved by a matrix.
void multiply(const Eigen::Matrix3d& matrix, std::span<double> value) {
  Eigen::Map<Vec3> vector(value.data());
  vector = (matrix * vector).eval();
}

void multiply_and_normalize(const Eigen::Matrix3d& matrix, std::span<double> value) {
  multiply(matrix, value);
  Eigen::Map<Vec3>(value.data()).stableNormalize();
}

/// The matrices of an affine map for all that is not a position.
struct Turns {
  explicit Turns(const Eigen::Affine3d& map) : linear(map.linear()), mirrors(linear.determinant() < 0) {
    // The cofactors are the inverse's transpose times the determinant, and there is no division in them.
    for (Eigen::Index i = 0; i < 3; ++i) {
      of_normals.col(i) = linear.col((i + 1) % 3).cross(linear.col((i + 2) % 3)) * (mirrors ? -1 : 1);
    }
    const double volume = std::abs(linear.determinant());
    of_directions = of_normals * (volume > 0 ? 1 / detail::power(volume, 2.0 / 3) : 0);
  }

  void apply_to(std::array<float, 3>& normal) const {
    const Vec3 turned = (of_normals * Vec3(normal[0], normal[1], normal[2])).stableNormalized();
    for (Eigen::Index i = 0; i < 3; ++i) normal[static_cast<std::size_t>(i)] = static_cast<float>(turned[i]);
  }

  void apply_to(Attribute& attribute) const {
    for (std::size_t i = 0; i < attribute.size(); ++i) apply_to(attribute.kind, attribute.value(i));
  }

  void apply_to(AttributeKind kind, std::span<double> value) const {
    switch (kind) {
      case AttributeKind::normal:
        return multiply_and_normalize(of_normals, value);
      case AttributeKind::tangent:
        multiply_and_normalize(linear, value);
        if (mirrors) value[3] = -value[3];
        return;
      case AttributeKind::displacement:
        return multiply(linear, value);
      case AttributeKind::direction:
        return multiply(of_directions, value);
      default:
        return;
    }
  }

  Eigen::Matrix3d linear, of_normals;
  Eigen::Matrix3d of_directions;  ///< as long as the normals that they are added to, unit ones
  bool mirrors;
};

void turn_faces_over(IndexedMesh& mesh) {
  for (Triangle& face : mesh.faces) std::swap(face[1], face[2]);
  for (std::size_t corner = 0; corner < mesh.wedges.size(); corner += 3) {
    std::swap(mesh.wedges[corner + 1], mesh.wedges[corner + 2]);
  }
}

}  // namespace

void transform_mesh(IndexedMesh& mesh, const Eigen::Affine3d& map) {
  if (map.matrix().isIdentity(0)) return;
  const Turns turns(map);
  for (Vec3& p : mesh.positions) p = (map * p).eval();
  for (auto& normal : mesh.normals) turns.apply_to(normal);
  for (Attribute& attribute : mesh.attributes) turns.apply_to(attribute);
  if (turns.mirrors) turn_faces_over(mesh);
}

}  // namespace whittle
