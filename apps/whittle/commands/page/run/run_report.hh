#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "files/report.hh"

// What `simplify --json` has written, shown beside meshes.

namespace whittle::app {

/// The report of a run, or that of several runs: an object with "runs".
/// \throw io::ReadError if the file can't be read, or if it is no such report
Json read_report_of_simplify(const std::string& path);

/// For a warning: that no run of a report read the original and wrote one of the results, by their numbers of faces.
/// Empty if one did. What was pruned is not compared with the original.
/// \param n_faces of the original, then of the results; empty: unknown, which any number is like
std::string doubt_about_run(const Json& report, std::span<const std::optional<std::uint64_t>> n_faces);

/// The run of a report that may be of meshes with such numbers of faces, as above; the first one, if none fits.
Json run_of(const Json& report, std::span<const std::optional<std::uint64_t>> n_faces);

}  // namespace whittle::app
