#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "whittle/metrics/distance.hh"
#include "whittle/pipeline/json.hh"
#include "whittle/pipeline/run.hh"
#include "whittle/report/page.hh"

namespace whittle::web {

/// A mesh file that the page works on, from reading it to writing its result. The files are in memory
/// (page/src/memory_files.js). What is drawn has at most `most_shown` faces, so that a browser draws it: of a larger
/// mesh that is a coarser level. What is measured and written is the mesh itself.
class Session {
 public:
  static constexpr std::size_t most_shown = 100'000;  ///< faces

  /// Reads a file. Of a document each mesh is taken once, as a run of the program takes it.
  /// \param observer is told of everything that takes long \throw what `read_scene` throws
  Session(const std::string& path, RunObserver observer);

  /// {"name", "vertices", "faces", "diagonal", "warnings", "format", "formats": [{"id", "name"}]}
  Json facts() const;

  /// Records a fast run down to few faces, from what is drawn of the original: its levels are what a slider shows.
  void record();
  /// The next level of the recording with its sampled error, both ways, from the mesh that was read: {"faces", "mean",
  /// "max"}. First a few over the whole run, then those between. Null when all are measured. \pre `record` was called
  Json measure_next_level();

  /// Does what `whittle simplify FILE --effort EFFORT` does, with one of both targets.
  /// \param n_faces at least 1 \param max_error proven, above 0, model units
  /// \return {"vertices", "faces", "met", "texts", "proven", "seconds"}
  Json simplify(std::optional<std::uint64_t> n_faces, std::optional<double> max_error, Effort effort);

  /// The sampled error of the last result, both ways: {"mean", "max"}; null if it has no faces.
  Json measure_result();

  /// Writes the last result, byte for byte as the program does, in a format by its name. A run whose format takes other
  /// meshes of a document is made again. \return warnings
  std::vector<std::string> write(const std::string& format);

  /// What the viewer shows: the original, the recording, and the last result.
  report::PageData page_data() const { return report::page_data(page_); }

 private:
  struct Done {
    Plan plan;
    Outcome outcome;
  };

  report::PageSurface surface_of(std::string name, const IndexedMesh& mesh) const;
  void list_levels();
  SceneOutput output_of(const SceneFormat& format) const;
  void run(const SceneFormat& format);
  void show_result();
  void throw_unless_done() const;

  std::string path_;
  RunObserver observer_;
  Scene scene_;
  metrics::DistanceReference original_;
  double diagonal_ = 0;
  report::Page page_;
  std::vector<std::size_t> levels_to_measure_;  ///< of the recording, the next one last
  Request request_;                             ///< of the last result
  std::optional<Done> done_;
};

}  // namespace whittle::web
