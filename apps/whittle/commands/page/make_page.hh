#pragma once

#include "commands/page/report_options.hh"
#include "files/input.hh"
#include "files/report.hh"
#include "pictures/draw_meshes.hh"
#include "terminal/talk.hh"
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

/// \throw std::runtime_error if this program was built without the viewer of the page
void require_page();

/// Whether this program was built with the viewer of the page.
bool has_page();

/// A page, and what is in it.
struct MadePage {
  std::string html;
  ShownMeshes shown;
};

/// \pre `has_page()`
MadePage make_page(const ReportCommand& options, const Talk& talk, PageFacts& facts);

}  // namespace whittle::app
