#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "complex/triangle_complex.hh"
#include "whittle/engine/formula/pair_evaluation.hh"

namespace whittle {

/// The lines that hold their vertices, by these: features, and seams that are kept. Seams have no tolerance.
struct FeatureLines {
  /// Where a line was, between the ends of a feature edge: its vertices there, in no particular order, in the frame.
  using Course = std::vector<Vec3>;

  std::vector<VertexPair> edges;                ///< ascending, the lower vertex first
  std::vector<std::uint8_t> is_seam;            ///< of each edge: whether it is a seam, and no feature; or empty: none
  std::vector<Course> courses;                  ///< of each edge; or empty: no edge stands for several
  std::optional<std::vector<Index>> corners{};  ///< vertices where lines meet, end or turn; empty: to be found
};

/// How seams hold their vertices.
enum class SeamHold {
  at_ends,  ///< They go along the seam; two that become one go to where one of them is.
  along     ///< They go along the seam, to where the cost likes, which knows of seams.
};

/// Constraints on where vertices go. A locked vertex stays. A vertex on a feature line moves along the line, and stays
/// where lines meet, end or turn. Seams may turn.
class Constraints {
 public:
  /// None.
  Constraints() = default;
  /// \param locked per vertex, or empty
  /// \param lines by original vertices; those edges count that the complex has
  /// \param corner_angle_deg a line that turns further has a corner there, if `lines` doesn't say where corners are
  /// \param tolerance how far a feature line may come to lie from what it was, in the frame
  Constraints(const TriangleComplex& complex, std::span<const std::uint8_t> locked, const FeatureLines& lines,
              double corner_angle_deg, double tolerance, SeamHold seam_hold);

  bool any() const { return !constraints_.empty(); }

  /// Where v̄ may go; nullopt if neither vertex may leave its place along this edge.
  std::optional<PairConstraint> of(const Pair& pair) const {
    if (!any()) return PairConstraint::none;
    const bool along_line = is_feature(pair.id);
    const bool first_may_move = may_move(pair.a, along_line);
    const bool second_may_move = may_move(pair.b, along_line);
    if (!first_may_move && !second_may_move) return std::nullopt;
    if (!first_may_move) return PairConstraint::first;
    if (!second_may_move) return PairConstraint::second;
    const bool is_free = !along_line || (is_seam(pair.id) && seam_hold_ != SeamHold::at_ends);
    return is_free ? PairConstraint::none : PairConstraint::either;
  }
  /// Whether the edge is on a seam, and on no feature line.
  bool is_seam(Index edge) const { return !is_seam_.empty() && is_seam_[edge]; }
  bool has_seams() const { return !is_seam_.empty(); }
  /// Whether the edge is part of a line that holds its vertices.
  bool is_feature(Index edge) const { return has_features() && is_feature_[edge]; }
  bool are_both_locked(const Pair& pair) const { return is_locked(pair.a) && is_locked(pair.b); }

  /// Whether contracting the pair would lay two feature edges on one another, so that a line lost its loop, take all
  /// faces of a feature edge away, or take a line farther off than it may be.
  bool harms_a_line(TriangleComplex& complex, const ContractionProfile& profile, const Vec3& position) const;

  /// The feature lines that there are now. \param numbers vertices of the complex → vertices of the result
  FeatureLines lines(TriangleComplex& complex, const std::vector<Index>& numbers) const;

  /// \param profile as it was before the contraction
  void note(const TriangleComplex& complex, const ContractionProfile& profile, const Change& change);

 private:
  enum class Constraint : std::uint8_t {
    free,
    on_line,    ///< It moves along its two feature edges.
    at_corner,  ///< It stays: feature lines meet, end or turn there.
    locked      ///< It stays.
  };

  bool takes_a_line_away(TriangleComplex& complex, const ContractionProfile& profile) const;
  bool has_features() const { return !is_feature_.empty(); }
  bool may_move(Index v, bool along_line) const {
    return constraints_[v] == Constraint::free || (constraints_[v] == Constraint::on_line && along_line);
  }
  bool is_locked(Index v) const { return any() && constraints_[v] == Constraint::locked; }
  void mark_features(const TriangleComplex& complex, const FeatureLines& lines, double corner_angle_deg);

  using Course = FeatureLines::Course;
  std::size_t moved_end(const Pair& pair, const Vec3& first, const Vec3& position) const;
  std::optional<Index> other_feature_edge(TriangleComplex& complex, Index v, Index edge) const;
  std::optional<Index> other_feature_edge_before(const TriangleComplex& complex, const ContractionProfile& profile,
                                                 const Change& change, std::size_t end) const;
  void merge_courses(const TriangleComplex& complex, const ContractionProfile& profile, const Change& change);

  std::vector<Constraint> constraints_;        ///< per vertex, or empty
  std::vector<bool> is_feature_;               ///< per pair, or empty; seams, too
  std::vector<bool> is_seam_;                  ///< per pair, or empty
  std::unordered_map<Index, Course> courses_;  ///< of feature edges that stand for several
  double tolerance_sq_ = 0;
  SeamHold seam_hold_ = SeamHold::at_ends;
};

}  // namespace whittle
