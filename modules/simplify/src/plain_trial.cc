#include "plain_trial.hh"

#include <algorithm>
#include <vector>

#include "whittle/core/geometry/symmetric_matrix.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle {
namespace {

constexpr std::size_t small = 20'000;  // faces
constexpr std::size_t most_faces = 100'000;
constexpr double most_bent = 0.5;
constexpr double bent_per_vertex_left = 4;

/// \param normals Σ n nᵀ over the unit normals of a vertex' faces. The determinant over the sum of the minors is the
/// least eigenvalue, if it is small
bool is_bent(const SymmetricMatrix& normals) {
  constexpr double least_angle = 0.01;
  const auto& [xx, xy, xz, yy, yz, zz] = normals;
  const double minors = xx * yy - xy * xy + yy * zz - yz * yz + xx * zz - xz * xz;
  const double determinant = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  return determinant > least_angle * least_angle * normals.trace() * minors;
}

/// [0, 1]
double bent_share(const IndexedMesh& mesh) {
  std::vector<SymmetricMatrix> normals(mesh.positions.size());
  for (const Triangle& face : mesh.faces) {
    const Vec3 normal = area_normal(mesh.positions, face).stableNormalized();
    for (const Index v : face) normals[v] += SymmetricMatrix::outer(normal, 1);
  }
  const auto n_bent = std::count_if(normals.begin(), normals.end(), is_bent);
  return normals.empty() ? 0 : static_cast<double>(n_bent) / static_cast<double>(normals.size());
}

}  // namespace

bool is_worth_plain_quadrics(const IndexedMesh& mesh, const DecimateTarget& target) {
  if (mesh.faces.empty() || mesh.faces.size() > most_faces || target.cost_limit() || target.error_limit()) return false;
  if (mesh.faces.size() <= small) return true;
  const double bent = bent_share(mesh);
  return bent <= most_bent && bent <= bent_per_vertex_left * target.share_of(mesh.faces.size(), mesh.positions.size());
}

}  // namespace whittle
