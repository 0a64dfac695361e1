#include "model/read_materials.hh"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "model/extensions.hh"

namespace whittle::gltf {
namespace {

/// \throw io::ReadError if there are fewer
Part element(const Part& root, std::string_view key, std::string_view label, std::size_t number) {
  const std::vector<Part> all = root.array(key, label);
  if (number >= all.size()) root.fail(std::string(label) + ' ' + std::to_string(number) + " is not there");
  return all[number];
}

/// OpenGL's numbers. Other ones count as the default.
Wrap read_wrap(const Part& sampler, std::string_view key) {
  constexpr std::size_t clamp_to_edge = 33071;
  constexpr std::size_t mirrored_repeat = 33648;
  const std::size_t number = sampler.whole_or(key, 0);
  if (number == clamp_to_edge) return Wrap::clamp_to_edge;
  return number == mirrored_repeat ? Wrap::mirrored_repeat : Wrap::repeat;
}

/// Scale, rotation, offset, in this order. v points down, so that counter-clockwise is from +u to -v.
Eigen::Affine2d read_transform(const Part& part) {
  const auto offset = part.numbers("offset", 2).value_or(std::vector<double>{0, 0});
  const auto scale = part.numbers("scale", 2).value_or(std::vector<double>{1, 1});
  const double rotation = part.number("rotation").value_or(0);
  return Eigen::Translation2d(offset[0], offset[1]) * Eigen::Rotation2Dd(-rotation) *
         Eigen::Scaling(scale[0], scale[1]);
}

/// \return nothing if the texture has no image that the core of glTF knows: only one of an extension
std::optional<TextureUse> read_texture(const Part& root, const Part& info) {
  const Part texture = element(root, "textures", "texture", info.required_whole("index"));
  const std::optional<std::size_t> image = texture.whole("source");
  if (!image) return {};
  TextureUse use;
  use.image = *image;
  use.texcoord = info.whole_or("texCoord", 0);
  if (const auto sampler_number = texture.whole("sampler")) {
    const Part sampler = element(root, "samplers", "sampler", *sampler_number);
    use.wrap_u = read_wrap(sampler, "wrapS");
    use.wrap_v = read_wrap(sampler, "wrapT");
  }
  if (const std::optional<Part> transform = info.extension(texture_transform_extension)) {
    use.transform = read_transform(*transform);
    use.texcoord = transform->whole_or("texCoord", use.texcoord);
  }
  return use;
}

/// \param model one of the models of shading \param factor, texture the names that it has for the base colour
void read_base_color(const Part& root, const std::optional<Part>& model, std::string_view factor,
                     std::string_view texture, Material& material) {
  if (!model) return;
  if (const auto color = model->numbers(factor, 4)) {
    for (std::size_t k = 0; k < 4; ++k) material.base_color[k] = std::clamp((*color)[k], 0.0, 1.0);
  }
  if (const std::optional<Part> info = model->object(texture)) {
    material.base_color_texture = read_texture(root, *info);
  }
}

AlphaMode read_alpha_mode(const Part& part) {
  const std::string mode = part.text("alphaMode").value_or("OPAQUE");
  if (mode == "MASK") return AlphaMode::mask;
  return mode == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

}  // namespace

Material read_material(const Part& root, std::size_t number) {
  const Part part = element(root, "materials", "material", number);
  Material material;
  read_base_color(root, part.object("pbrMetallicRoughness"), "baseColorFactor", "baseColorTexture", material);
  read_base_color(root, part.extension(specular_glossiness_extension), "diffuseFactor", "diffuseTexture", material);
  material.alpha_mode = read_alpha_mode(part);
  material.alpha_cutoff = std::max(0.0, part.number("alphaCutoff").value_or(material.alpha_cutoff));
  material.double_sided = part.flag("doubleSided");
  return material;
}

std::string read_image_bytes(const Model& model, const Part& root, std::size_t number, const Source& source) {
  const Part image = element(root, "images", "image", number);
  if (const auto view = image.index("bufferView", model.views.size(), "buffer view")) {
    return std::string(model.views[*view].bytes);
  }
  return bytes_of_uri(image, image.required_text("uri"), source);
}

}  // namespace whittle::gltf
