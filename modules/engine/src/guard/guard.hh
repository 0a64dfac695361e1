#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "complex/contraction_profile.hh"
#include "whittle/engine/refusals.hh"

namespace whittle {

/// Refuses contractions. A refused pair waits until something changes that the guard looks at.
class Guard {
 public:
  virtual ~Guard() = default;

  /// Where its refusals are counted; empty for nowhere.
  virtual std::optional<Refusal> reason() const = 0;

  /// Counts a pair that it refused: at every position that was tried.
  virtual void count(RefusalCounts& refusals) {
    if (const auto why = reason()) ++refusals[*why];
  }

  /// Whether it refuses the pair wherever the merged vertex goes. Asked once a turn, before the cost settles a
  /// position.
  virtual bool refuses(ContractionProfile& /*profile*/) { return false; }
  /// Whether it refuses the merged vertex at `position`.
  virtual bool refuses_at(ContractionProfile& /*profile*/, const Vec3& /*position*/) { return false; }

  /// Whether it is told of each contraction by `note`.
  virtual bool follows() const { return false; }
  virtual void note(const Change& /*change*/) {}

  /// How many rings around the pair it looks at: a change farther off can't lift its refusal. 1 or 2.
  virtual int n_rings() const { return 1; }
  /// Whether its refusals never change: such pairs don't wait.
  virtual bool is_final() const { return false; }
  /// Asked where nothing else is left to contract. \return whether it may have refused pairs that it allows from now on
  virtual bool gives_way() { return false; }
};

/// In the order in which they are asked. The first one that refuses counts.
using Guards = std::vector<std::unique_ptr<Guard>>;

}  // namespace whittle
