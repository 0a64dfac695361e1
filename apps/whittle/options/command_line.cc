#include "options/command_line.hh"

#include <algorithm>
#include <array>

#include "options/help.hh"
#include "options/values.hh"

namespace whittle::app {
namespace {

constexpr char default_group[] = "Options";  // CLI11's name of the group of options without one

constexpr std::array<Choice<ColorMode>, 3> color_modes{
    {{"auto", ColorMode::automatic}, {"always", ColorMode::always}, {"never", ColorMode::never}}};

io::Format parse_format(std::string_view text) {
  for (const io::Format format : io::all_formats) {
    if (io::name_of(format) == text) return format;
  }
  throw std::invalid_argument("'" + std::string(text) + "' is none of " + io::format_names("|"));
}

/// Nothing for glTF, which is remembered in `options`.
std::optional<io::Format> parse_input_format(std::string_view text, FileOptions& options) {
  const bool names_gltf = std::find(gltf_names.begin(), gltf_names.end(), text) != gltf_names.end();
  options.input_is_gltf = options.reads_gltf && names_gltf;
  if (options.input_is_gltf) return std::nullopt;
  try {
    return parse_format(text);
  } catch (const std::invalid_argument& error) {
    if (options.reads_gltf) throw std::invalid_argument(error.what() + std::string("|glb|gltf"));
    if (!names_gltf) throw;
    throw std::invalid_argument(error.what() + std::string("; this command doesn't read glTF, 'whittle convert' does"));
  }
}

template <class Paths>
CLI::Option* add_argument(CLI::App& app, const std::string& name, Paths& paths, const std::string& description) {
  return app.add_option(name, paths, description)->required()->type_name("")->group("Arguments");
}

/// "EXT", or "EXT|glb|gltf" where the command takes glTF
std::string input_format_type(const FileOptions& options) {
  std::string type = "EXT";
  if (!options.reads_gltf) return type;
  for (const std::string_view name : gltf_names) type += '|' + std::string(name);
  return type;
}

std::string mesh_file(const FileOptions& options) {
  const std::string gltf = options.reads_gltf ? ", glTF" : "";
  return "the mesh: an " + io::format_titles() + " file" + gltf + ", or '-' for standard input";
}

CLI::Option* add_format_option(CLI::App& app, const std::string& name, std::optional<io::Format>& format,
                               const std::string& description) {
  return add_value(
             app, name, "EXT", format, [](std::string_view text) { return parse_format(text); }, description)
      ->default_str("by name");
}

/// Adds --weld and --no-weld.
void add_weld_options(CLI::App& app, FileOptions& options, const std::string& group) {
  add_weld(app, options, group);
  app.add_flag_callback(
         "--no-weld", [&options] { options.weld = false; },
         "keep exact duplicates of vertices apart instead of making them one")
      ->default_str("off")
      ->group(group);
}

}  // namespace

bool is_given(const CLI::App& app, std::string_view side) {
  const std::size_t space = side.find(' ');
  const CLI::Option* option = app.get_option_no_throw(std::string(side.substr(0, space)));
  if (option == nullptr || option->count() == 0) return false;
  return space == std::string_view::npos || option->results().front() == side.substr(space + 1);
}

void add_common_options(CLI::App& app, CommonOptions& options) {
  add_value(
      app, "--json", "FILE|-", options.json, [](std::string_view text) { return std::string(text); },
      "write the report as JSON to FILE, or to standard output")
      ->default_str("off")
      ->group(common_group);
  app.add_flag("-q,--quiet", options.quiet, "say nothing but errors on standard error")
      ->default_str("off")
      ->group(common_group);
  app.add_flag("-v,--verbose", options.verbose, "say more on standard error")->default_str("off")->group(common_group);
  app.add_flag("--force", options.force, "let an output file replace an input file, or one that is write-protected")
      ->default_str("off")
      ->group(common_group);
  add_value(
      app, "--threads", "N", options.threads,
      [](std::string_view text) { return static_cast<unsigned>(parse_count(text, 0, 1024)); },
      "threads to work with, 0 <= N <= 1024; 0 takes all cores; no result depends on it")
      ->default_str(std::to_string(options.threads))
      ->group(common_group);
  add_value(
      app, "--color", words_of<ColorMode>(color_modes), options.color,
      [](std::string_view text) { return parse_choice<ColorMode>(text, color_modes); },
      "colour on standard error: on a terminal, unless NO_COLOR is set (auto), always, or never")
      ->default_str("auto")
      ->group(common_group);
  app.set_help_flag("-h,--help", "print this help")->group(common_group);
}

ColorMode color_of(const CLI::App& app) {
  ColorMode mode = ColorMode::automatic;
  for (const CLI::App* called : app.get_subcommands()) {
    const CLI::Option* option = called->get_option_no_throw("--color");
    if (option == nullptr || option->count() == 0) continue;
    for (const Choice<ColorMode>& choice : color_modes) {
      if (choice.word == option->results().front()) mode = choice.value;
    }
  }
  return mode;
}

void refuse_values_of_flags(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (!takes_value(*option)) option->disable_flag_override();
  }
  for (CLI::App* sub : app.get_subcommands({})) refuse_values_of_flags(*sub);
}

