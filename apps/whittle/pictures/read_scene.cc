#include "pictures/read_scene.hh"

#include <utility>

#include "files/gltf_file.hh"

namespace whittle::app {

ReadScene read_scene(const Input& input) {
  if (input.gltf) return scene_of(input.gltf->asset());
  ReadScene read;
  render::Part part;
  part.mesh = &input.read.mesh;
  part.materials.resize(1);
  part.materials.front().double_sided = true;
  part.vertex_colors = render::ColorEncoding::srgb;
  read.scene.parts.push_back(std::move(part));
  return read;
}

}  // namespace whittle::app
