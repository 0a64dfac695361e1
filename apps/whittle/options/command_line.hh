#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "options/subcommand.hh"
#include "terminal/errors.hh"
#include "terminal/talk.hh"
#include "whittle/pipeline/option.hh"
#include "whittle/scene/format.hh"

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
/// The value of --color, also if the rest of the command line is invalid. \param app after parsing
ColorMode color_of(const CLI::App& app);

/// How mesh files are read and written.
struct FileOptions {
  bool weld = true;                     ///< exact duplicates of vertices on open borders
  AutomaticLength weld_tolerance{};     ///< also vertices on open borders that are so near; 0 = exact duplicates alone
  const SceneFormat* format = nullptr;  ///< of files whose name doesn't tell the format; null: not told
  const SceneFormat* input_format = nullptr;   ///< format to read, for any name; or null
  const SceneFormat* output_format = nullptr;  ///< format to write, for any name; or null
  bool ascii = false;                          ///< text, in formats that are written as text or as binary data
  bool reads_documents = false;                ///< whether the command takes documents, such as glTF
  bool writes_documents = false;               ///< whether it writes them
  bool takes_no_triangles = false;             ///< whether a document without triangles is read, as one without faces
  SceneScope scope = SceneScope::meshes;       ///< of documents
};

/// --format and --input-format, which takes documents where the command does.
/// \pre `FileOptions::reads_documents` is set
OptionRows input_format_rows(FileOptions& options);
OptionRow weld_row(FileOptions& options);
/// --format, --input-format, --weld and --no-weld: how meshes are read.
OptionRows input_rows(FileOptions& options);
/// The rows for reading, --output-format and --ascii.
OptionRows file_rows(FileOptions& options);
/// --compress, --quantize and --merge-meshes.
OptionRows gltf_rows(gltf::WriteOptions& options);

/// A file to write besides the result: off, or its name. \param what "write …"
OptionRow side_file_row(const std::string& name, std::optional<std::string>& path, const std::string& what);
/// -o, --output
OptionRow output_row(std::string& path, const std::string& meaning);

/// An argument that names a mesh file. \param name "REF"
OptionRow file_argument(const std::string& name, std::string& path, const std::string& meaning);
/// The argument IN: the mesh file to work on. Its help lists the formats. \param options whether documents are read
OptionRow mesh_argument(std::string& path, const FileOptions& options);
/// Likewise for one file or several. \param several what its help says of several
OptionRow meshes_argument(std::vector<std::string>& paths, const FileOptions& options, const std::string& several);

/// The rows with a title of the group.
OptionRows in_group(OptionRows rows, const std::string& group);

}  // namespace whittle::app