void set_usage(CLI::App& app, const std::string& usage) { app.get_option("--help")->option_text(usage); }

void add_input_formats(CLI::App& app, FileOptions& options, const std::string& group) {
  add_format_option(app, "--format", options.format,
                    "the format, such as ply, of '-' and of files whose name doesn't tell it")
      ->group(group);
  add_value(
      app, "--input-format", input_format_type(options), options.input_format,
      [&options](std::string_view text) { return parse_input_format(text, options); },
      "the format to read, whatever a file's name says")
      ->default_str("by name")
      ->group(group);
}

void add_weld(CLI::App& app, FileOptions& options, const std::string& group) {
  add_value(
      app, "--weld", "T|auto", options.weld_tolerance,
      [](std::string_view text) { return parse_automatic_length(text, "T"); },
      "weld vertices on open borders that lie within T of each other: model units, a percentage of the diagonal, or "
      "'auto' to choose T from the gaps between borders (0: exact duplicates alone)")
      ->default_str("0")
      ->group(group);
}

void add_input_options(CLI::App& app, FileOptions& options) {
  add_input_formats(app, options, default_group);
  add_weld_options(app, options, default_group);
}

void add_file_options(CLI::App& app, FileOptions& options, const std::string& group) {
  add_input_formats(app, options, group);
  add_format_option(app, "--output-format", options.output_format, "the format to write, whatever the name of OUT says")
      ->group(group);
  app.add_flag("--ascii", options.ascii, "write text instead of binary data: " + io::titles_with_text_and_binary())
      ->default_str("off")
      ->group(group);
  add_weld_options(app, options, group);
}

void add_compress(CLI::App& app, bool& compresses_gltf, const std::string& group) {
  app.add_flag("--compress", compresses_gltf,
               "compress the geometry of a glTF file: rounded, and by EXT_meshopt_compression")
      ->default_str("off")
      ->group(group);
}

CLI::Option* add_file(CLI::App& app, const std::string& name, std::string& path, const std::string& description) {
  return add_argument(app, name, path, description);
}

void add_mesh_file(CLI::App& app, std::string& path, const FileOptions& options) {
  add_argument(app, "IN", path, mesh_file(options));
}

void add_mesh_files(CLI::App& app, std::vector<std::string>& paths, const FileOptions& options) {
  add_argument(app, "IN", paths, mesh_file(options) + "; several if OUT has '{stem}'");
}

void check_conflicts(const CLI::App& app, std::span<const Conflict> conflicts) {
  for (const Conflict& conflict : conflicts) {
    if (!is_given(app, conflict.first) || !is_given(app, conflict.second)) continue;
    throw UsageError(conflict.first + " doesn't go with " + conflict.second + ": " + conflict.why);
  }
}

std::vector<std::string> find_idle_options(const CLI::App& app, std::span<const IdleOption> options) {
  std::vector<std::string> warnings;
  for (const auto& [option, without, with] : options) {
    if (!is_given(app, option)) continue;
    const auto warn = [&warnings, &name = option](const char* how, const std::string& other) {
      std::string warning = "'";
      warning.append(name).append("' does nothing ").append(how).append(" '").append(other).append("'");
      warnings.push_back(warning);
    };
    if (!without.empty() && !is_given(app, without)) warn("without", without);
    if (!with.empty() && is_given(app, with)) warn("with", with);
  }
  return warnings;
}

std::span<const Conflict> common_conflicts() {
  static const std::array<Conflict, 2> conflicts{{{"--quiet", "--verbose", "say less or say more"},
                                                  {"--weld", "--no-weld", "vertices are welded or they are not"}}};
  return conflicts;
}

}  // namespace whittle::app
