#pragma once

#include <span>
#include <vector>

#include "foot_finder.hh"
#include "whittle/engine/frame.hh"
#include "whittle/engine/indexed_mesh.hh"
#include "whittle/engine/large_array.hh"

namespace whittle {

/// Points that stand for a surface: its vertices, and one or four points in each face. Together they weigh what it has
/// of area, vertices a quarter of it; so that, where a function is linear on a face, the sum of its square over the
/// face's points is the integral. And their feet on another surface.
class SurfaceSamples {
 public:
  /// \param vertex_map as `polish` says \param per_face 1 or 4
  SurfaceSamples(const IndexedMesh& surface, std::span<const Index> vertex_map, const Frame& frame,
                 std::size_t per_face, unsigned threads);

  const std::vector<Vec3>& positions() const { return positions_; }  ///< of the vertices, in the frame

  void find_feet(const FootFinder& finder, unsigned threads);

  /// Points by number: first the vertices, then those in faces.
  std::size_t size() const { return vertex_feet_.size() + face_feet_.size(); }
  const Foot& foot(std::size_t i) const { return i < n_vertices() ? vertex_feet_[i] : face_feet_[i - n_vertices()]; }
  void set_foot(std::size_t i, const Foot& foot) {
    (i < n_vertices() ? vertex_feet_[i] : face_feet_[i - n_vertices()]) = foot;
  }
  Vec3 position(std::size_t i) const;
  double weight(std::size_t i) const;  ///< \pre it has a foot

  /// Calls `use(foot, weight)` for each point that has a foot, always in the same order.
  template <class Use>
  void for_each_foot(const Use& use) const {
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      if (vertex_feet_[v].face != invalid_index) use(vertex_feet_[v], 0.25 * vertex_areas_[v]);
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const std::span<const Foot> feet = std::span(face_feet_).subspan(f * per_face_, per_face_);
      const auto has_foot = [](const Foot& foot) { return foot.face != invalid_index; };
      const auto n = static_cast<double>(std::count_if(feet.begin(), feet.end(), has_foot));
      for (const Foot& foot : feet) {
        if (has_foot(foot)) use(foot, 0.75 * face_areas_[f] / n);
      }
    }
  }

 private:
  std::size_t n_vertices() const { return vertex_feet_.size(); }
  void measure();
  void find_feet_of_face(const FootFinder& finder, std::size_t f);

  const std::vector<Triangle>& faces_;
  std::span<const Index> vertex_map_;
  std::size_t per_face_;
  std::vector<Vec3> positions_;      ///< in the frame
  std::vector<Vec3> normals_;        ///< of vertices, as long as twice the area around
  std::vector<float> vertex_areas_;  ///< a third of the faces'
  std::vector<float> face_areas_;
  LargeArray<Foot> vertex_feet_;
  LargeArray<Foot> face_feet_;
};

}  // namespace whittle
