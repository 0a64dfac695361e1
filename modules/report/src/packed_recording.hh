#pragma once

#include "packed_surface.hh"

namespace whittle::report {

/// {"steps", "contractions", "ends", "moves", "turns", "hidings", "levels"}: all that the page needs to go through the
/// recording. `docs/dev/page.md` says what the items are.
Json pack(const PageRecording& recording, const Grid& grid, PageBytes& bytes);

}  // namespace whittle::report
