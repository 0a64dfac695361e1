#include "model/read_materials.hh"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/uri.hh"
#include "model/extensions.hh"
#include "whittle/io/errors.hh"

namespace whittle::gltf {
namespace {

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

Alpha read_alpha_mode(const Part& part) {
  const std::string mode = part.text("alphaMode").value_or("OPAQUE");
  if (mode == "MASK") return Alpha::mask;
  return mode == "BLEND" ? Alpha::blend : Alpha::opaque;
}

}  // namespace

/// \throw io::ReadError if there are fewer
Part MaterialReader::element(std::string_view key, std::string_view label, std::size_t number) const {
  const std::vector<Part> all = root_.array(key, label);
  if (number >= all.size()) root_.fail(std::string(label) + ' ' + std::to_string(number) + " is not there");
  return all[number];
}

void MaterialReader::read_image(std::size_t number, Image& image) const {
  const Part part = element("images", "image", number);
  if (const auto view = part.index("bufferView", model_.views.size(), "buffer view")) {
    image.bytes = model_.views[*view].bytes;
    return;
  }
  const std::string uri = part.required_text("uri");
  if (!is_data_uri(uri)) image.file = file_of_uri(uri).value_or("");
  image.bytes = bytes_of_uri(part, uri, source_);
}

std::shared_ptr<const Image> MaterialReader::image(std::size_t number) {
  std::shared_ptr<const Image>& known = images_[number];
  if (known) return known;
  Image image{.name = "image " + std::to_string(number)};
  try {
    read_image(number, image);
  } catch (const io::ReadError& error) {
    image.problem = error.what();
  }
  return known = std::make_shared<const Image>(std::move(image));
}

/// \return nothing if the texture has no image that the core of glTF knows: only one of an extension
std::optional<Texture> MaterialReader::read_texture(const Part& info) {
  const Part part = element("textures", "texture", info.required_whole("index"));
  const std::optional<std::size_t> image_number = part.whole("source");
  if (!image_number) return {};
  Texture texture;
  std::size_t texcoord = info.whole_or("texCoord", 0);
  if (const auto sampler_number = part.whole("sampler")) {
    const Part sampler = element("samplers", "sampler", *sampler_number);
    texture.wrap = {read_wrap(sampler, "wrapS"), read_wrap(sampler, "wrapT")};
  }
  if (const std::optional<Part> transform = info.extension(texture_transform_extension)) {
    texture.transform = read_transform(*transform);
    texcoord = transform->whole_or("texCoord", texcoord);
  }
  texture.texcoord = "TEXCOORD_" + std::to_string(texcoord);
  texture.image = image(*image_number);
  return texture;
}

/// \param shading one of the models of shading \param factor, texture the names that it has for the base colour
void MaterialReader::read_base_color(const std::optional<Part>& shading, std::string_view factor,
                                     std::string_view texture, Material& material) {
  if (!shading) return;
  if (const auto color = shading->numbers(factor, 4)) {
    for (std::size_t k = 0; k < 4; ++k) material.base_color[k] = std::clamp((*color)[k], 0.0, 1.0);
  }
  if (const std::optional<Part> info = shading->object(texture)) material.base_color_texture = read_texture(*info);
}

Material MaterialReader::read(std::size_t number) {
  const Part part = element("materials", "material", number);
  Material material;
  read_base_color(part.object("pbrMetallicRoughness"), "baseColorFactor", "baseColorTexture", material);
  read_base_color(part.extension(specular_glossiness_extension), "diffuseFactor", "diffuseTexture", material);
  material.alpha_mode = read_alpha_mode(part);
  material.alpha_cutoff = std::max(0.0, part.number("alphaCutoff").value_or(material.alpha_cutoff));
  material.double_sided = part.flag("doubleSided");
  return material;
}

}  // namespace whittle::gltf
