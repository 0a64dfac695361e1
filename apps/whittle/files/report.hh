#pragma once

#include <functional>
#include <string>
#include <vector>

#include "files/input.hh"
#include "files/output.hh"
#include "options/command_line.hh"
#include "whittle/pipeline/json.hh"
#include "whittle/polish/polish.hh"

namespace whittle::app {

/// "whittle 0.1.0"
std::string program_and_version();

/// JSON text with a line break at the end. Bytes that aren't UTF-8 (in file names) become U+FFFD.
std::string to_text(const Json& json);

/// "2 passes, 1234 vertices moved, rms distance 0.1 -> 0.09"
std::string polish_text(const PolishResult& polish);

/// If verbose, prints the run's time and peak memory.
void say_effort(const Talk& talk, double seconds);

/// The name in messages: the path, or "standard output".
std::string shown_output(const std::string& path);
/// The name of a file without its folders.
std::string short_name(const std::string& path);

/// Completes the files of a run (`OutputFiles::commit`), with the report where --json says.
/// \param json called if a report is wanted
/// \param text the same for people, printed unless the report goes to standard output
void commit_with_report(OutputFiles& files, const CommonOptions& options, const std::function<Json()>& json,
                        const std::string& text = {});
/// Likewise for a run without other files.
void write_report(const CommonOptions& options, const std::function<Json()>& json, const std::string& text = {});

}  // namespace whittle::app
