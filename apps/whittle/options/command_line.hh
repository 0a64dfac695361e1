#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "options/subcommand.hh"
#include "terminal/errors.hh"
#include "terminal/talk.hh"
#include "whittle/io/format.hh"
#include "whittle/simplify/option.hh"

namespace whittle::app {

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
/// The last rows of a subcommand: help lists groups in the order of their first rows.
OptionRows common_rows(CommonOptions& options);
/// What --color says, also if the rest of the command line is wrong. \param app after parsing
ColorMode color_of(const CLI::App& app);

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

/// --format and --input-format, which takes glTF where the command does.
/// \pre `FileOptions::reads_gltf` is set
OptionRows input_format_rows(FileOptions& options);
OptionRow weld_row(FileOptions& options);
/// --format, --input-format, --weld and --no-weld: how meshes are read.
OptionRows input_rows(FileOptions& options);
/// Those and --output-format and --ascii: how meshes are read and written.
OptionRows file_rows(FileOptions& options);
/// --compress.
OptionRow compress_row(bool& compresses_gltf);

/// A file to write besides the result: off, or its name. \param what "write …"
OptionRow side_file_row(const std::string& name, std::optional<std::string>& path, const std::string& what);
/// -o, --output
OptionRow output_row(std::string& path, const std::string& meaning);

/// An argument that names a mesh file. \param name "REF"
OptionRow file_argument(const std::string& name, std::string& path, const std::string& meaning);
/// The argument IN: the mesh file to work on. Its help lists the formats. \param options whether glTF is read
OptionRow mesh_argument(std::string& path, const FileOptions& options);
/// Likewise for one file or several.
OptionRow meshes_argument(std::vector<std::string>& paths, const FileOptions& options);

/// The rows with a title of the group.
OptionRows in_group(OptionRows rows, const std::string& group);

}  // namespace whittle::app
