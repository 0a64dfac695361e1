#pragma once

#include <optional>
#include <string>
#include <whittle/core/indexed_mesh.hh>
#include <whittle/engine/decimate.hh>

#include "fuzz/decode/byte_source.hh"

namespace whittle::test {

/// What `decimate` is given.
struct DecimateCase {
  IndexedMesh mesh;
  DecimateTarget target = DecimateTarget::as_far_as_possible();
  DecimateOptions options;               ///< one thread, no callbacks
  std::optional<unsigned> n_calls_left;  ///< the progress callback ends the run after so many calls
};

DecimateCase decode_decimate_case(ByteSource& source);

/// A value for an option with the range [low, high], now and then outside of it.
double option_value(ByteSource& source, double low, double high);

/// Whether the documentation of `DecimateOptions`, `DecimateTarget` and `IndexedMesh` allows the case.
bool is_valid(const DecimateCase& c);

/// For messages.
std::string text_of(const DecimateCase& c);

}  // namespace whittle::test
