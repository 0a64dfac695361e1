#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "options/command_line.hh"

namespace whittle::app {

/// In pixels.
struct PictureSize {
  std::uint64_t width, height;
};

/// The command line of `report`.
struct ReportCommand {
  std::vector<std::string> files;  ///< the original and the results: meshes, and a recording
  std::optional<std::string> output;
  std::optional<std::string> run;  ///< what `simplify --json` has written
  std::optional<std::string> png;
  PictureSize png_size{1280, 720};
  std::string view;  ///< how the page is set up: "colour=error,layout=over"
  std::uint64_t most_faces = 2'000'000;
  bool open = false;
  FileOptions files_options;
  CommonOptions common;
};

}  // namespace whittle::app
