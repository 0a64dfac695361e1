#pragma once

#include <vector>
#include <whittle/engine/decimate.hh>

#include "fuzz/decode/decimate_bytes.hh"

namespace whittle::test {

/// Coordinates are finite, corners are three different vertices, every vertex has a face, attributes are as long as
/// they are to be.
void check_sound(const IndexedMesh& mesh);

/// What the documentation promises of every decimation. \throw BrokenPromise
/// \param made as the listener was told them
void check_decimation(const DecimateCase& c, const Decimation& d, const std::vector<Contraction>& made);

/// Whether two decimations have the same bytes.
void check_same(const Decimation& d, const Decimation& other, const char* promise);

}  // namespace whittle::test
