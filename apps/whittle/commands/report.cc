#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "commands/page/make_page.hh"
#include "commands/subcommands.hh"
#include "files/output.hh"
#include "options/page_settings.hh"
#include "pictures/animation.hh"
#include "pictures/compare_pictures.hh"
#include "pictures/frames.hh"
#include "system/system.hh"
#include "terminal/table.hh"
#include "whittle/core/progress.hh"

namespace whittle::app {
namespace {

PictureSize parse_picture_size(std::string_view text) {
  constexpr std::uint64_t least = 64;
  constexpr std::uint64_t most = 8192;
  const std::size_t x = text.find('x');
  if (x == std::string_view::npos) {
    throw std::invalid_argument("'" + std::string(text) + "' is not of the form WxH, such as 1280x720");
  }
  return {parse_count(text.substr(0, x), least, most), parse_count(text.substr(x + 1), least, most)};
}

void check(const ReportCommand& options) {
  if (!options.output && !options.png && !options.frames.is_given()) {
    throw UsageError("one of --output, --png, --frames and --animate is needed");
  }
  if (options.open && !options.output) throw UsageError("--open needs --output: the page to open");
  std::vector<Output> outputs = frame_outputs(options.frames);
  if (options.output) outputs.push_back({"--output", *options.output});
  if (options.png) outputs.push_back({"--png", *options.png});
  if (options.common.json) outputs.push_back({"--json", *options.common.json});
  std::vector<std::string> inputs = options.files;
  if (options.run) inputs.push_back(*options.run);
  check_outputs(outputs, inputs, options.common.force);
  require_page();
  if (options.png) require_pictures();
  require_frames(options.frames);
}

Json report_json(const ReportCommand& options, const PageFacts& facts, std::size_t n_bytes, double total_seconds) {
  Json json = new_report();
  json["output"] = options.output ? Json(*options.output) : Json(nullptr);
  json["png"] = options.png ? Json(*options.png) : Json(nullptr);
  json["bytes"] = n_bytes;
  json["meshes"] = facts.meshes;
  json["recording"] = facts.recording;
  json["seconds"] = {{"read", facts.read_seconds}, {"measure", facts.measure_seconds}, {"total", total_seconds}};
  json["peak_rss_bytes"] = peak_memory_bytes();
  json["warnings"] = facts.warnings;
  return json;
}

std::string draw_png(const ReportCommand& options, ShownMeshes& shown, const Talk& talk, PageFacts& facts) {
  std::vector<std::string> warnings;
  std::string png =
      png_file(draw_meshes(shown, picture_view(options.view), options.png_size, options.common.threads, warnings));
  for (const std::string& warning : warnings) {
    talk.warning(warning);
    facts.warnings.push_back(warning);
  }
  return png;
}

ExitCode run_report(const Given& /*given*/, ReportCommand options) {
  check(options);
  const Talk talk = options.common.talk();
  const Stopwatch watch;
  PageFacts facts;
  MadePage made = make_page(options, talk, facts);
  const std::string page = std::move(made.html);
  if (options.frames.is_given() && facts.recording.is_null()) {
    throw UsageError("--frames and --animate need a recording, and one whose input has at most --max-faces");
  }
  OutputFiles files(options.common.force);
  const auto write = [&files](const std::string& path, const std::string& bytes) {
    files.write(path, [&bytes](std::ostream& out) { out << bytes; });
  };
  if (options.png) write(*options.png, draw_png(options, made.shown, talk, facts));
  if (options.output) write(*options.output, page);
  write_frames(files, options.frames, made.shown, {options.view, options.png_size, options.common.threads}, talk);
  commit_with_report(files, options.common, [&] { return report_json(options, facts, page.size(), watch.seconds()); });
  constexpr double per_megabyte = 1e6;
  constexpr double decimals = 10;
  const std::string size =
      shortest(std::ceil(static_cast<double>(page.size()) / per_megabyte * decimals) / decimals) + " MB";
  const std::optional<std::string> shown = options.output             ? options.output
                                           : options.png              ? options.png
                                           : options.frames.animation ? options.frames.animation
                                                                      : options.frames.frames;
  talk.say(shown_output(*shown) + ": " + counted(facts.meshes.size(), "mesh", "meshes") +
           (options.output ? ", " + size : std::string()) + " in " + seconds_text(watch.seconds()));
  say_effort(talk, watch.seconds());
  if (options.open && !open_on_desktop(*options.output)) talk.warning("--open: no program was found that opens it");
  return ExitCode::done;
}

OptionRows report_rows(ReportCommand& options) {
  const auto set_size = [&options](std::string_view text) { options.png_size = parse_picture_size(text); };
  const auto set_view = [&options](std::string_view text) { options.view = parse_page_settings(text); };
  const auto none = [] { return OptionValue{}; };
  OptionRows rows{
      meshes_argument(options.files, options.files_options,
                      "several are the original and results of it, of which one may be a recording"),
      {.names = "-o,--output",
       .access = text(options.output, "OUT"),
       .help = "the page: an .html file, replaced if it exists, or '-' for standard output"},
      side_file_row("--png", options.png, "draw a picture of what the page shows"),
      {.names = "--png-size", .access = {"WxH", set_size, none}, .help = "of pictures, pixels", .standard = "1280x720"},
      {.names = "--view",
       .access = {"KEY=VALUE,...", set_view, none},
       .help = "how pictures are set up, such as layout=over,colour=error: the names of the page's controls",
       .standard = "as the page opens"},
      side_file_row("--run", options.run,
                    "show what 'simplify --json' has written: what was asked, reached and refused"),
      {.names = "--max-faces",
       .access = count(options.most_faces),
       .help = "show a coarser level of meshes with more faces"}};
  append(rows, frame_rows(options.frames));
  rows.push_back({.names = "--open", .access = flag(options.open), .help = "open the page on the desktop"});
  append(rows, input_rows(options.files_options));
  append(rows, common_rows(options.common));
  return rows;
}

}  // namespace

void setup_report(CLI::App& app, Command& command) {
  const SubcommandText text{"report", "Write a page to look at meshes, their error and a recording.",
                            "IN [OUT...] -o PAGE [OPTION]...",
                            "Examples:\n"
                            "  whittle report dragon.ply small.ply -o page.html\n"
                            "  whittle report dragon.ply dragon.rec -o page.html --run dragon.json\n"
                            "  whittle report dragon.ply small.ply --png error.png --view colour=error\n"
                            "  whittle report dragon.rec --animate dragon.webp --every 2%"};
  ReportCommand defaults;
  defaults.files_options.reads_documents = true;
  defaults.files_options.scope = SceneScope::scene;
  add_subcommand(app, text, defaults, report_rows, run_report, command);
}

}  // namespace whittle::app
