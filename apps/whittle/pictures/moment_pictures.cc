#include "pictures/moment_pictures.hh"

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <utility>

#include "files/report.hh"
#include "whittle/core/wedges.hh"
#include "whittle/io/output_file.hh"
#include "whittle/io/path_of.hh"

namespace whittle::app {
namespace {

constexpr double least_interval = 1;  ///< between two pictures, seconds
constexpr double times_drawing = 10;  ///< between two pictures, how many times as long as drawing the one before took

}  // namespace

MomentPictures::MomentPictures(const FrameOptions& options, const Plan& plan, const Stopwatch& since_start)
    : options_(options), plan_(plan), since_start_(since_start), view_(picture_view({{"layout", "over"}})) {
  for (const Output& output : frame_outputs(options)) {
    std::error_code error;
    if (std::filesystem::exists(io::path_of(output.path), error)) taken_.push_back(output.path);
  }
  shown_.original.name = short_name(plan.scene.name);
  shown_.original.mesh = without_attributes(plan.scene.read.mesh);
  shown_.results.emplace_back();
  draw(shown_.original.mesh, 0);
}

MomentPictures::~MomentPictures() {
  for (const std::string& path : drawn_) {
    std::error_code error;
    std::filesystem::remove(io::path_of(path), error);
  }
}

/// Of the faces that are to go.
double MomentPictures::share_gone(std::uint64_t n_faces) const {
  const IndexedMesh& input = shown_.original.mesh;
  const auto n = static_cast<double>(input.faces.size());
  const double wanted = plan_.target.share_of(input.faces.size(), input.positions.size()) * n;
  return wanted < n ? (n - static_cast<double>(n_faces)) / (n - wanted) : 0;
}

void MomentPictures::write(const std::string& path, const std::string& bytes) {
  if (std::find(taken_.begin(), taken_.end(), path) != taken_.end()) return;
  io::OutputFile file(io::path_of(path));
  file.stream() << bytes;
  file.commit();
  if (std::find(drawn_.begin(), drawn_.end(), path) == drawn_.end()) drawn_.push_back(path);
}

void MomentPictures::draw(IndexedMesh mesh, std::size_t i) {
  const double begin = since_start_.seconds();
  shown_.results.front().name = "level of the run";
  shown_.results.front().mesh = std::move(mesh);
  std::vector<std::string> warnings;  // of textures: there are none
  const RgbPicture picture = draw_meshes(shown_, view_, PictureSize(), plan_.threads(), warnings);
  if (options_.frames) write(numbered(*options_.frames, i, n_frames(options_)), png_file(picture));
  if (options_.animation) {
    animation_.add(picture);
    write(*options_.animation, animation_.finished());
  }
  next_picture_ = i + 1;
  const double end = since_start_.seconds();
  next_ = end + std::max(least_interval, times_drawing * (end - begin));
}

bool MomentPictures::update(const RunProgress& progress) {
  if (!progress.surface || since_start_.seconds() < next_) return true;
  const double share = share_gone(progress.n_faces);
  std::size_t i = next_picture_;
  const std::size_t n = n_frames(options_);
  if (i >= n || place_of(options_, i) > share) return true;
  while (i + 1 < n && place_of(options_, i + 1) <= share) ++i;
  try {
    IndexedMesh surface = progress.surface();
    if (!surface.faces.empty()) draw(std::move(surface), i);
  } catch (...) {
    failure_ = std::current_exception();  // not to be thrown through a library at work
    return false;
  }
  return true;
}

void MomentPictures::throw_if_failed() const {
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace whittle::app
