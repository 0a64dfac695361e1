#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "options/values.hh"
#include "terminal/errors.hh"
#include "terminal/exit_code.hh"
#include "terminal/talk.hh"
#include "whittle/io/format.hh"

namespace whittle::app {

/// The work of a subcommand. It runs after the command line has been parsed.
using Command = std::function<ExitCode()>;

/// The options of every subcommand.
struct CommonOptions {
  std::optional<std::string> json;  ///< file for the report, "-" for stdout
  bool quiet = false;
  bool verbose = false;
  bool force = false;    ///< an output may replace an input
  unsigned threads = 0;  ///< 0 = all cores
  ColorMode color = ColorMode::automatic;

  Talk talk() const { return Talk(quiet ? Volume::quiet : verbose ? Volume::verbose : Volume::normal, color); }
};
/// Also adds --help. Call this last: the help lists groups of options in the order in which their first options were
/// added.
void add_common_options(CLI::App& app, CommonOptions& options);
/// What --color says, also if the rest of the command line is wrong. \param app after parsing
ColorMode color_of(const CLI::App& app);
/// Makes "--quiet=3" an error: CLI11 gives flags such values otherwise.
void refuse_values_of_flags(CLI::App& app);
/// Sets the text that follows "Usage: whittle NAME" in the help. It is stored at the option --help, because in CLI11
/// only options can hold such a text.
/// \pre `add_common_options` was called.
void set_usage(CLI::App& app, const std::string& usage);

/// What --input-format calls glTF. Also the extensions of its files.
inline constexpr std::array<std::string_view, 2> gltf_names{"glb", "gltf"};

/// How mesh files are read and written.
struct FileOptions {
  bool weld = true;                    ///< exact duplicates of vertices on open borders
  AutomaticLength weld_tolerance{};    ///< also vertices on open borders that are so near; 0 = exact duplicates alone
  std::optional<io::Format> format{};  ///< of files whose name doesn't tell the format
  std::optional<io::Format> input_format{};   ///< of what is read, whatever its name
  bool input_is_gltf = false;                 ///< what is read is glTF, whatever its name
  std::optional<io::Format> output_format{};  ///< of what is written, whatever its name
  bool ascii = false;                         ///< text, in formats that are written as text or as binary data
  bool reads_gltf = false;                    ///< whether the command takes glTF files
  bool writes_gltf = false;                   ///< whether it writes them
  bool takes_no_triangles = false;            ///< whether glTF without triangles is read, as a mesh without faces
  bool reads_scene = false;                   ///< whether glTF is read as `GltfScope::scene`, else as `meshes`
  bool reads_shown = false;                   ///< whether it is read as `GltfScope::shown`

  /// Whether an option tells the format of what is read, whatever its name.
  bool has_input_format() const { return input_format || input_is_gltf; }
};
// Each takes the group of the help, by default that of options without one.

/// Adds --format and --input-format, which takes glTF where the command does.
/// \pre `FileOptions::reads_gltf` is set
void add_input_formats(CLI::App& app, FileOptions& options, const std::string& group = "Options");
/// Adds --weld.
void add_weld(CLI::App& app, FileOptions& options, const std::string& group = "Options");
/// Adds --format, --input-format, --weld and --no-weld: how meshes are read.
void add_input_options(CLI::App& app, FileOptions& options);
/// Adds those and --output-format and --ascii: how meshes are read and written.
void add_file_options(CLI::App& app, FileOptions& options, const std::string& group = "Options");

/// Adds --compress.
void add_compress(CLI::App& app, bool& compresses_gltf, const std::string& group = "Options");

/// Adds a positional argument that names a file: a mesh, unless it is given the type name FILE.
CLI::Option* add_file(CLI::App& app, const std::string& name, std::string& path, const std::string& description);
/// Adds the argument IN: the mesh file to work on. Its help lists the formats. \param options whether glTF is read
void add_mesh_file(CLI::App& app, std::string& path, const FileOptions& options);
/// Likewise for one file or several.
void add_mesh_files(CLI::App& app, std::vector<std::string>& paths, const FileOptions& options);

/// Adds an option with one value.
/// \param names as CLI11 takes them: "-r,--ratio"; "SHELL" for an argument without a name
/// \param value_name how the help shows the value: "R"
/// \param parse turns the text into the value, or throws std::invalid_argument
template <class T, class Parse>
CLI::Option* add_value(CLI::App& app, const std::string& names, const std::string& value_name, T& target, Parse parse,
                       const std::string& description) {
  const std::size_t long_name = names.find("--");
  const std::string label = names.substr(long_name == std::string::npos ? 0 : long_name);
  const auto take = [&target, parse, label](const CLI::results_t& texts) {
    try {
      target = parse(std::string_view(texts.front()));
    } catch (const std::invalid_argument& error) {
      throw CLI::ValidationError(label, error.what());
    }
    return true;
  };
  return app.add_option(names, take, description)->type_name(value_name);
}

/// Adds an option whose value is one of several words. Its default is the value of `target`.
template <class E, std::size_t N>
CLI::Option* add_choice(CLI::App& app, const std::string& name, E& target, const std::array<Choice<E>, N>& choices,
                        const std::string& description) {
  const std::span<const Choice<E>> all(choices);
  return add_value(
             app, name, words_of(all), target, [all](std::string_view text) { return parse_choice(text, all); },
             description)
      ->default_str(std::string(word_of(all, target)));
}

/// Whether the command line has `side`: "--option" or "--option value".
bool is_given(const CLI::App& app, std::string_view side);

/// Two options, or values of options, that don't go together.
struct Conflict {
  std::string first;
  std::string second;
  std::string why;
};

/// \param conflicts each side as on the command line: "--map", "--boundary free"
/// \throw UsageError that names both sides of the first conflict found
void check_conflicts(const CLI::App& app, std::span<const Conflict> conflicts);

/// An option, or a value of one, that does nothing without another, or with it.
struct IdleOption {
  std::string option;
  std::string without;  ///< empty = `with` is given
  std::string with;     ///< empty = `without` is given
};

/// A warning for each option on the command line that does nothing as things are.
std::vector<std::string> find_idle_options(const CLI::App& app, std::span<const IdleOption> options);

/// Conflicts among the options that every subcommand has.
std::span<const Conflict> common_conflicts();

}  // namespace whittle::app
