#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "whittle/scene/errors.hh"
#include "whittle/scene/scene.hh"

namespace whittle {

/// Makes several files one mesh: their meshes one after the other, none joined to another. Vertices and faces are
/// counted through all files. What not all files have (normals, colours, attributes, materials' textures) is left out,
/// with a warning. The face attribute "o" says which file a face is from.
class SceneJoiner {
 public:
  /// \param scene of a format with one mesh (`SceneFormat::mesh_format`)
  /// \throw UnsupportedMesh for materials or textures that one file can't name: those of two folders, or of one name in
  /// different libraries; if the vertices or faces are too many
  void add(Scene scene);
  /// \pre one was added, or more
  Scene finish();

 private:
  void join(Scene more);
  void refuse_conflicts(const Scene& more) const;

  Scene all_;
  std::vector<std::string> paths_;
  std::set<std::string> dropped_;                              ///< names of what not all have
  std::map<std::string, std::vector<std::string>> libraries_;  ///< of the file that a material came with
};

}  // namespace whittle
