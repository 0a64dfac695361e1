// The document is made with accessors of three zeros, and read; then the mesh replaces these.
#include "whittle/gltf/make_asset.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "document/glb.hh"
#include "document/json.hh"
#include "document/uri.hh"
#include "model/scalars.hh"
#include "whittle/core/float32_positions.hh"
#include "whittle/core/geometry/vertex_normals.hh"
#include "whittle/core/wedges.hh"
#include "whittle/version.hh"

namespace whittle::gltf {
namespace {

constexpr std::size_t n_zeros = 48;  // bytes: three times four 32-bit numbers

Json empty_accessor(const char* shape, ScalarType type) {
  Json json = {{"bufferView", 0}, {"componentType", component_type(type)}, {"count", 3}, {"type", shape}};
  if (type != ScalarType::float32) json["normalized"] = true;
  return json;
}

/// Adds accessors for the attributes of the mesh. \return the attributes of its primitives
Json add_accessors(const IndexedMesh& mesh, Json& document) {
  Json& accessors = document["accessors"] = Json::array();
  Json attributes = Json::object();
  const auto add = [&](const std::string& name, const char* shape, ScalarType type = ScalarType::float32) {
    attributes[name] = accessors.size();
    accessors.push_back(empty_accessor(shape, type));
  };
  add("POSITION", "VEC3");
  for (const char* const bound : {"min", "max"}) accessors[0][bound] = {0, 0, 0};
  if (!mesh.normals.empty()) add("NORMAL", "VEC3");
  if (!mesh.colors.empty()) add("COLOR_0", "VEC4", ScalarType::uint16);
  for (const Attribute& attribute : mesh.attributes) {
    add(attribute.name, attribute.kind == AttributeKind::tangent ? "VEC4" : "VEC2");
  }
  return attributes;
}

void add_view(std::string_view bytes, std::string& buffer, Json& document) {
  document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
  buffer += bytes;
  buffer.append((4 - buffer.size() % 4) % 4, '\0');
}

/// The images of the materials, each once.
std::vector<const Image*> images_of(const std::vector<Material>& materials) {
  std::vector<const Image*> images;
  for (const Material& material : materials) {
    const Image* const image = material.base_color_texture ? material.base_color_texture->image.get() : nullptr;
    if (image && std::find(images.begin(), images.end(), image) == images.end()) images.push_back(image);
  }
  return images;
}

/// Whether an asset may name the file of an image: one in its folder, or below it.
bool has_file_inside(const Image& image) {
  return !image.file.empty() && image.file.is_relative() &&
         std::none_of(image.file.begin(), image.file.end(), [](const auto& part) { return part == ".."; });
}

void add_image(const Image& image, bool is_embedded, std::string& buffer, Json& document) {
  const std::u8string name = image.file.generic_u8string();
  const std::string file(name.begin(), name.end());
  document["textures"].push_back({{"source", document["images"].size()}, {"sampler", 0}});
  if (!is_embedded) {
    document["images"].push_back(Json::object({{"uri", uri_of_file(file)}}));
    return;
  }
  document["images"].push_back(
      {{"name", file}, {"mimeType", media_type(image.bytes)}, {"bufferView", document["bufferViews"].size()}});
  add_view(image.bytes, buffer, document);
}

/// \return the bytes of the buffer: the zeros of the accessors, and the images that the asset contains
std::string add_buffer(const NewAsset& asset, Json& document) {
  std::string buffer;
  add_view(std::string(n_zeros, '\0'), buffer, document);
  const std::vector<const Image*> images = images_of(asset.materials);
  for (const Image* image : images) {
    add_image(*image, asset.embeds_images || !has_file_inside(*image), buffer, document);
  }
  if (asset.shading.normal_map) add_image(*asset.shading.normal_map, true, buffer, document);
  constexpr int repeat = 10497;
  if (document.contains("images")) document["samplers"].push_back({{"wrapS", repeat}, {"wrapT", repeat}});
  document["buffers"].push_back(Json::object({{"byteLength", buffer.size()}}));
  return buffer;
}

Json material_json(const Material& material, const Shading& shading, const std::vector<const Image*>& images,
                   bool has_transparency) {
  Color color{};
  const std::array<double, 4> factor = base_color_factor(material);
  std::transform(factor.begin(), factor.end(), color.begin(), [](double share) { return static_cast<float>(share); });
  Json look = {
      {"baseColorFactor", color}, {"metallicFactor", shading.metalness}, {"roughnessFactor", shading.roughness}};
  if (material.base_color_texture) {
    const auto image = std::find(images.begin(), images.end(), material.base_color_texture->image.get());
    look["baseColorTexture"]["index"] = image - images.begin();
  }
  Json json = Json::object();
  if (!material.name.empty()) json["name"] = material.name;
  json["pbrMetallicRoughness"] = std::move(look);
  if (has_transparency || material.alpha_mode == Alpha::blend) json["alphaMode"] = "BLEND";
  if (material.double_sided) json["doubleSided"] = true;
  if (shading.normal_map) json["normalTexture"]["index"] = images.size();
  if (shading.is_unlit) json["extensions"]["KHR_materials_unlit"] = Json::object();
  return json;
}

/// Calls `function` with the mesh, and with each coarser level of it.
template <class Function>
void for_each_level(NewAsset& asset, const Function& function) {
  function(asset.mesh);
  for (IndexedMesh& level : asset.coarser) function(level);
}

/// Leaves out materials of groups without faces, and numbers the groups anew.
void drop_unused(NewAsset& asset) {
  std::vector<Index> numbers(asset.materials.size(), invalid_index);
  for_each_level(asset, [&](IndexedMesh& mesh) {
    if (mesh.face_groups.empty()) mesh.face_groups.assign(mesh.faces.size(), 0);
    for (const Index group : mesh.face_groups) numbers.at(group) = 0;
  });
  std::vector<Material> used;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] == invalid_index) continue;
    numbers[i] = static_cast<Index>(used.size());
    used.push_back(std::move(asset.materials[i]));
  }
  for_each_level(asset, [&](IndexedMesh& mesh) {
    for (Index& group : mesh.face_groups) group = numbers[group];
  });
  asset.materials = std::move(used);
}

