#include "whittle/report/distance_map.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle::report {
namespace {

constexpr int most_rounds = 8;  ///< an edge becomes at most 256

/// A face that may be cut. Edges that are found not to need it are settled: the face beyond may be done with.
struct OpenFace {
  Triangle corners;
  std::uint8_t settled = 0;  ///< bit k: the edge from corner k on
};

/// The parts of a face that is cut. \param middle vertices on the edges from each corner on; `invalid_index` where
/// there is no cut. At least one is there
std::vector<OpenFace> parts_of(const OpenFace& face, const std::array<Index, 3>& middle) {
  const auto n_cut = std::count_if(middle.begin(), middle.end(), [](Index m) { return m != invalid_index; });
  // The first corner is one from which the cut edges come first.
  std::size_t i = 0;
  if (n_cut == 1) {
    while (middle[i] == invalid_index) ++i;
  } else if (n_cut == 2) {
    while (middle[(i + 2) % 3] != invalid_index) ++i;
  }
  const auto [a, b, c] = Triangle{face.corners[i], face.corners[(i + 1) % 3], face.corners[(i + 2) % 3]};
  const auto [ab, bc, ca] = Triangle{middle[i], middle[(i + 1) % 3], middle[(i + 2) % 3]};
  if (n_cut == 1) return {{{a, ab, c}, 0b100}, {{ab, b, c}, 0b010}};
  if (n_cut == 2) return {{{ab, b, bc}, 0}, {{a, ab, bc}, 0}, {{a, bc, c}, 0b100}};
  return {{{a, ab, ca}, 0}, {{ab, b, bc}, 0}, {{bc, c, ca}, 0}, {{ab, bc, ca}, 0}};
}

/// Calls `visit(vertex, area)` for each corner of each face, with a third of its area.
template <class Visit>
void for_each_third(const IndexedMesh& mesh, const Visit& visit) {
  for (const Triangle& face : mesh.faces) {
    const double third = area_of(mesh.positions, face) / 3;
    for (const Index v : face) visit(v, third);
  }
}

/// The greatest distance if there is no area.
double usual_distance(const DistanceMap& map) {
  constexpr std::size_t n_parts = 4096;
  constexpr double share = 0.99;
  const std::vector<double> shares = distance_histogram(map, map.max, n_parts);
  double so_far = 0;
  for (std::size_t i = 0; i < n_parts; ++i) {
    so_far += shares[i];
    if (so_far >= share) return map.max * static_cast<double>(i + 1) / static_cast<double>(n_parts);
  }
  return map.max;
}

/// Per vertex, the normal of its faces, weighted by area.
std::vector<Vec3> vertex_normals(const IndexedMesh& mesh) {
  std::vector<Vec3> normals(mesh.positions.size(), Vec3::Zero());
  for (const Triangle& face : mesh.faces) {
    const Vec3 normal = area_normal(mesh.positions, face);
    for (const Index v : face) normals[v] += normal;
  }
  return normals;
}

/// Points of a surface, and which way is in front of it there.
struct SurfacePoints {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;

  void add(const Vec3& position, const Vec3& normal) {
    positions.push_back(position);
    normals.push_back(normal);
  }
};

class DistanceMapper {
 public:
  DistanceMapper(const IndexedMesh& mesh, const TriangleTree& other, const DistanceMapOptions& options)
      : other_(other), options_(options), normals_(vertex_normals(mesh)) {
    map_.mesh.positions = mesh.positions;
    map_.mesh.faces = mesh.faces;
    for (const Triangle& face : mesh.faces) open_.push_back({face});
  }

  DistanceMap run();

 private:
  std::vector<double> signed_distances_of(const SurfacePoints& points) const;
  /// Error of an interpolated distance, in the unit of the tolerance.
  double deviation(double exact, double interpolated) const {
    const double distance = std::abs(exact);
    const double size = std::max(map_.usual, std::min(distance, std::abs(interpolated)));
    return size > 0 ? std::abs(distance - std::abs(interpolated)) / size : 0;
  }
  unsigned n_points_along(const Triangle& face) const;
  std::vector<double> face_deviations() const;
  double tolerance_for(std::vector<double> deviations) const;
  void cut_edges(const detail::EdgeTable& edges);
  bool cut();
  void make_parts();
  double usual_deviation() const;

