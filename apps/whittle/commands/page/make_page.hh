#pragma once

#include "commands/page/report_options.hh"
#include "files/report.hh"
#include "terminal/talk.hh"

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

/// Whether this program was built with the viewer of the page.
bool has_page();

/// The page, as HTML. \pre `has_page()`
std::string make_page(const ReportCommand& options, const Talk& talk, PageFacts& facts);

}  // namespace whittle::app
