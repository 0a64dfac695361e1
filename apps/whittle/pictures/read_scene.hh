#pragma once

#include <deque>
#include <string>
#include <vector>

#include "files/input.hh"
#include "whittle/render/scene.hh"

namespace whittle::app {

/// A scene, and the meshes that its parts point to.
struct ReadScene {
  std::deque<IndexedMesh> meshes;
  render::Scene scene;
  std::vector<std::string> warnings;  ///< a line for each texture that isn't drawn
};

/// What a mesh file shows: of glTF all nodes with meshes, each as often as it is there, or all meshes where no node has
/// one; of others the mesh. Textures are read.
/// \param input must outlive the scene
ReadScene read_scene(const Scene& input);

}  // namespace whittle::app
