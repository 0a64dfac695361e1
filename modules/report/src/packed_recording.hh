#pragma once

#include "packed_surface.hh"

namespace whittle::report {

/// {"steps", "contractions", "ends", "moves", "turns", "visibility", "levels"}: the data from which the page replays
/// the recording. The structs in packed_recording.cc describe the items.
Json pack(const PageRecording& recording, const Grid& grid, PageBytes& bytes);

}  // namespace whittle::report