/// Leaves texture coordinates and tangents alone, under the names of glTF.
void keep_known_attributes(IndexedMesh& mesh) {
  std::vector<Attribute> kept;
  std::vector<Attribute> tangents;
  for (Attribute& attribute : mesh.attributes) {
    if (attribute.kind == AttributeKind::tangent && tangents.empty()) {
      tangents.push_back(std::move(attribute));
      tangents.front().name = "TANGENT";
      continue;
    }
    if (attribute.kind != AttributeKind::texcoord || attribute.n_components < 2) continue;
    Attribute& own = kept.emplace_back(
        Attribute{.name = "TEXCOORD_" + std::to_string(kept.size()), .kind = attribute.kind, .n_components = 2});
    for (std::size_t w = 0; w < attribute.size(); ++w) {
      const auto value = attribute.value(w);
      own.values.insert(own.values.end(), value.begin(), value.begin() + 2);
    }
  }
  std::move(tangents.begin(), tangents.end(), std::back_inserter(kept));
  mesh.attributes = std::move(kept);
}

/// glTF has unit normals alone.
void fill_in_normals(IndexedMesh& mesh) {
  const auto is_undefined = [](const std::array<float, 3>& n) { return n[0] == 0 && n[1] == 0 && n[2] == 0; };
  if (std::none_of(mesh.normals.begin(), mesh.normals.end(), is_undefined)) return;
  const auto of_faces = vertex_normals(mesh, Frame::of_points(mesh.positions));
  for (std::size_t corner = 0; corner < 3 * mesh.faces.size(); ++corner) {
    auto& normal = mesh.normals[mesh.wedge(corner / 3, corner % 3)];
    if (is_undefined(normal)) normal = of_faces[mesh.faces[corner / 3][corner % 3]];
    if (is_undefined(normal)) normal = {0, 0, 1};
  }
}

void refuse_large(const std::vector<Vec3>& positions) {
  for (const Vec3& p : positions) {
    if (p.cwiseAbs().maxCoeff() > std::numeric_limits<float>::max()) {
      throw std::range_error("a coordinate is too large: glTF has 32-bit numbers");
    }
  }
}

/// \pre the asset has a translation
Json document_of(const NewAsset& asset) {
  Json document = {{"asset", {{"version", "2.0"}, {"generator", "whittle " WHITTLE_VERSION_STRING}}},
                   {"scene", 0},
                   {"scenes", Json::array({Json::object({{"nodes", Json::array({0})}})})},
                   {"nodes", Json::array({{{"name", asset.name}, {"mesh", 0}}})}};
  const Json attributes = add_accessors(asset.mesh, document);
  const bool has_transparency =
      std::any_of(asset.mesh.colors.begin(), asset.mesh.colors.end(), [](const Color& color) { return color[3] < 1; });
  const std::vector<const Image*> images = images_of(asset.materials);
  Json primitives = Json::array();
  for (std::size_t i = 0; i < asset.materials.size(); ++i) {
    document["materials"].push_back(material_json(asset.materials[i], asset.shading, images, has_transparency));
    primitives.push_back({{"attributes", attributes}, {"material", i}});
  }
  if (const Vec3& t = *asset.translation; !t.isZero(0)) document["nodes"][0]["translation"] = {t.x(), t.y(), t.z()};
  if (asset.shading.is_unlit) document["extensionsUsed"] = {"KHR_materials_unlit"};
  document["meshes"].push_back({{"name", asset.name}, {"primitives", std::move(primitives)}});
  return document;
}

}  // namespace

Asset make_asset(NewAsset asset) {
  drop_unused(asset);
  if (!asset.translation) asset.translation = float32_origin(asset.mesh.positions);
  for_each_level(asset, [&](IndexedMesh& mesh) {
    for (Vec3& p : mesh.positions) p -= *asset.translation;
    refuse_large(mesh.positions);
    keep_known_attributes(mesh);
    fill_in_normals(mesh);
  });
  Json document = document_of(asset);
  const std::string buffer = add_buffer(asset, document);
  // Names may come from files without UTF-8: invalid bytes become U+FFFD.
  const std::string json = document.dump(-1, ' ', false, Json::error_handler_t::replace);
  Asset made = Asset::read(join_glb(json, buffer), asset.name);
  if (!asset.coarser.empty()) {
    made.add_levels({{0, std::move(asset.coarser), std::move(asset.screen_coverage)}});
  }
  made.set_triangles(0, std::move(asset.mesh));
  return made;
}

}  // namespace whittle::gltf