  const TriangleTree& other_;
  const DistanceMapOptions& options_;
  DistanceMap map_;
  std::vector<Vec3> normals_;  ///< of the vertices, not of unit length
  std::vector<OpenFace> open_;
  std::vector<Index> middle_;  ///< 3 an open face: vertex on each edge, or `invalid_index`
};

std::vector<double> DistanceMapper::signed_distances_of(const SurfacePoints& points) const {
  std::vector<double> distances(points.positions.size());
  for_each_range(distances.size(), options_.threads, [&](std::size_t begin, std::size_t end) {
    Index hint = invalid_index;
    for (std::size_t i = begin; i < end; ++i) {
      const ClosestPoint closest = other_.nearest(points.positions[i], hint);
      hint = closest.face;
      const bool is_behind = (closest.point - points.positions[i]).dot(points.normals[i]) < 0;
      distances[i] = is_behind ? -std::sqrt(closest.distance_sq) : std::sqrt(closest.distance_sq);
    }
  });
  return distances;
}

/// Number of sample points along each edge of a face.
unsigned DistanceMapper::n_points_along(const Triangle& face) const {
  constexpr double most = 8;
  double longest_sq = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    longest_sq =
        std::max(longest_sq, (map_.mesh.positions[face[k]] - map_.mesh.positions[face[(k + 1) % 3]]).squaredNorm());
  }
  return static_cast<unsigned>(std::clamp(std::sqrt(longest_sq) / options_.spacing, 1.0, most));
}

/// The greatest one inside of each open face.
std::vector<double> DistanceMapper::face_deviations() const {
  SurfacePoints points;
  std::vector<double> interpolated;
  std::vector<std::size_t> first{0};
  for (const OpenFace& face : open_) {
    const unsigned n = n_points_along(face.corners);
    if (n == 1) {  // the middles of its edges say enough
      first.push_back(interpolated.size());
      continue;
    }
    for (unsigned i = 0; i < n; ++i) {
      for (unsigned k = 0; i + k < n; ++k) {
        const double u = (i + 1.0 / 3) / n;
        const double v = (k + 1.0 / 3) / n;
        const auto at = [&, w = 1 - u - v](const auto& of_vertex) {
          return (w * of_vertex[face.corners[0]] + u * of_vertex[face.corners[1]] + v * of_vertex[face.corners[2]]);
        };
        points.add(Vec3(at(map_.mesh.positions)), Vec3(at(normals_)));
        interpolated.push_back(at(map_.signed_distances));
      }
    }
    first.push_back(interpolated.size());
  }
  const std::vector<double> distances = signed_distances_of(points);
  std::vector<double> greatest(open_.size(), 0);
  for (std::size_t f = 0; f < open_.size(); ++f) {
    for (std::size_t i = first[f]; i < first[f + 1]; ++i) {
      greatest[f] = std::max(greatest[f], deviation(distances[i], interpolated[i]));
    }
  }
  return greatest;
}

/// The tolerance of this round: cuts leave half of the room for later rounds. \param deviations of the edges
double DistanceMapper::tolerance_for(std::vector<double> deviations) const {
  const std::size_t n_faces = map_.mesh.faces.size() + open_.size();
  const std::size_t room = options_.most_faces > n_faces ? options_.most_faces - n_faces : 0;
  const std::size_t most_cut = room / 4;  // an edge that is cut makes two faces more
  double tolerance = options_.tolerance;
  if (most_cut < deviations.size()) {
    const auto last = deviations.begin() + static_cast<std::ptrdiff_t>(most_cut);
    std::nth_element(deviations.begin(), last, deviations.end(), std::greater<>());
    tolerance = std::max(tolerance, *last);
  }
  return tolerance;
}

/// Finds the middles of the edges that are to be cut, and makes them vertices, in the order of the faces.
void DistanceMapper::cut_edges(const detail::EdgeTable& edges) {
  const auto is_settled = [this](Index side) { return (open_[detail::face_of(side)].settled >> side % 3 & 1U) != 0; };
  std::vector<std::size_t> tested;
  SurfacePoints middles;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::span<const Index> sides = edges.sides(e);
    if (std::any_of(sides.begin(), sides.end(), is_settled)) continue;
    tested.push_back(e);
    const auto& [a, b] = edges[e];
    middles.add(0.5 * (map_.mesh.positions[a] + map_.mesh.positions[b]), 0.5 * (normals_[a] + normals_[b]));
  }
  const std::vector<double> distances = signed_distances_of(middles);
  const std::vector<double> of_faces = face_deviations();
  std::vector<double> deviations(tested.size());
  for (std::size_t i = 0; i < tested.size(); ++i) {
    const auto& [a, b] = edges[tested[i]];
    deviations[i] = deviation(distances[i], 0.5 * (map_.signed_distances[a] + map_.signed_distances[b]));
    for (const Index side : edges.sides(tested[i])) {
      deviations[i] = std::max(deviations[i], of_faces[detail::face_of(side)]);
    }
  }
  const double tolerance = tolerance_for(deviations);
  std::vector<Index> test_of(3 * open_.size(), invalid_index);  // of each side that is to be cut
  for (std::size_t i = 0; i < tested.size(); ++i) {
    if (deviations[i] <= tolerance) continue;
    for (const Index side : edges.sides(tested[i])) test_of[side] = static_cast<Index>(i);
  }
  std::vector<Index> vertex_of(tested.size(), invalid_index);
  middle_.assign(3 * open_.size(), invalid_index);
  for (std::size_t side = 0; side < test_of.size(); ++side) {
    if (test_of[side] == invalid_index) continue;
    Index& vertex = vertex_of[test_of[side]];
    if (vertex == invalid_index) {
      vertex = static_cast<Index>(map_.mesh.positions.size());
      map_.mesh.positions.push_back(middles.positions[test_of[side]]);
      normals_.push_back(middles.normals[test_of[side]]);
      map_.signed_distances.push_back(distances[test_of[side]]);
      map_.max = std::max(map_.max, std::abs(map_.signed_distances.back()));
    }
    middle_[side] = vertex;
  }
}

