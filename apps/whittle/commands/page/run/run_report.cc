#include "commands/page/run/run_report.hh"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "whittle/io/errors.hh"
#include "whittle/io/path_of.hh"
#include "whittle/io/whole_file.hh"

namespace whittle::app {
namespace {

using Counts = std::span<const std::optional<std::uint64_t>>;

/// A number of a report. Empty if the report has none there. \param key "/input/faces"
std::optional<std::uint64_t> count_in(const Json& report, const char* key) {
  const Json::json_pointer place(key);
  if (!report.contains(place) || !report.at(place).is_number_unsigned()) return std::nullopt;
  return report.at(place).get<std::uint64_t>();
}

/// Of all reports, those of `simplify` alone have all of these.
bool is_of_simplify(const Json& report) {
  const auto has = [&report](const char* key) { return count_in(report, key).has_value(); };
  return has("/input/faces") && has("/output/faces") && has("/contractions");
}

/// Those that didn't fail.
std::vector<Json> runs_of(const Json& report) {
  std::vector<Json> runs;
  if (is_of_simplify(report)) return {report};
  const auto several = report.find("runs");
  if (several == report.end() || !several->is_array()) return runs;
  std::copy_if(several->begin(), several->end(), std::back_inserter(runs), is_of_simplify);
  return runs;
}

bool is_like(std::optional<std::uint64_t> count, std::optional<std::uint64_t> other) {
  return !count || !other || count == other;
}

bool fits(const Json& run, Counts n_faces) {
  const bool is_pruned = count_in(run, "/output/pruned_components").value_or(0) > 0;
  if (!is_pruned && !is_like(count_in(run, "/input/faces"), n_faces.front())) return false;
  const Counts results = n_faces.subspan(1);
  return results.empty() || std::any_of(results.begin(), results.end(), [&run](std::optional<std::uint64_t> n) {
           return is_like(count_in(run, "/output/faces"), n);
         });
}

/// "wrote 400 or 100 faces". Empty if no number is known.
std::string did_text(const std::string& verb, Counts counts) {
  std::string numbers;
  for (const std::optional<std::uint64_t> n : counts) {
    if (n) numbers += (numbers.empty() ? "" : " or ") + std::to_string(*n);
  }
  return numbers.empty() ? numbers : verb + ' ' + numbers + " faces";
}

}  // namespace

Json read_report_of_simplify(const std::string& path) {
  Json json = Json::parse(io::read_file(io::path_of(path), path), nullptr, false);
  if (!json.is_object()) throw io::ReadError(path, "is no report: its text is no JSON object");
  if (runs_of(json).empty()) throw io::ReadError(path, "is no report of a run: 'simplify --json' writes such");
  return json;
}

std::string doubt_about_run(const Json& report, Counts n_faces) {
  const std::vector<Json> runs = runs_of(report);
  if (std::any_of(runs.begin(), runs.end(), [n_faces](const Json& run) { return fits(run, n_faces); })) return {};
  const std::string read = did_text("read", n_faces.first(1));
  const std::string wrote = did_text("wrote", n_faces.subspan(1));
  return "may be of other meshes: has no run that " + read + (read.empty() || wrote.empty() ? "" : " and ") + wrote;
}

Json run_of(const Json& report, Counts n_faces) {
  std::vector<Json> runs = runs_of(report);
  const auto found = std::find_if(runs.begin(), runs.end(), [n_faces](const Json& run) { return fits(run, n_faces); });
  return std::move(found == runs.end() ? runs.front() : *found);
}

}  // namespace whittle::app
