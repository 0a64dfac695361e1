#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "complex/constraints.hh"
#include "cost/attributes/input_attributes.hh"
#include "cost/cost_state.hh"
#include "whittle/engine/refusals.hh"

namespace whittle {

/// A list that is its own, or is borrowed from what outlives it. A copy of a borrowed list borrows, too.
template <class T>
class MaybeOwned {
 public:
  MaybeOwned() = default;
  MaybeOwned(std::vector<T> own) : own_(std::move(own)) {}
  static MaybeOwned borrowed(std::span<const T> list) {
    MaybeOwned result;
    result.borrowed_ = list;
    return result;
  }

  std::size_t size() const { return is_borrowed() ? borrowed_.size() : own_.size(); }
  const T* data() const { return is_borrowed() ? borrowed_.data() : own_.data(); }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size(); }
  const T& operator[](std::size_t i) const { return data()[i]; }
  /// The list, to be changed. \pre it isn't borrowed
  std::vector<T>& own() { return own_; }

 private:
  bool is_borrowed() const { return borrowed_.data() != nullptr; }

  std::vector<T> own_;
  std::span<const T> borrowed_;
};

/// A pair that a guard refused.
struct GuardedPair {
  VertexPair pair;                ///< by vertices of the surface
  std::optional<Refusal> reason;  ///< that of the guard
};

/// What goes from stage to stage of a run: a surface, where it comes from, and all that the next stage needs to know.
/// The first one is the input.
struct WorkingSurface {
  MaybeOwned<Vec3> positions;
  Frame frame{};  ///< takes `positions` to the frame; of no effect if they are in it
  MaybeOwned<Triangle> faces;
  // Empty in the input, whose numbers these are.
  std::vector<Index> origins{};       ///< vertices of the input, ascending
  std::vector<Index> face_origins{};  ///< faces of the input, ascending
  std::vector<Index> vertex_map{};    ///< the input's vertices → those here; `invalid_index` where it was in no face
  FeatureLines lines{};
  std::vector<VertexPair> threshold_pairs{};  ///< that may be contracted
  CostState cost_state{};
  /// Of the input, if attributes count: those of its vertices are not in the cost state.
  std::shared_ptr<const InputAttributes> input_attributes{};
  std::vector<GuardedPair> refusals{};             ///< that hold, if the order is exact
  std::vector<PlacedQuadric> quadrics{};           ///< a vertex, where they are asked for
  std::optional<NonmanifoldCounts> nonmanifold{};  ///< if they are counted

  bool is_input() const { return vertex_map.empty(); }
  /// Those of some vertices, which get their places as numbers. \param vertices ascending
  SurfaceAttributes attributes_at(std::span<const Index> vertices, unsigned threads) const {
    return input_attributes ? input_attributes->at(vertices, threads) : cost_state.attributes.at(vertices);
  }
  Index origin_of(Index vertex) const { return is_input() ? vertex : origins[vertex]; }
  Index face_origin_of(Index face) const { return is_input() ? face : face_origins[face]; }

  /// What the vertices here have of a list of the input's. \param of_input or empty
  template <class T>
  std::vector<T> of_vertices(std::vector<T> of_input) const {
    return is_input() ? std::move(of_input) : gathered(of_input, origins);
  }
  template <class T>
  std::vector<T> of_faces(std::vector<T> of_input) const {
    return is_input() ? std::move(of_input) : gathered(of_input, face_origins);
  }

 private:
  template <class T>
  static std::vector<T> gathered(const std::vector<T>& list, const std::vector<Index>& numbers) {
    std::vector<T> result;
    if (list.empty()) return result;
    result.reserve(numbers.size());
    for (const Index i : numbers) result.push_back(list[i]);
    return result;
  }
};

}  // namespace whittle
