#pragma once

#include <string>
#include <string_view>

#include "whittle/engine/options.hh"

namespace whittle::app {

/// Changes the weights of the kinds that are named. \param text "uv=0.5" or "uv=0.5,normal=0"
/// \throw std::invalid_argument
AttributeWeights parse_attribute_weights(std::string_view text, AttributeWeights weights);

/// "uv=0.2,normal=1,…"
std::string to_string(const AttributeWeights& weights);

}  // namespace whittle::app
