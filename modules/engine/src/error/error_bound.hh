#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "error/kept_proofs.hh"
#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/proof/target_surface.hh"

namespace whittle {

/// A surface that the input has become, to be checked. What it names must outlive it.
struct CheckedSurface {
  const IndexedMesh& mesh;
  Frame frame;                        ///< takes it to the frame of the bound
  std::span<const Index> vertex_map;  ///< the input's vertices → those of the surface, `invalid_index` where it was
                                      ///< in no face
  std::span<const std::uint8_t> is_proven{};  ///< a face, 1 if it is known to be near to the input; or empty
};

/// How far a surface and the input may be from each other, both ways, and what is known of that.
class ErrorBound {
 public:
  /// A point of the input, and a face of the surface that it is near to: its *support*.
  struct Support {
    Index point;
    Triangle face;  ///< by the surface's vertices
  };

  /// A point of the input that is far from the surface.
  struct FarPoint {
    Vec3 position;  ///< in the frame
    double limit;   ///< that it has
  };

  /// What stands against a surface.
  struct Violations {
    bool is_surface_far = false;  ///< whether a face of it isn't proven to be near to the input
    std::vector<FarPoint> points;
    std::vector<Index> vertices;  ///< of the surface, at those faces and near to those points

    bool empty() const { return !is_surface_far && points.empty(); }
    void add(const Violations& other);
  };

  /// \param input must outlive it. Triangles of which two corners are one stand for segments.
  /// \param limit in the frame
  /// \param tolerances of the input's vertices, model units, or empty: the limit of each face is the least of its
  ///        corners', too
  ErrorBound(const IndexedMesh& input, const Frame& frame, double limit, unsigned threads,
             std::span<const double> tolerances = {});

  const TargetSurface& input() const { return input_; }
  double limit() const { return limit_; }
  void tighten() { limit_ *= 0.95; }  ///< \pre there are no tolerances
  /// How far the surface may be from a point: the least limit of the faces that it is a corner of, or lies on.
  double limit_at(Index point) const { return point_limits_.empty() ? limit_ : point_limits_[point]; }

  /// Points of the input that are to be near to the surface: its vertices, and those that were added.
  std::span<const Vec3> points() const { return points_; }
  void add_points(std::span<const FarPoint> points);
  /// A face of the input at a point. `invalid_index` if it is no vertex of a face.
  Index face_at(Index point) const { return point < faces_at_.size() ? faces_at_[point] : invalid_index; }
  /// The other ends of the input's edges at a point. None if it isn't a vertex.
  std::span<const Index> neighbours(Index point) const {
    return point < neighbours_.size() ? neighbours_.of(point) : std::span<const Index>{};
  }

  /// Tries to prove that a surface keeps the bound. \param limit in place of that of the bound
  Violations check(const CheckedSurface& checked, double limit) { return check(checked, {limit, Search::all}); }
  /// The same of the surface that `check` looked at last, after some of its vertices have moved: looks at what these
  /// change. \pre neither `is_kept_by` nor `has_far_point` was asked since
  /// \param is_changed a vertex of the surface, 1 if it has moved
  Violations check_again(const CheckedSurface& checked, std::span<const std::uint8_t> is_changed);
  /// Whether that is proven: takes less time where it isn't.
  bool is_kept_by(const CheckedSurface& checked) { return check(checked, {limit_, Search::first}).empty(); }
  /// Whether a point is far: one of the input from the surface, or a corner or the middle of an edge from the input.
  bool has_far_point(const CheckedSurface& checked);
  /// Vertices of a surface that are farther from the input than a share of the limit. \return a vertex, 1 if it is far
  std::vector<std::uint8_t> far_vertices(const CheckedSurface& checked, double share) const;
  /// Of the surface checked last, each point once.
  const std::vector<Support>& supports() const { return supports_; }

 private:
  /// Which violations are looked for: all, or any.
  enum class Search { all, first };

  /// What is sought in a check.
  struct Question {
    double limit;
    Search search;
    std::vector<std::uint8_t> is_changed{};  ///< a face of the surface, 0 if it is as it was checked last; or empty

    bool is_changed_at(Index face) const { return is_changed.empty() || is_changed[face] != 0; }
  };
  /// What was found of the surface checked last.
  struct Found {
    std::vector<Index> supports;           ///< a face, per point; `invalid_index` for vertices that are in no face
    std::vector<std::uint8_t> is_far;      ///< per point
    std::vector<std::uint8_t> is_proven;   ///< per face of the surface
    std::vector<KeptProofs> input_proofs;  ///< per block of the input's faces: of faces that have several supports
  };

  Violations check(const CheckedSurface& checked, const Question& question);
  void find_supports(const TargetSurface& target, std::span<const Index> vertex_map, const Question& question,
                     Violations& violations);
  bool has_far_point_on(const TargetSurface& surface) const;
  void check_input(const TargetSurface& target, const Question& question, Violations& violations);
  void check_surface(const TargetSurface& target, std::span<const std::uint8_t> is_proven, const Question& question,
                     Violations& violations);
  void list_supports(const TargetSurface& target, double limit, Violations& violations);

  double limit_of(Index face, double limit) const { return limits_.empty() ? limit : std::min(limit, limits_[face]); }

  std::vector<double> limits_;  ///< of the input's faces, in the frame; or empty
  TargetSurface input_;
  double limit_;
  unsigned threads_;
  std::vector<Vec3> points_;          ///< in the frame
  std::vector<double> point_limits_;  ///< of each, if there are tolerances
  detail::IndexLists<Index> neighbours_;
  std::vector<Index> faces_at_;  ///< a face at each vertex of the input
  std::vector<Support> supports_;
  Found found_;
};

}  // namespace whittle
