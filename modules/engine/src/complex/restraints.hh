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

/// Which vertices may not go where they like: locked ones stay where they are; those on a feature line move along it
/// only, and where lines meet, end or turn they stay. Seams turn as they like.
class Restraints {
 public:
  /// None.
  Restraints() = default;
  /// \param locked per vertex, or empty
  /// \param lines by original vertices; those edges count that the complex has
  /// \param corner_angle_deg a line that turns further has a corner there, if `lines` doesn't say where corners are
  /// \param tolerance how far a feature line may come to lie from what it was, in the frame
  Restraints(const TriangleComplex& complex, std::span<const std::uint8_t> locked, const FeatureLines& lines,
             double corner_angle_deg, double tolerance, SeamHold seam_hold);

  bool any() const { return !freedoms_.empty(); }

  /// Where v̄ may go; nullopt if neither vertex may leave its place along this edge.
  std::optional<Pinned> pinned(const Pair& pair) const {
    if (!any()) return Pinned::none;
    const bool along_line = is_feature(pair.id);
    const bool first_may_move = may_move(pair.a, along_line);
    const bool second_may_move = may_move(pair.b, along_line);
    if (!first_may_move && !second_may_move) return std::nullopt;
    if (!first_may_move) return Pinned::first;
    if (!second_may_move) return Pinned::second;
    const bool is_free = !along_line || (is_seam(pair.id) && seam_hold_ != SeamHold::at_ends);
    return is_free ? Pinned::none : Pinned::either;
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
  enum class Freedom : std::uint8_t {
    full,
    line,    ///< along its two feature edges
    corner,  ///< none, as feature lines meet, end or turn there
    locked   ///< none
  };

  bool takes_a_line_away(TriangleComplex& complex, const ContractionProfile& profile) const;
  bool has_features() const { return !is_feature_.empty(); }
  bool may_move(Index v, bool along_line) const {
    return freedoms_[v] == Freedom::full || (freedoms_[v] == Freedom::line && along_line);
  }
  bool is_locked(Index v) const { return any() && freedoms_[v] == Freedom::locked; }
  void mark_features(const TriangleComplex& complex, const FeatureLines& lines, double corner_angle_deg);

  using Course = FeatureLines::Course;
  std::size_t moved_end(const Pair& pair, const Vec3& first, const Vec3& position) const;
  std::optional<Index> other_feature_edge(TriangleComplex& complex, Index v, Index edge) const;
  std::optional<Index> other_feature_edge_before(const TriangleComplex& complex, const ContractionProfile& profile,
                                                 const Change& change, std::size_t end) const;
  void merge_courses(const TriangleComplex& complex, const ContractionProfile& profile, const Change& change);

  std::vector<Freedom> freedoms_;              ///< per vertex, or empty
  std::vector<bool> is_feature_;               ///< per pair, or empty; seams, too
  std::vector<bool> is_seam_;                  ///< per pair, or empty
  std::unordered_map<Index, Course> courses_;  ///< of feature edges that stand for several
  double tolerance_sq_ = 0;
  SeamHold seam_hold_ = SeamHold::at_ends;
};

}  // namespace whittle
