#include "whittle/core/local_functions.hh"
#include "whittle/core/geometry/triangle.hh"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "whittle/core/detail/parallel.hh"

namespace whittle {
namespace {

/// Faces without area count for this share of a mean one, so that something lies around each wedge.
constexpr double least_area = 1e-9;
/// Variances below this share of the greatest are rounding errors, with a margin.
constexpr double least_variance = 1e-13;
/// Largest residual of a linear number, over its variation: files often round to three digits of the differences around
/// a vertex.
constexpr double most_left = 0.01;

/// Sums in one order, unlike library functions with wide registers.
double dot(const Vec3& a, const Vec3& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); }

std::vector<double> areas_of(const IndexedMesh& mesh, const Frame& frame, unsigned threads) {
  std::vector<double> areas(mesh.faces.size());
  for_each_range(areas.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      areas[f] = area_of(frame.to_frame(corners_of(mesh.positions, mesh.faces[f])));
  });
  double sum = 0;
  for (const double area : areas) sum += area;
  const double least = sum > 0 ? least_area * sum / static_cast<double>(areas.size()) : 1.0;
  for (double& area : areas) area += least;
  return areas;
}

}  // namespace

double LocalFunction::in_range(double number, const Vec3& position) const {
  const double linear = is_linear && !stays ? at(position) : mean;
  return std::clamp(number, std::min(low, linear), std::max(high, linear));
}

void LocalFunctions::Sums::add(double w, const Vec3& from_center, double number) {
  const double apart = number - first;
  weight += w;
  value += w * apart;
  square += w * apart * apart;
  moment += w * apart * from_center;
  low = std::min(low, number);
  high = std::max(high, number);
}

LocalFunctions::LocalFunctions(const IndexedMesh& input, const Frame& frame, std::span<const Index> wedge_map,
                               std::size_t n_wedges, unsigned threads)
    : input_(input), frame_(frame), wedge_map_(wedge_map), areas_(areas_of(input, frame, threads)), places_(n_wedges) {
  faces_of_ = detail::IndexLists<Index>(n_wedges, [&](const auto& emit) {
    for (Index f = 0; f < input.faces.size(); ++f) {
      std::array<Index, 3> of{};
      for (std::size_t k = 0; k < 3; ++k) of[k] = wedge_map[input.wedge(f, k)];
      for (std::size_t k = 0; k < 3; ++k) {
        const bool is_new = std::find(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(k), of[k]) ==
                            of.begin() + static_cast<std::ptrdiff_t>(k);
        if (of[k] != invalid_index && is_new) emit(of[k], f);
      }
    }
  });
  for_each_range(n_wedges, threads, [&](std::size_t begin, std::size_t end) {
    for (auto w = static_cast<Index>(begin); w < end; ++w) {
      if (any(w)) places_[w] = place_of(w);
    }
  });
}

LocalFunctions::Place LocalFunctions::place_of(Index w) const {
  const Vec3 first = frame_.to_frame(input_.positions[input_.faces[faces_of_.of(w).front()][0]]);
  double weight = 0;
  Vec3 sum = Vec3::Zero();
  const auto for_each_corner = [&](const auto& visit) {
    for (const Index f : faces_of_.of(w)) {
      for (const Index v : input_.faces[f]) visit(areas_[f] / 3, frame_.to_frame(input_.positions[v]) - first);
    }
  };
  for_each_corner([&](double area, const Vec3& p) {
    weight += area;
    sum += area * p;
  });
  const Vec3 mean = sum / weight;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for_each_corner([&](double area, const Vec3& p) {
    const Vec3 apart = p - mean;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) covariance(i, k) += area * apart[i] * apart[k];
    }
  });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance / weight);
  Place place{first + mean, solver.eigenvectors(), solver.eigenvalues()};
  const double least = least_variance * place.variance[2];
  for (int i = 0; i < 3; ++i) place.variance[i] = place.variance[i] > least ? place.variance[i] : 0;
  return place;
}

LocalFunction LocalFunctions::function_of(Index w, const Sums& sums) const {
  const Place& place = places_[w];
  const double mean = sums.value / sums.weight;
  const double variance = std::max(0.0, sums.square / sums.weight - mean * mean);
  LocalFunction function{place.center, sums.first + mean, Vec3::Zero(), sums.low, sums.high, false, false};
  Vec3 slopes = Vec3::Zero();
  Vec3 explained = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (!(place.variance[i] > 0)) continue;
    const double moment = dot(place.axes.col(i), sums.moment) / sums.weight;  // the center's moment is zero
    slopes[i] = moment / place.variance[i];
    explained[i] = moment * slopes[i];
  }
  const double left = std::max(0.0, variance - (explained[0] + explained[1] + explained[2]));
  const double noise = left / static_cast<double>(faces_of_.of(w).size());
  for (int i = 0; i < 3; ++i) {
    if (explained[i] > 0) function.slope += slopes[i] * (explained[i] / (explained[i] + noise)) * place.axes.col(i);
  }
  function.is_linear = left <= most_left * most_left * variance;
  return function;
}

}  // namespace whittle
