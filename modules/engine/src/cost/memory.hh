#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/formula/memoryless_term.hh"

namespace whittle {

/// What costs know of a surface that can't be told from it: what it was like at the start, and what vertices remember.
struct Memory {
  struct Remembered {
    Index vertex;  ///< by number in the input of the pass that gets the memory
    Quadric quadric;
  };

  MeanFaceArea face_area;
  std::vector<Remembered> quadrics;  ///< by vertex, ascending
};

}  // namespace whittle
