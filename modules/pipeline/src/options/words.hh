#pragma once

#include <string>

#include "whittle/engine/cost_traits.hh"

namespace whittle {

/// A default that depends on the cost, for help: "75; 60 with memoryless".
template <class Text>
std::string defaults_by_cost(const Text& text) {
  const std::string usual = text(cost_traits(Cost::quadric));
  std::string others;
  for (const CostTraits& traits : all_cost_traits) {
    if (text(traits) == usual) continue;
    others += (others.empty() ? "; " : ", ") + text(traits) + " with " + std::string(traits.name);
  }
  return usual + others;
}

}  // namespace whittle
