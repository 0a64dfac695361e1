#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <array>
#include <cstdint>
#include <optional>
#include <queue>
#include <tuple>
#include <vector>

#include "whittle/engine/decimate.hh"
#include "whittle/openmesh/feature_lines.hh"
#include "whittle/openmesh/link_condition.hh"
#include "whittle/openmesh/moved_faces.hh"

namespace whittle {

template <class MeshT>
class PairDecimaterT;

/// The mesh driver of `PairDecimaterT`: contractions in exact order on OpenMesh's connectivity.
///
/// A candidate is an edge, named by its first halfedge, when the cost module places the merged vertex; with a foreign
/// cost it is a halfedge, from the vertex that would vanish. It is in one of three states:
///   - queued: under its cost, or under the final one, if that was seen to be higher. Whatever may lower the cost
///     (`Reach`) queues it anew, which invalidates the old entry;
///   - waiting: a guard or a module refused it. Woken when a vertex at or beside it changes;
///   - gone: its edge is deleted.
template <class MeshT>
class MeshContractionLoopT {
 public:
  /// \param target with a limit of the cost, in model units, only if the cost module is ours
  MeshContractionLoopT(PairDecimaterT<MeshT>& decimater, const DecimateTarget& target, bool only_selected);

  DecimateResult run();

 private:
  using VertexHandle = OpenMesh::VertexHandle;
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;
  using EdgeHandle = OpenMesh::EdgeHandle;
  using Module = typename PairDecimaterT<MeshT>::Module;
  using CollapseInfo = typename PairDecimaterT<MeshT>::CollapseInfo;

  struct Entry {
    double cost;
    int low, high;  ///< vertex indices
    int survivor;
    HalfedgeHandle candidate;
    std::uint32_t version;  ///< of the candidate; an entry with an older one is void
    friend bool operator>(const Entry& a, const Entry& b) {
      return std::tie(a.cost, a.low, a.high, a.survivor) > std::tie(b.cost, b.low, b.high, b.survivor);
    }
  };

  /// What a candidate would do.
  struct Move {
    HalfedgeHandle to_survivor;
    PairEvaluation evaluation;  ///< in the cost module's frame; model units if it is foreign
    Vec3 position;              ///< where the merged vertex goes, likewise
    double cost;                ///< of going there, likewise
  };

  enum class Refusal { none, locked, feature, link, flip, shape, module };

  void fill_queue();
  void enqueue(HalfedgeHandle candidate);
  bool target_reached() const;
  std::optional<Entry> next_entry();
  std::optional<StopReason> take_turn(const Entry& entry);
  bool is_too_dear(double cost) const { return cost_limit_ && cost > *cost_limit_; }

  /// Whether v stays whatever the edge. Vertices that have copies do: they would have to move together.
  bool is_fixed(VertexHandle v) const {
    return decimater_.is_fixed(v, only_selected_) ||
           (!has_copies_.empty() && has_copies_[static_cast<std::size_t>(v.idx())]) || feature_lines_.is_point(v);
  }
  std::optional<Pinned> pinned(VertexHandle first, VertexHandle second, HalfedgeHandle edge) const;
  VertexHandle moved_vertex(const CollapseInfo& collapse, const Vec3& to) const;
  Move move_by_own_cost(HalfedgeHandle candidate) const;
  /// Nothing, and counted, where the module or OpenMesh's rules refuse.
  std::optional<Move> move_by_foreign_cost(HalfedgeHandle candidate);
  std::optional<Move> move_of(HalfedgeHandle candidate) {
    return is_foreign() ? move_by_foreign_cost(candidate) : move_by_own_cost(candidate);
  }

  Refusal place(Move& move);
  Refusal find_refusal_of_pair(const CollapseInfo& collapse);
  Refusal find_refusal_at(const Vec3& to, const CollapseInfo& collapse);
  bool modules_refuse(const CollapseInfo& collapse, const Vec3& to);
  void count(Refusal refusal);
  void contract(const Move& move);
  void find_affected(VertexHandle survivor, const std::array<VertexHandle, 2>& wings);

  bool is_foreign() const { return decimater_.foreign_cost_ != nullptr; }
  double feature_tolerance() const;
  Vec3 position_of(VertexHandle v) const;
  auto positions() const {
    return [this](VertexHandle v) { return position_of(v); };
  }
  Vec3 to_model(const Vec3& position) const;

  PairDecimaterT<MeshT>& decimater_;
  MeshT& mesh_;
  DecimateTarget target_;
  std::optional<double> cost_limit_;  ///< that of the target, in the cost module's frame
  bool only_selected_;
  FlipLimit flip_limit_;
  double min_radius_ratio_;
  LinkConditionT<MeshT> link_condition_;
  FeatureLinesT<MeshT> feature_lines_;

  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::vector<std::uint32_t> versions_;  ///< by halfedge
  std::vector<bool> is_waiting_;         ///< by halfedge
  std::vector<HalfedgeHandle> affected_;
  std::vector<bool> has_copies_;             ///< by vertex; empty where none has
  const Module* refusing_module_ = nullptr;  ///< the one that refused last
  DecimateResult result_;
};

}  // namespace whittle

#include "whittle/openmesh/mesh_contraction_loop_impl.hh"
