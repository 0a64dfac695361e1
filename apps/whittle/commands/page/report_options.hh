#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "options/command_line.hh"
#include "pictures/frames.hh"

namespace whittle::app {

/// The command line of `report`.
struct ReportCommand {
  std::vector<std::string> files;  ///< the original and the results: meshes, and a recording
  std::optional<std::string> output;
  std::optional<std::string> run;  ///< what `simplify --json` has written
  std::optional<std::string> png;
  PictureSize png_size;
  PageSettings view;  ///< of pictures
  FrameOptions frames;
  std::uint64_t most_faces = 2'000'000;
  bool open = false;
  FileOptions files_options;
  CommonOptions common;
};

}  // namespace whittle::app
