#pragma once

#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/io/format.hh"
#include "whittle/io/output_files.hh"
#include "whittle/io/read.hh"
#include "whittle/scene/length.hh"
#include "whittle/scene/scene.hh"

namespace whittle {

class SceneFile;

/// What of a document becomes a mesh. If its scene shows none, all meshes do, as the document has them. Files of other
/// formats have one mesh.
enum class SceneScope {
  meshes,  ///< Each mesh once, where the scene shows it largest, or as the file has it. Levels of detail are left out.
  shown,   ///< Likewise, but for meshes that the scene doesn't show.
  scene    ///< What the scene shows: a mesh as often as nodes use it.
};

struct SceneReadOptions {
  bool weld = true;                  ///< exact duplicates of vertices on open borders
  AutomaticLength weld_tolerance{};  ///< also vertices on open borders that are so near; 0 = exact duplicates alone
  SceneScope scope = SceneScope::meshes;
  bool takes_no_triangles = false;  ///< whether a document without triangles is read, as a mesh without faces
  io::AttributeScope attributes = io::AttributeScope::all;
  unsigned threads = 0;  ///< 0 = all cores; the result is the same for any number
};

/// A file to write a scene to.
struct SceneOutput {
  std::string path;  ///< or `standard_stream`
  const SceneFormat* format = nullptr;
  bool ascii = false;     ///< text, in formats that are written as text or as binary data
  bool compress = false;  ///< as `gltf::WriteOptions` has it, in formats that `is_document`
};

/// What is said of a scene that was written: a line each, with the name of the file in front.
struct SceneMessages {
  std::vector<std::string> notes;     ///< what was done besides, such as files copied
  std::vector<std::string> warnings;  ///< what is lost
};

/// Coarser levels of detail of a mesh, the finer ones first.
using CoarserLevels = std::span<const IndexedMesh* const>;

/// All that is known of a file format, and how it reads and writes scenes. A format that isn't one of `io` has its row
/// among its own sources, and is listed in src/formats.cc. The functions are behind read_scene.hh and write_scene.hh.
struct SceneFormat {
  std::string_view name;                         ///< "ply": what reports have
  std::string_view title;                        ///< "PLY": for sentences
  std::span<const std::string_view> extensions;  ///< lower case, without the dot; options take them, too
  std::optional<io::Format> mesh_format;         ///< that of a file with one mesh
  /// Whether it is written as text or as binary data, by `SceneOutput::ascii`. If not, there is one way to write it.
  bool has_text_and_binary;
  /// Whether it has several meshes, placed by nodes, and more, which stays as it is where only the meshes are replaced.
  /// Such files aren't read from standard input, nor packed with gzip.
  bool is_document;

  Scene (*read)(const SceneFile& file, const SceneReadOptions& options);
  /// \param mesh null: as the document has it
  void (*write)(io::OutputFiles& files, const SceneOutput& output, Scene& scene, const IndexedMesh* mesh,
                CoarserLevels levels, SceneMessages& messages);
  IndexedMesh (*as_written)(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                            const SceneReadOptions& options);
};

/// The table of formats: those of `io` first, then documents.
std::span<const SceneFormat* const> scene_formats();

/// Null if there is none.
const SceneFormat* format_by_extension(std::string_view extension);
/// The format by a file's name. Null if the name tells none.
const SceneFormat* format_by_name(const std::string& path);
/// That of a mesh format.
const SceneFormat& format_of(io::Format format);

}  // namespace whittle
