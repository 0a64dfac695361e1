#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <algorithm>
#include <stdexcept>

namespace whittle {

/// Numbers of edges that a vertex may have.
struct ValenceRange {
  int min;
  int max;

  bool operator==(const ValenceRange&) const = default;
};

/// Refuses a collapse that leaves a vertex with too few or too many edges, unless it was worse before.
///
/// With n₀ and n₁ edges at v0 and v1 and w faces at the edge between them, the merged vertex has n₀ + n₁ − 2 − w edges.
/// The wings vl and vr lose one edge each. A collapse is refused when one of the three vertices is outside its range
/// afterwards, and was not farther outside before. (Of v0 and v1 the one farther outside counts.) So valences that are
/// all within the ranges stay there.
///
/// OpenMesh's `DecimaterT` asks a module when a collapse is queued, not when its turn comes. There some vertices still
/// get out of the range. `PairDecimaterT` asks when the turn comes. It then uses the mesh driver, as the engine doesn't
/// know this module.
///
/// To avoid such valences by a higher cost, use `set_valence_weight` of our cost modules.
template <class MeshT>
class ModValenceT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModValenceT, MeshT, Valence);

  explicit ModValenceT(MeshT& mesh) : Base(mesh, true), mesh_(mesh) {}

  /// Of vertices inside the surface. Default 4 to 9. \throw std::invalid_argument unless 0 ≤ min ≤ max
  void set_inner_range(const ValenceRange& range) { inner_ = checked(range); }
  const ValenceRange& inner_range() const { return inner_; }

  /// Of vertices on a border. Border edges count, too. Default 2 to 7. \throw std::invalid_argument as above
  void set_border_range(const ValenceRange& range) { border_ = checked(range); }
  const ValenceRange& border_range() const { return border_; }

  /// The error tolerance factor of the decimater has no effect.
  float collapse_priority(const CollapseInfo& collapse) override {
    return static_cast<float>(is_refused(collapse) ? Base::ILLEGAL_COLLAPSE : Base::LEGAL_COLLAPSE);
  }

  void set_binary(bool) = delete;  // always binary, as it only refuses

 private:
  using VertexHandle = OpenMesh::VertexHandle;

  static ValenceRange checked(const ValenceRange& range) {
    if (range.min >= 0 && range.min <= range.max) return range;
    throw std::invalid_argument("ModValenceT: not a range of valences, 0 <= min <= max");
  }

  /// How far outside its range a vertex is; 0 inside.
  int excess(int valence, bool on_border) const {
    const ValenceRange& range = on_border ? border_ : inner_;
    return std::max({0, range.min - valence, valence - range.max});
  }

  bool is_refused(const CollapseInfo& collapse) const {
    const auto valence = [this](VertexHandle v) { return static_cast<int>(mesh_.valence(v)); };
    const auto on_border = [this](VertexHandle v) { return mesh_.is_boundary(v); };
    const auto excess_now = [&](VertexHandle v) { return excess(valence(v), on_border(v)); };
    const auto is_bad = [](int before, int after) { return after > 0 && before <= after; };
    int n_wings = 0;
    for (const VertexHandle wing : {collapse.vl, collapse.vr}) {
      if (!wing.is_valid()) continue;
      ++n_wings;
      if (is_bad(excess_now(wing), excess(valence(wing) - 1, on_border(wing)))) return true;
    }
    const int merged = valence(collapse.v0) + valence(collapse.v1) - 2 - n_wings;
    return is_bad(std::max(excess_now(collapse.v0), excess_now(collapse.v1)),
                  excess(merged, on_border(collapse.v0) || on_border(collapse.v1)));
  }

  const MeshT& mesh_;
  ValenceRange inner_{4, 9};
  ValenceRange border_{2, 7};
};

}  // namespace whittle
