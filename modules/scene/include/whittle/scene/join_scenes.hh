#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "whittle/scene/errors.hh"
#include "whittle/scene/scene.hh"

namespace whittle {

/// Joins several files to one mesh: their meshes in turn, without welding. Vertices and faces are numbered through all
/// files. Content that some files lack (normals, colours, attributes, materials' textures) is left out, with a warning.
/// The face attribute "o" names the file of a face.
class SceneJoiner {
 public:
  /// \param scene of a format with one mesh (`SceneFormat::mesh_format`)
  /// \throw UnsupportedMesh for materials or textures of two folders, or of one name in different libraries, which one
  ///        file can't name; for too many vertices or faces
  void add(Scene scene);
  /// \pre at least one scene was added
  Scene finish();

 private:
  void join(Scene more);
  void refuse_conflicts(const Scene& more) const;

  Scene all_;
  std::vector<std::string> paths_;
  std::set<std::string> dropped_;                              ///< names of content that some files lack
  std::map<std::string, std::vector<std::string>> libraries_;  ///< per material, the libraries of its file
};

}  // namespace whittle
