#pragma once

#include <string>
#include <vector>

#include "whittle/io/read.hh"
#include "whittle/scene/errors.hh"
#include "whittle/scene/format.hh"
#include "whittle/scene/length.hh"
#include "whittle/scene/scene.hh"

namespace whittle {

/// A file that may be read more than once. The content of standard input is kept, because it can be read only once.
class SceneFile {
 public:
  /// \param path of the file, or `standard_stream` \param format null: by the file's name
  /// \throw io::ReadError if standard input can't be read
  explicit SceneFile(std::string path, const SceneFormat* format = nullptr);

  /// \throw io::ReadError if the file isn't a complete and valid file of its format, or has no triangles (unless the
  ///        options allow it); UnsupportedMesh if a coordinate is too large to compute with
  Scene read(const SceneReadOptions& options) const;

  const std::string& path() const { return path_; }
  /// Name in messages: the path, or "standard input".
  std::string name() const;
  /// The content of standard input.
  const std::vector<char>& content() const { return content_; }
  /// Null if neither the caller nor the file's name gives it.
  const SceneFormat* format() const { return format_; }

 private:
  std::string path_;
  const SceneFormat* format_;
  std::vector<char> content_;
};

/// A scene of a mesh in memory, repaired and welded as one of a file. It has no path.
/// \param mesh as for `io::take_mesh` \param tolerances V; or empty
/// \throw as `SceneFile::read`
Scene scene_of(IndexedMesh mesh, const std::string& name, std::vector<double> tolerances,
               const SceneReadOptions& options = {});

/// The file of a scene, read again as its document shows it (`SceneScope::scene`). \throw as `SceneFile`
IndexedMesh shown_scene(const Scene& scene, SceneReadOptions options);

/// Reads a scene from a file, repairs it (`io::repair`) and welds it. \throw as `SceneFile`
Scene read_scene(const std::string& path, const SceneReadOptions& options = {});

}  // namespace whittle
