#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "options/command_line.hh"
#include "terminal/talk.hh"
#include "whittle/io/read.hh"

namespace whittle::app {

class GltfFile;
enum class GltfScope;

/// The name of the standard streams on the command line.
inline constexpr std::string_view standard_stream = "-";
inline constexpr char standard_input_name[] = "standard input";

/// Whether an input is read as glTF.
bool reads_gltf(const std::string& path, const FileOptions& options);

/// The format by the extension of a file name, if it has a known one.
std::optional<io::Format> format_by_name(const std::string& path);

/// The format to write a file in: that of --output-format, otherwise the one by its name, otherwise that of --format.
/// \throw UsageError if there is neither, or if --ascii is given and the format has no choice of text.
io::Format format_for_output(const std::string& path, const FileOptions& options);

/// \throw io::ReadError if an input is glTF, and the command doesn't read it
/// \throw UsageError if an output is glTF, and the command doesn't write it; if two inputs are standard input, if one
/// is and nothing tells its format, or if --format is
///        given although names and other options tell every format; as `format_for_output` for each output.
void check_formats(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                   const FileOptions& options);

/// A mesh file that may be read more than once. The content of standard input is kept, because it can be read only
/// once.
class MeshFile {
 public:
  MeshFile(std::string path, const FileOptions& options);
  /// \param weld in place of that of the options \param threads 0 = all cores
  /// \throw io::ReadError also for glTF without triangles, unless the options take it
  io::ReadResult read(bool weld, unsigned threads,
                      io::AttributeScope attributes = io::AttributeScope::per_vertex) const;
  /// The name in messages: the path, or "standard input".
  std::string name() const { return path_ == standard_stream ? standard_input_name : path_; }
  /// If it is a glTF file: that, to be written again.
  const std::shared_ptr<GltfFile>& gltf() const { return gltf_; }

 private:
  std::string path_;
  std::optional<io::Format> format_;
  bool takes_no_triangles_;
  GltfScope scope_;
  std::vector<char> standard_input_;
  std::shared_ptr<GltfFile> gltf_;
};

/// Of a mesh that was read from a file: "ply", "gltf".
std::string format_name(const io::ReadResult& read, const MeshFile& file);
/// For sentences: "PLY", "glTF".
std::string format_title(const io::ReadResult& read, const MeshFile& file);

/// Welds vertices that lie near each other, if `tolerance` asks for that. \return to which length, model units; 0: not
double weld_gaps(io::ReadResult& read, const AutomaticLength& tolerance, unsigned threads);

/// A mesh that was read from a file, and what is known of the file.
struct Input {
  std::string path;  ///< as on the command line
  std::string name;  ///< in messages: the path, or "standard input"
  io::ReadResult read;
  std::vector<std::string> warnings;  ///< those of `read`, with the name in front
  double seconds = 0;                 ///< that reading took
  double weld_tolerance = 0;          ///< to which vertices were welded, model units; 0 = exact duplicates alone
  std::string format{};               ///< `format_name`
  std::shared_ptr<GltfFile> gltf{};   ///< as `MeshFile::gltf`
  std::string mesh_name{};            ///< what new glTF files call the mesh
  std::vector<std::filesystem::path> needed_files{};  ///< beside it: buffers, material libraries, textures
  std::vector<std::string> joined{};  ///< the files that it was joined of (`read_joined`), `path` first; or empty
};

/// Whether an input is a glTF file that keeps its meshes, each by itself.
bool keeps_meshes(const Input& input);

/// "NAME: TEXT": a line about a file.
std::string about(const std::string& name, const std::string& text);
/// "a, b, c"
std::string listed(const std::vector<std::string>& names);

/// Reads a mesh. Prints what was repaired and what is not carried.
/// \param attributes all, for what can take wedges and groups \throw io::ReadError as `io::read_mesh`.
Input read_input(const std::string& path, const FileOptions& options, unsigned threads, const Talk& talk,
                 io::AttributeScope attributes = io::AttributeScope::per_vertex);

}  // namespace whittle::app