void DistanceMapper::make_parts() {
  std::vector<OpenFace> parts;
  std::vector<std::uint8_t>& cuts = map_.rounds.emplace_back();
  for (std::size_t f = 0; f < open_.size(); ++f) {
    const std::array<Index, 3> middle{middle_[3 * f], middle_[3 * f + 1], middle_[3 * f + 2]};
    unsigned cut = 0;
    for (unsigned k = 0; k < 3; ++k) cut |= unsigned{middle[k] != invalid_index} << k;
    cuts.push_back(static_cast<std::uint8_t>(cut));
    if (cut == 0) {
      map_.mesh.faces.push_back(open_[f].corners);
      continue;
    }
    const std::vector<OpenFace> of_face = parts_of(open_[f], middle);
    parts.insert(parts.end(), of_face.begin(), of_face.end());
  }
  open_ = std::move(parts);
}

/// \return whether there are faces that may be cut again
bool DistanceMapper::cut() {
  std::vector<Triangle> faces;
  for (const OpenFace& face : open_) faces.push_back(face.corners);
  cut_edges(detail::EdgeTable(faces, map_.mesh.positions.size()));
  make_parts();
  return !open_.empty();
}

/// The deviation at the middles of some faces.
double DistanceMapper::usual_deviation() const {
  constexpr std::size_t n_looked_at = 20'000;
  constexpr double share = 0.95;
  SurfacePoints points;
  std::vector<std::pair<double, double>> found;  // the interpolated distance, then the deviation; the area
  const IndexedMesh& mesh = map_.mesh;
  const std::size_t step = std::max<std::size_t>(1, mesh.faces.size() / n_looked_at);
  double total = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); f += step) {
    const auto& [a, b, c] = mesh.faces[f];
    const auto& [p, q, r] = std::tie(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    points.add((p + q + r) / 3, normals_[a] + normals_[b] + normals_[c]);
    found.emplace_back((map_.signed_distances[a] + map_.signed_distances[b] + map_.signed_distances[c]) / 3,
                       area_of(mesh.positions, mesh.faces[f]));
    total += found.back().second;
  }
  const std::vector<double> distances = signed_distances_of(points);
  for (std::size_t i = 0; i < found.size(); ++i) found[i].first = deviation(distances[i], found[i].first);
  std::sort(found.begin(), found.end());
  double so_far = 0;
  for (const auto& [deviation, area] : found) {
    so_far += area;
    if (so_far >= share * total) return deviation;
  }
  return 0;
}

DistanceMap DistanceMapper::run() {
  map_.signed_distances = signed_distances_of({map_.mesh.positions, normals_});
  for (const OpenFace& face : open_) {
    for (const Index v : face.corners) map_.max = std::max(map_.max, std::abs(map_.signed_distances[v]));
  }
  map_.usual = usual_distance(map_);
  map_.mesh.faces.clear();
  for (int round = 0; round < most_rounds && cut(); ++round) {
  }
  for (const OpenFace& face : open_) map_.mesh.faces.push_back(face.corners);
  map_.usual = usual_distance(map_);
  map_.deviation = usual_deviation();
  return std::move(map_);
}

}  // namespace

DistanceMap distance_map(const IndexedMesh& mesh, const TriangleTree& other, const DistanceMapOptions& options) {
  if (mesh.faces.empty()) throw std::invalid_argument("distance_map: the mesh has no faces");
  if (!(options.tolerance > 0 && options.tolerance <= 1)) {
    throw std::invalid_argument("distance_map: the tolerance is not in (0, 1]");
  }
  if (!(options.spacing > 0)) throw std::invalid_argument("distance_map: the spacing is not above 0");
  return DistanceMapper(mesh, other, options).run();
}

std::vector<double> distance_histogram(const DistanceMap& map, double max, std::size_t n) {
  std::vector<double> shares(n, 0.0);
  double total = 0;
  for_each_third(map.mesh, [&](Index v, double area) {
    const double at = max > 0 ? std::abs(map.signed_distances[v]) / max * static_cast<double>(n) : 0;
    shares[std::min(n - 1, static_cast<std::size_t>(at))] += area;
    total += area;
  });
  for (double& share : shares) share = total > 0 ? share / total : 0;
  return shares;
}

}  // namespace whittle::report
