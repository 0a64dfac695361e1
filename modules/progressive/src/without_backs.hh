#pragma once

#include <memory>

#include "whittle/engine/two_sided_sheets.hh"
#include "whittle/progressive/replay.hh"

namespace whittle::progressive {

/// A replay of a mesh without the backs of its two-sided sheets.
struct Replay::WithoutBacks {
  std::unique_ptr<const IndexedMesh> input;  ///< with them; the sheets refer to it
  std::unique_ptr<const TwoSidedSheets> sheets;
  Replay replay;
};

}  // namespace whittle::progressive
