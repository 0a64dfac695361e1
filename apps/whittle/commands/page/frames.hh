#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands/page/report_options.hh"
#include "files/output.hh"
#include "terminal/talk.hh"

// Pictures of a run on its way, original and level over each other.

namespace whittle::app {

/// --frames, --every and --animate.
OptionRows frame_rows(FrameOptions& options);

/// The files that are asked for. \throw UsageError for names that can't be
std::vector<Output> frame_outputs(const FrameOptions& options);

/// Draws the pictures of a page with a recording, and adds them to the files of a run.
/// \param settings of the page, as --view has them
/// \throw std::runtime_error as `PageView`
void write_frames(OutputFiles& files, const FrameOptions& options, const std::string& page, const std::string& settings,
                  const PictureSize& size, const Talk& talk);

}  // namespace whittle::app
