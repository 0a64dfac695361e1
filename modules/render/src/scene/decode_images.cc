#include <set>
#include <stdexcept>

#include "whittle/render/scene.hh"

namespace whittle::render {

const Attribute* texcoords_of(const IndexedMesh& mesh, const Texture& texture) {
  for (const Attribute& attribute : mesh.attributes) {
    if (attribute.name == texture.texcoord && attribute.n_components >= 2) return &attribute;
  }
  return nullptr;
}

std::vector<std::string> decode_images(Scene& scene) {
  std::vector<std::string> problems;
  std::set<std::shared_ptr<const Image>> tried;
  const auto decode = [&](const std::shared_ptr<const Image>& image) {
    if (scene.images.contains(image) || !tried.insert(image).second) return;
    try {
      if (!image->problem.empty()) throw std::runtime_error(image->problem);
      scene.images.emplace(image, read_image(image->bytes));
    } catch (const std::runtime_error& error) {
      problems.push_back(image->name + " is not drawn: " + error.what());
    }
  };
  for (const Part& part : scene.parts) {
    for (const Material& material : part.materials) {
      if (material.base_color_texture) decode(material.base_color_texture->image);
    }
  }
  return problems;
}

}  // namespace whittle::render
