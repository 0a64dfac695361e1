#pragma once

#include "whittle/engine/options.hh"
#include "whittle/pipeline/option.hh"

namespace whittle {

/// KIND=W with commas between; kinds that aren't named keep their weight.
OptionAccess attribute_weights(AttributeWeights& target);

}  // namespace whittle
