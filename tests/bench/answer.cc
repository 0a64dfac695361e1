#include "bench/answer.hh"

#include <algorithm>
#include <cmath>

#include "whittle/metrics/distance.hh"

namespace whittle::bench {
namespace {

/// meshoptimizer stops within a pass of its goal, not exactly at it. A decimater that got stuck stops far above it.
constexpr double face_tolerance = 0.01;

/// Allowed mean error, as a share of the edge of a square as large as a face of the result. If all vertices lie on the
/// surface, the error is the sagitta of such an edge, a small part of it. A hole or a spike gives more.
constexpr double error_tolerance = 0.25;

double area_of(const IndexedMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    const Vec3& p = mesh.positions[a];
    sum += 0.5 * (mesh.positions[b] - p).cross(mesh.positions[c] - p).norm();
  }
  return sum;
}

std::string count_problem(const Question& question, std::size_t n_faces) {
  const auto wanted = static_cast<double>(question.n_faces);
  const double allowed = std::max(2.0, face_tolerance * wanted);
  if (std::abs(static_cast<double>(n_faces) - wanted) <= allowed) return {};
  return std::to_string(n_faces) + " faces instead of " + std::to_string(question.n_faces);
}

std::string topology_defect(const metrics::Topology& before, const metrics::Topology& after) {
  if (!before.manifold) return {};
  if (!after.manifold) return "not manifold";
  if (before.oriented && !after.oriented) return "not oriented";
  if (before.components != after.components) return "other parts: " + std::to_string(after.components);
  if (before.boundary_loops != after.boundary_loops) return "other borders: " + std::to_string(after.boundary_loops);
  if (before.euler != after.euler) return "other Euler number: " + std::to_string(after.euler);
  return {};
}

std::string error_problem(const Question& question, double mean_error) {
  const double face_size = std::sqrt(question.area / static_cast<double>(question.n_faces));
  return mean_error <= error_tolerance * face_size ? std::string() : "far from the surface";
}

}  // namespace

Question make_question(const IndexedMesh& input, std::size_t n_faces, std::size_t n_samples) {
  return {input, metrics::topology(input), area_of(input), n_faces, n_samples};
}

Answer judged(const Question& question, const IndexedMesh& mesh) {
  Answer answer;
  answer.n_faces = mesh.faces.size();
  if (mesh.faces.empty()) {
    answer.problem = "no faces";
    return answer;
  }
  const metrics::Topology topology = metrics::topology(mesh);
  answer.is_manifold = topology.manifold;
  answer.problem = count_problem(question, mesh.faces.size());
  answer.defect = topology_defect(question.topology, topology);
  if (question.n_samples == 0) return answer;
  const metrics::SurfaceDistance distance =
      metrics::surface_distance(question.input, mesh, {.samples = question.n_samples});
  answer.mean_error_rel = distance.mean / distance.diagonal;
  answer.max_error_rel = distance.max / distance.diagonal;
  if (answer.problem.empty()) answer.problem = error_problem(question, distance.mean);
  return answer;
}

}  // namespace whittle::bench
