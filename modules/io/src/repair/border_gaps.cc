// Welding with a tolerance has two steps. First, border vertices that lie near each other are moved to one place. Then
// exact duplicates are welded, with all the care that this takes (weld.cc). Vertices that stay apart go back to their
// own places.
#include "whittle/io/border_gaps.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "repair/weld.hh"
#include "whittle/core/detail/drop.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/frame.hh"

namespace whittle::io {
namespace {

// Gaps are narrower than this share of the shortest edge beside them.
constexpr double narrow = 0.05;

struct PointCloud {
  std::vector<Vec3> points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(Index i, std::size_t axis) const { return points[i][static_cast<Eigen::Index>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointCloud, double, Index>,
                                                 PointCloud, 3, Index>;

// The vertices on open borders, and pairs of near ones. Lengths are in a frame.
class BorderVertices {
 public:
  struct Near {
    Index vertex;
    double distance;
  };

  explicit BorderVertices(const IndexedMesh& mesh)
      : faces_(mesh.faces), frame_(Frame::of_points(mesh.positions)), shortest_edge_(mesh.positions.size()) {
    const auto is_border = whittle::detail::border_vertices(mesh.faces, mesh.positions.size());
    for (std::size_t v = 0; v < is_border.size(); ++v) {
      if (is_border[v] == 0) continue;
      vertices_.push_back(static_cast<Index>(v));
      cloud_.points.push_back(frame_.to_frame(mesh.positions[v]));
    }
    if (vertices_.empty()) return;
    measure_edges(mesh);
    faces_at_ = whittle::detail::IndexLists<Index>(mesh.positions.size(), [&](const auto& emit) {
      for (std::size_t f = 0; f < faces_.size(); ++f) {
        for (const Index v : faces_[f]) {
          if (is_border[v] != 0) emit(v, static_cast<Index>(f));
        }
      }
    });
    tree_.emplace(3, cloud_);
  }

  const std::vector<Index>& all() const { return vertices_; }
  const Frame& frame() const { return frame_; }
  // The shortest edge with a length.
  double shortest_edge(Index v) const { return shortest_edge_[v]; }

  // The nearest other border vertices, the nearest first. \param i which of `all()`
  std::vector<Near> nearest(std::size_t i) const {
    std::array<Index, most_near> numbers{};
    std::array<double, most_near> squares{};
    const std::size_t n = tree_->knnSearch(cloud_.points[i].data(), most_near, numbers.data(), squares.data());
    std::vector<Near> near;
    for (std::size_t k = 0; k < n; ++k) {
      if (numbers[k] != i) near.push_back({vertices_[numbers[k]], std::sqrt(squares[k])});
    }
    return near;
  }

  // Whether some face at v has a corner with this property.
  template <class Predicate>
  bool has_beside(Index v, const Predicate& property) const {
    const std::span<const Index> faces = faces_at_.of(v);
    return std::any_of(faces.begin(), faces.end(), [&](Index f) {
      return std::any_of(faces_[f].begin(), faces_[f].end(), [&](Index w) { return w != v && property(w); });
    });
  }

 private:
  // More corners than meet at a vertex of almost any mesh.
  static constexpr std::size_t most_near = 24;

  void measure_edges(const IndexedMesh& mesh) {
    std::fill(shortest_edge_.begin(), shortest_edge_.end(), std::numeric_limits<double>::infinity());
    for (const Triangle& face : mesh.faces) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Index a = face[c];
        const Index b = face[(c + 1) % 3];
        const double length = (mesh.positions[a] - mesh.positions[b]).stableNorm() * frame_.scale;
        if (length == 0) continue;
        shortest_edge_[a] = std::min(shortest_edge_[a], length);
        shortest_edge_[b] = std::min(shortest_edge_[b], length);
      }
    }
  }

  const std::vector<Triangle>& faces_;
  Frame frame_;
  std::vector<double> shortest_edge_;
  std::vector<Index> vertices_;
  whittle::detail::IndexLists<Index> faces_at_;
  PointCloud cloud_;
  std::optional<Tree> tree_;
};

// For each vertex the one that it may be welded to, itself if none. These are themselves welded to none.
std::vector<Index> centers_of_clusters(const BorderVertices& border, const std::vector<Vec3>& positions,
                                       double tolerance) {
  std::vector<Index> center(positions.size());
  std::iota(center.begin(), center.end(), Index{0});
  const Frame& frame = border.frame();
  const double reach = tolerance * frame.scale;
  const auto is_near = [&](Index v, Index w) {
    const double distance = (positions[v] - positions[w]).stableNorm() * frame.scale;
    return distance <= reach && distance < std::min(border.shortest_edge(v), border.shortest_edge(w));
  };
  for (std::size_t i = 0; i < border.all().size(); ++i) {
    const Index v = border.all()[i];
    const double farthest = std::min(reach, border.shortest_edge(v));
    for (const auto& [near, distance] : border.nearest(i)) {
      if (distance > farthest * (1 + 1e-9)) break;
      if (near > v || !is_near(v, center[near])) continue;
      const Index cluster = center[near];
      if (border.has_beside(v, [&](Index w) { return center[w] == cluster; })) continue;
      center[v] = cluster;
      break;
    }
  }
  return center;
}

}  // namespace

BorderGaps find_border_gaps(const IndexedMesh& mesh) {
  BorderGaps gaps;
  const BorderVertices border(mesh);
  for (std::size_t i = 0; i < border.all().size(); ++i) {
    const Index v = border.all()[i];
    for (const auto& [near, distance] : border.nearest(i)) {
      if (distance >= narrow * border.shortest_edge(v) || distance == 0) break;
      if (distance >= narrow * border.shortest_edge(near)) continue;
      if (border.has_beside(v, [near = near](Index w) { return w == near; })) continue;
      ++gaps.n_vertices;
      gaps.widest = std::max(gaps.widest, distance * border.frame().unscale);
      break;
    }
  }
  return gaps;
}

Repairs weld_gaps(IndexedMesh& mesh, double tolerance, std::vector<Index>* vertex_map, unsigned threads) {
  if (!(tolerance >= 0) || std::isinf(tolerance)) throw std::invalid_argument("tolerance is negative or not finite");
  const std::vector<Vec3> own = mesh.positions;
  const std::vector<Index> center = centers_of_clusters(BorderVertices(mesh), own, tolerance);
  for (std::size_t v = 0; v < own.size(); ++v) mesh.positions[v] = own[center[v]];
  std::vector<Index> joined_to;
  Repairs done = weld_borders_without_copies(mesh, &joined_to, threads);
  mesh.positions = own;
  std::vector<Index> renumbered = tidy_after_welding(mesh, done, threads);
  if (vertex_map == nullptr) return done;
  vertex_map->resize(own.size());
  for (std::size_t v = 0; v < own.size(); ++v) (*vertex_map)[v] = renumbered[joined_to.empty() ? v : joined_to[v]];
  return done;
}

}  // namespace whittle::io
