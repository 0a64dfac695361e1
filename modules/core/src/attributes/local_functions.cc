#include "whittle/core/local_functions.hh"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/symmetric_matrix.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/wedges.hh"

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

double LocalFunction::gain(const Vec3& way) const {
  const double most = holds ? std::numeric_limits<double>::infinity() : 0.25 * (high - low);
  return std::clamp(slope.dot(way), -most, most);
}

double LocalFunction::in_range(double number, const Vec3& position) const {
  const double own = holds ? at(position) : mean;
  return std::clamp(number, std::min(low, own), std::max(high, own));
}

LocalFunctions::LocalFunctions(const IndexedMesh& input, const Frame& frame, std::span<const Index> wedge_map,
                               std::size_t n_wedges, unsigned threads)
    : input_(input), frame_(frame), wedge_map_(wedge_map), places_(n_wedges) {
  const std::vector<double> areas = areas_of(input, frame, threads);
  const detail::IndexLists<Index> faces_of(n_wedges, [&](const auto& emit) {
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
    std::vector<Index> places_of(::whittle::n_wedges(input));
    for (auto w = static_cast<Index>(begin); w < end; ++w) {
      const std::span<const Index> faces = faces_of.of(w);
      if (faces.empty()) continue;
      places_[w].n_faces = faces.size();
      places_[w].corners = corners_of_faces(faces, areas, places_of);
      find_axes(places_[w]);
    }
  });
}

/// Each wedge once. \param places_of scratch, as long as the input has wedges
std::vector<LocalFunctions::Corner> LocalFunctions::corners_of_faces(std::span<const Index> faces,
                                                                     std::span<const double> areas,
                                                                     std::span<Index> places_of) const {
  std::vector<Corner> corners;
  for (const Index f : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index w = input_.wedge(f, k);
      Index& place = places_of[w];
      const bool is_new = place >= corners.size() || corners[place].wedge != w;
      if (is_new) {
        place = static_cast<Index>(corners.size());
        corners.push_back({w, input_.faces[f][k], 0});
      }
      corners[place].weight += areas[f] / 3;
    }
  }
  return corners;
}

void LocalFunctions::find_axes(Place& place) const {
  const Vec3 first = position_of(place.corners.front());
  double weight = 0;
  Vec3 sum = Vec3::Zero();
  for (const Corner& corner : place.corners) {
    weight += corner.weight;
    sum += corner.weight * (position_of(corner) - first);
  }
  const Vec3 mean = sum / weight;
  SymmetricMatrix moments;
  for (const Corner& corner : place.corners) {
    moments += SymmetricMatrix::outer(position_of(corner) - first - mean, corner.weight);
  }
  Eigen::Matrix3d covariance;
  covariance << moments.xx, moments.xy, moments.xz, moments.xy, moments.yy, moments.yz, moments.xz, moments.yz,
      moments.zz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance / weight);
  place.center = first + mean;
  place.axes = solver.eigenvectors();
  place.variance = solver.eigenvalues();
  const double least = least_variance * place.variance[2];
  for (int i = 0; i < 3; ++i) place.variance[i] = place.variance[i] > least ? place.variance[i] : 0;
}

LocalFunction LocalFunctions::function_of(const Place& place, const Sums& sums) {
  const double mean = sums.value / sums.weight;
  const double variance = std::max(0.0, sums.square / sums.weight - mean * mean);
  LocalFunction function{place.center, sums.first + mean, Vec3::Zero(), sums.low, sums.high};
  Vec3 slopes = Vec3::Zero();
  Vec3 explained = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (!(place.variance[i] > 0)) continue;
    const double moment = dot(place.axes.col(i), sums.moment) / sums.weight;  // the center's moment is zero
    slopes[i] = moment / place.variance[i];
    explained[i] = moment * slopes[i];
  }
  const double left = std::max(0.0, variance - (explained[0] + explained[1] + explained[2]));
  const double noise = left / static_cast<double>(place.n_faces);
  for (int i = 0; i < 3; ++i) {
    if (explained[i] > 0) function.slope += slopes[i] * (explained[i] / (explained[i] + noise)) * place.axes.col(i);
  }
  function.is_linear = left <= most_left * most_left * variance;
  return function;
}

}  // namespace whittle
