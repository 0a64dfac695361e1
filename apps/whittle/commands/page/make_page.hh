#pragma once

#include "commands/page/report_options.hh"
#include "files/input.hh"
#include "files/report.hh"
#include "terminal/talk.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/run_steps.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::app {

/// What was put into a page, for the report.
struct PageFacts {
  Json meshes = Json::array();  ///< {"path", "vertices", "faces", "shown_faces", "colour_deviation", "max_distance"},
                                ///< the original first
  Json recording = nullptr;     ///< `recording_json`
  double read_seconds = 0;
  double measure_seconds = 0;
  std::vector<std::string> warnings;
};

/// A run of `simplify`, while all of it is known.
struct RunForPage {
  const Scene& input;
  std::string output;
  const Simplification& simplified;  ///< with its steps
  Json report;
  std::string advice;  ///< if the target was missed: why, and what helps
};

/// A page of a run: both meshes, the recording, and what stands in the way of fewer faces. \pre `has_page()`
std::string make_page(const RunForPage& run, const CommonOptions& common, const Talk& talk);

/// A page that plays a run. \param path of the input \param steps of the run \pre `has_page()`
std::string make_player(const std::string& path, const IndexedMesh& input, const RunSteps& steps);

/// \throw std::runtime_error if this program was built without the viewer of the page
void require_page();

/// Whether this program was built with the viewer of the page.
bool has_page();

/// The page, as HTML. \pre `has_page()`
std::string make_page(const ReportCommand& options, const Talk& talk, PageFacts& facts);

}  // namespace whittle::app
