#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/output.hh"
#include "options/subcommand.hh"
#include "pictures/draw_meshes.hh"
#include "terminal/talk.hh"

// Pictures of a run on its way, original and level over each other.

namespace whittle::app {

struct FrameOptions {
  std::optional<std::string> frames;     ///< .png files, with "{i}" for their numbers
  std::optional<std::string> animation;  ///< a .webp file
  double every = 0.05;                   ///< share of the contractions between two pictures

  bool is_given() const { return frames || animation; }
};

/// How many pictures there are, the first and the last one, too.
std::size_t n_frames(const FrameOptions& options);
/// The place of a picture in the run, a share of the contractions. [0, 1]
double place_of(const FrameOptions& options, std::size_t i);

/// --frames, --every and --animate.
OptionRows frame_rows(FrameOptions& options);

/// The files that are asked for. \throw UsageError for names that can't be
std::vector<Output> frame_outputs(const FrameOptions& options);

/// \throw std::runtime_error if pictures are asked for that this program or this machine can't make
void require_frames(const FrameOptions& options);

/// How frames are drawn.
struct FrameLook {
  PageSettings settings;  ///< besides the place in the run
  PictureSize size;
  unsigned threads = 0;
};

/// Draws a run, and adds the pictures to the files of a command.
/// \param meshes with a run \pre `require_pictures` \throw std::runtime_error
void write_frames(OutputFiles& files, const FrameOptions& options, ShownMeshes& meshes, const FrameLook& look,
                  const Talk& talk);

}  // namespace whittle::app
