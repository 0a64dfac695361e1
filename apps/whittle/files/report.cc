#include "files/report.hh"

#include <ostream>
#include <sstream>

#include "files/input.hh"
#include "files/mesh_output.hh"
#include "files/output.hh"
#include "system/system.hh"
#include "terminal/table.hh"
#include "whittle/io/path_of.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::app {
std::string program_and_version() { return "whittle " WHITTLE_VERSION; }

std::string to_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'; }

std::string polish_text(const PolishResult& polish) {
  if (polish.n_passes == 0) return "left as it was, nothing brought the surfaces nearer";
  return std::to_string(polish.n_passes) + (polish.n_passes == 1 ? " pass, " : " passes, ") +
         vertices_text(polish.n_moved) + " moved, rms distance " + significant(polish.rms_before) + " -> " +
         significant(polish.rms_after);
}

void say_effort(const Talk& talk, double seconds) {
  talk.detail(seconds_text(seconds) + " in all, " + std::to_string(peak_memory_bytes() >> 20) +
              " MiB of memory at most");
}

std::string short_name(const std::string& path) { return io::path_of(path).filename().string(); }

std::string shown_output(const std::string& path) { return path == standard_stream ? standard_output_name : path; }

void commit_with_report(OutputFiles& files, const CommonOptions& options, const std::function<Json()>& json,
                        const std::string& text) {
  const std::string report = options.json ? to_text(json()) : std::string();
  const bool json_to_stream = options.json == standard_stream;
  if (options.json && !json_to_stream) files.write(*options.json, [&report](std::ostream& out) { out << report; });
  files.commit();
  print(json_to_stream ? report : text);
}

void write_report(const CommonOptions& options, const std::function<Json()>& json, const std::string& text) {
  OutputFiles files(options.force);
  commit_with_report(files, options, json, text);
}

}  // namespace whittle::app
