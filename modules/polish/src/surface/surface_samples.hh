#pragma once

#include <span>
#include <vector>

#include "surface/foot_finder.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Points that stand for a surface: its vertices, and one or four points in each face. Together they weigh what it has
/// of area, vertices a quarter of it; so that, where a function is linear on a face, its sum over the face's points is
/// the integral, and with one point the sum of its square is that of the square. And their feet on another surface.
class SurfaceSamples {
 public:
  /// \param vertex_map as `polish` says \param per_face 1 or 4
  SurfaceSamples(const IndexedMesh& surface, std::span<const Index> vertex_map, const Frame& frame,
                 std::size_t per_face, unsigned threads);

  std::span<const Vec3> positions() const { return positions_; }  ///< of the vertices, in the frame

  void find_feet(const FootFinder& finder, unsigned threads);

  /// Points by number: first the vertices, then those in faces.
  std::size_t size() const { return feet_.size(); }
  Vec3 position(std::size_t i) const;
  double weight(std::size_t i) const {
    return i < n_vertices() ? 0.25 * normals_and_areas_[i].w() : weight_in_face((i - n_vertices()) / per_face_);
  }
  const Foot& foot(std::size_t i) const { return feet_[i]; }
  void set_foot(std::size_t i, const Foot& foot) { feet_[i] = foot; }

  /// Calls `use(foot, weight)` for each point that has a foot, always in the same order.
  template <class Use>
  void for_each_foot(const Use& use) const {
    const auto use_if_there = [&](const Foot& foot, double weight) {
      if (foot.face != invalid_index) use(foot, weight);
    };
    for (std::size_t v = 0; v < n_vertices(); ++v) use_if_there(feet_[v], weight(v));
    std::size_t i = n_vertices();
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const double weight = weight_in_face(f);
      for (const std::size_t end = i + per_face_; i < end; ++i) use_if_there(feet_[i], weight);
    }
  }

 private:
  std::size_t n_vertices() const { return positions_.size(); }
  template <class PerVertex>
  void prefetch_corners(std::size_t f, const PerVertex& more) const;
  void measure();
  Vec3 place_in_face(const Triangle& face, std::size_t i) const;
  double weight_in_face(std::size_t f) const { return 0.75 * face_areas_[f] / static_cast<double>(per_face_); }

  const std::vector<Triangle>& faces_;
  std::span<const Index> vertex_map_;
  std::size_t per_face_;
  LargeArray<Vec3> positions_;  ///< in the frame
  /// Of vertices: the sum of the normals around, each as long as twice the face's area, and a third of these areas.
  LargeArray<Eigen::Vector4f> normals_and_areas_;
  LargeArray<float> face_areas_;
  LargeArray<Foot> feet_;
};

}  // namespace whittle
