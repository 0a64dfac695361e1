#pragma once

#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/gltf/write_options.hh"
#include "whittle/io/format.hh"
#include "whittle/io/output_files.hh"
#include "whittle/io/read.hh"
#include "whittle/scene/length.hh"
#include "whittle/scene/scene.hh"

namespace whittle {

class SceneFile;

/// The meshes to read from a document. If its scene shows none, all meshes are read as they are in the document. Files
/// of other formats have one mesh.
enum class SceneScope {
  meshes,  ///< Each mesh once, at its largest place in the scene, or as in the file. Without levels of detail.
  shown,   ///< Each mesh that the scene shows, once.
  scene    ///< The scene as shown: a mesh once per node that uses it.
};

struct SceneReadOptions {
  bool weld = true;                  ///< exact duplicates of vertices on open borders
  AutomaticLength weld_tolerance{};  ///< largest distance of welded vertices on open borders; 0 = exact duplicates only
  SceneScope scope = SceneScope::meshes;
  bool takes_no_triangles = false;  ///< whether to read a document without triangles, as a mesh without faces
  io::AttributeScope attributes = io::AttributeScope::all;
  unsigned threads = 0;  ///< 0 = all cores; the result is the same for any number
};

/// A file to write a scene to.
struct SceneOutput {
  std::string path;  ///< or `standard_stream`
  const SceneFormat* format = nullptr;
  bool ascii = false;         ///< text instead of binary, in formats that have both
  gltf::WriteOptions gltf{};  ///< in formats that `is_document`
  /// A file for what several outputs of a scene have in common, in documents of text (`gltf::WriteOptions`). Empty:
  /// each has all of it.
  std::string shared_path{};
  /// Largest error on a screen with which a level of detail takes over from a finer one, as a share of its height.
  double level_error_rel = 1.0 / 1080;
};

/// Messages about a written scene: a line each, with the name of the file in front.
struct SceneMessages {
  std::vector<std::string> notes;     ///< further actions, such as files copied
  std::vector<std::string> warnings;  ///< lost content
};

/// Coarser levels of detail of a mesh, finest first.
using CoarserLevels = std::span<const IndexedMesh* const>;

/// A file format, with its functions to read and write scenes. A format outside of `io` has its row among its own
/// sources, and is listed in src/formats.cc. read_scene.hh and write_scene.hh call the functions.
struct SceneFormat {
  std::string_view name;                         ///< "ply": in reports
  std::string_view title;                        ///< "PLY": for sentences
  std::span<const std::string_view> extensions;  ///< lower case, without the dot; also names in options
  std::optional<io::Format> mesh_format;         ///< format of a file with one mesh
  /// Whether it has a text and a binary form, chosen by `SceneOutput::ascii`.
  bool has_text_and_binary;
  /// Whether it has several meshes, placed by nodes, and other content that stays when meshes are replaced. Documents
  /// aren't read from standard input, nor compressed with gzip.
  bool is_document;
  bool texcoords_grow_down = false;  ///< whether the second texture coordinate grows downwards on the image

  Scene (*read)(const SceneFile& file, const SceneReadOptions& options);
  /// \param mesh null: the document's meshes
  void (*write)(io::OutputFiles& files, const SceneOutput& output, Scene& scene, const IndexedMesh* mesh,
                CoarserLevels levels, SceneMessages& messages);
  IndexedMesh (*as_written)(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                            const SceneReadOptions& options);
  IndexedMesh (*scene_as_written)(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                                  const SceneReadOptions& options);
};

/// The table of formats: formats of `io` first, then documents.
std::span<const SceneFormat* const> scene_formats();

/// Null for an unknown extension.
const SceneFormat* format_by_extension(std::string_view extension);
/// The format by a file's name. Null if unknown.
const SceneFormat* format_by_name(const std::string& path);
/// The row of a mesh format.
const SceneFormat& format_of(io::Format format);

}  // namespace whittle
