#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "options/command_line.hh"

namespace whittle::app {

/// In pixels.
struct PictureSize {
  std::uint64_t width = 1280;
  std::uint64_t height = 720;
};

/// Pictures of a recording on its way.
struct FrameOptions {
  std::optional<std::string> frames;     ///< .png files, with "{i}" for their numbers
  std::optional<std::string> animation;  ///< a .webp file
  double every = 0.05;                   ///< share of the contractions between two pictures

  bool is_given() const { return frames || animation; }
};

/// The command line of `report`.
struct ReportCommand {
  std::vector<std::string> files;  ///< the original and the results: meshes, and a recording
  std::optional<std::string> output;
  std::optional<std::string> run;  ///< what `simplify --json` has written
  std::optional<std::string> png;
  PictureSize png_size;
  std::string view;  ///< how the page is set up: "colour=error,layout=over"
  FrameOptions frames;
  std::uint64_t most_faces = 2'000'000;
  bool open = false;
  FileOptions files_options;
  CommonOptions common;
};

}  // namespace whittle::app
