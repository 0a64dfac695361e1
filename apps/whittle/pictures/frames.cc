#include "pictures/frames.hh"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "pictures/animation.hh"
#include "pictures/compare_pictures.hh"
#include "terminal/errors.hh"
#include "terminal/progress_bar.hh"

namespace whittle::app {

std::size_t n_frames(const FrameOptions& options) { return static_cast<std::size_t>(std::ceil(1 / options.every)) + 1; }

double place_of(const FrameOptions& options, std::size_t i) {
  return std::min(1.0, static_cast<double>(i) * options.every);
}

OptionRows frame_rows(FrameOptions& options) {
  return {side_file_row("--frames", options.frames,
                        "draw the original and the levels of the run over each other: .png files; '{i}' stands for the "
                        "number of each"),
          {.names = "--every",
           .access = ratio(options.every),
           .help = "a picture after each such share of the contractions",
           .standard = "5%",
           .idle = {{.without = {"--frames", "--animate"}}}},
          side_file_row("--animate", options.animation, "make one moving picture of them: a .webp file")};
}

std::vector<Output> frame_outputs(const FrameOptions& options) {
  std::vector<Output> outputs;
  if (options.frames) {
    check_number(*options.frames, "--frames", true);
    if (!options.frames->ends_with(".png"))
      throw UsageError("--frames: '" + *options.frames + "' doesn't end with .png");
    const std::size_t n = n_frames(options);
    for (std::size_t i = 0; i < n; ++i) outputs.push_back({"--frames", numbered(*options.frames, i, n)});
  }
  if (options.animation) {
    if (!options.animation->ends_with(".webp")) {
      throw UsageError("--animate: '" + *options.animation + "' doesn't end with .webp");
    }
    outputs.push_back({"--animate", *options.animation});
  }
  return outputs;
}

void require_frames(const FrameOptions& options) {
  if (options.is_given()) require_pictures();
  if (options.animation) require_animations();
}

void write_frames(OutputFiles& files, const FrameOptions& options, ShownMeshes& meshes, const FrameLook& look,
                  const Talk& talk) {
  if (!options.is_given()) return;
  const std::size_t n = n_frames(options);
  ProgressBar bar(talk, "drawing");
  const ProgressCallback progress = part_of(bar, 0, 1);
  PageSettings settings = look.settings;
  settings.emplace("layout", "over");
  if (meshes.run) settings["result"] = "0";  // the level
  PictureView view = picture_view(settings);
  std::vector<std::string> warnings;  // of textures: levels have none
  Animation animation;
  const auto write = [&files](const std::string& path, const std::string& bytes) {
    files.write(path, [&bytes](std::ostream& out) { out << bytes; });
  };
  for (std::size_t i = 0; i < n; ++i) {
    view.level = place_of(options, i);
    const RgbPicture picture = draw_meshes(meshes, view, look.size, look.threads, warnings);
    if (options.frames) write(numbered(*options.frames, i, n), png_file(picture));
    if (options.animation) animation.add(picture);
    if (progress) progress({static_cast<double>(i + 1) / static_cast<double>(n)});
  }
  if (options.animation) write(*options.animation, animation.finished());
}

}  // namespace whittle::app
