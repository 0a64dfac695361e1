#pragma once

#include <span>
#include <vector>

#include "surface/foot_finder.hh"
#include "whittle/core/detail/item_groups.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::polishing {

/// Points that represent a surface, and their feet on another surface. The points are the vertices, and one or four
/// points in each face. Their weights add up to the area; vertices have a quarter of it. Where a function is linear on
/// a face, its weighted sum over the face's points is its integral. With one point a face, the same holds for its
/// square.
class SurfaceSamples {
 public:
  /// Keeps references to the faces and the map.
  /// \param vertex_map as `polish` has it \param per_face 1 or 4
  /// \throw Cancelled
  SurfaceSamples(const IndexedMesh& surface, std::span<const Index> vertex_map, const Frame& frame,
                 std::size_t per_face, const detail::Workers& workers);

  std::span<const Vec3> positions() const { return positions_; }  ///< the vertices', in the frame
  /// Of a vertex: the sum of its faces' normals, each as long as twice the face's area.
  Eigen::Vector3f normal(Index v) const { return normals_and_areas_[v].head<3>(); }
  /// Of a vertex: a third of the area of its faces.
  float area(Index v) const { return normals_and_areas_[v].w(); }

  /// \throw Cancelled
  void find_feet(const FootFinder& finder, const detail::Workers& workers);

  /// Number of points: the vertices come first, then the points in faces.
  std::size_t size() const { return feet_.size(); }
  Vec3 position(std::size_t i) const;
  double weight(std::size_t i) const {
    return i < n_vertices() ? 0.25 * normals_and_areas_[i].w() : weight_in_face((i - n_vertices()) / per_face_);
  }
  const Foot& foot(std::size_t i) const { return feet_[i]; }
  void set_foot(std::size_t i, const Foot& foot) { feet_[i] = foot; }

  /// Calls `use(foot, weight)` for each point that has a foot, on all threads. The calls for one face of the other
  /// surface come one after the other, always in the same order.
  /// \param n_faces of the other surface
  /// \throw Cancelled
  template <class Use>
  void for_each_foot(std::size_t n_faces, const detail::Workers& workers, const Use& use) const {
    if (n_threads(workers.threads) == 1) {
      for_each_foot_in_turn(workers, use);
      return;
    }
    const std::size_t faces_per_group = std::max<std::size_t>(1024, n_faces / 1024);
    const detail::ItemGroups groups(size(), n_faces / faces_per_group + 1, workers.threads,
                                    [&](Index i, const auto& add_to) {
                                      if (feet_[i].face != invalid_index) add_to(feet_[i].face / faces_per_group);
                                    });
    for_each_block(groups.size(), workers, [&](std::size_t group) {
      for (const Index i : groups.of(group)) use(feet_[i], weight(i));
    });
  }

 private:
  template <class Use>
  void for_each_foot_in_turn(const detail::Workers& workers, const Use& use) const {
    constexpr std::size_t check_mask = (std::size_t{1} << 16) - 1;  // some milliseconds from check to check
    const auto use_if_there = [&](const Foot& foot, double weight) {
      if (foot.face != invalid_index) use(foot, weight);
    };
    for (std::size_t v = 0; v < n_vertices(); ++v) {
      if ((v & check_mask) == 0) workers.update(0);
      use_if_there(feet_[v], weight(v));
    }
    std::size_t i = n_vertices();
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if ((f & check_mask) == 0) workers.update(0);
      const double weight = weight_in_face(f);
      for (const std::size_t end = i + per_face_; i < end; ++i) use_if_there(feet_[i], weight);
    }
  }

  std::size_t n_vertices() const { return positions_.size(); }
  template <class PerVertex>
  void prefetch_corners(std::size_t f, const PerVertex& more) const;
  void measure(const detail::Workers& workers);
  Vec3 point_in_face(const Triangle& face, std::size_t i) const;
  double weight_in_face(std::size_t f) const { return 0.75 * face_areas_[f] / static_cast<double>(per_face_); }

  const std::vector<Triangle>& faces_;
  std::span<const Index> vertex_map_;
  std::size_t per_face_;
  LargeArray<Vec3> positions_;  ///< in the frame
  /// Per vertex: the sum of its faces' normals, each as long as twice the face's area, and a third of the sum of the
  /// areas.
  LargeArray<Eigen::Vector4f> normals_and_areas_;
  LargeArray<float> face_areas_;
  LargeArray<Foot> feet_;
};

}  // namespace whittle::polishing
