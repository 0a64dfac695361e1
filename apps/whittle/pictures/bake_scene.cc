#include "pictures/bake_scene.hh"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <utility>

#include "pictures/read_scene.hh"
#include "terminal/table.hh"
#include "whittle/bake/bake.hh"
#include "whittle/gltf/make_asset.hh"
#include "whittle/io/errors.hh"
#include "whittle/render/picture.hh"
#include "whittle/scene/errors.hh"
#include "whittle/scene/gltf_asset.hh"

namespace whittle::app {
namespace {

using Json = nlohmann::json;

static_assert(least_texture_size == bake::least_texture_size && largest_texture_size == bake::largest_texture_size);

constexpr char base_colors_alone[] = "; bake takes base colours alone. 'whittle simplify' keeps all of a material";
constexpr char unlit[] = "KHR_materials_unlit";

/// The material's use of something that no base colour can show; empty if there is none.
std::string unbaked_use(const Json& material) {
  const Json metal = material.value("pbrMetallicRoughness", Json::object());
  if (metal.contains("metallicRoughnessTexture")) return "a map of metalness and roughness";
  if (material.contains("normalTexture")) return "a normal map";
  if (material.contains("occlusionTexture")) return "a map of occlusion";
  const std::vector<double> none(3, 0);
  if (material.contains("emissiveTexture") || material.value("emissiveFactor", none) != none) return "emission";
  const Json extensions = material.value("extensions", Json::object());
  for (const auto& extension : extensions.items()) {
    if (extension.key() != unlit) return extension.key();
  }
  return {};
}

gltf::Shading shading_of(const Json& material) {
  const Json metal = material.value("pbrMetallicRoughness", Json::object());
  return {metal.value("metallicFactor", 1.0), metal.value("roughnessFactor", 1.0),
          material.value("extensions", Json::object()).contains(unlit), nullptr};
}

bool are_equal(const gltf::Shading& a, const gltf::Shading& b) {
  return a.metalness == b.metalness && a.roughness == b.roughness && a.is_unlit == b.is_unlit;
}

/// The materials of a document that meshes have.
std::vector<Json> used_materials(const Json& document) {
  std::set<std::size_t> numbers;
  for (const Json& mesh : document.value("meshes", Json::array())) {
    for (const Json& primitive : mesh.value("primitives", Json::array())) {
      if (primitive.contains("material")) numbers.insert(primitive["material"].get<std::size_t>());
    }
  }
  std::vector<Json> materials;
  materials.reserve(numbers.size());
  for (const std::size_t number : numbers) materials.push_back(document.at("materials").at(number));
  return materials;
}

/// "scan.glb: material 'bark'"
std::string name_of_material(const Scene& scene, const Json& material) {
  return scene.name + ": material '" + material.value("name", std::string("without a name")) + "'";
}

/// The shading that all materials have. \throw UnsupportedMesh if there is none, or if a material has more to show
gltf::Shading common_shading(const Scene& scene, const Json& document) {
  std::optional<gltf::Shading> common;
  for (const Json& material : used_materials(document)) {
    if (const std::string use = unbaked_use(material); !use.empty()) {
      throw UnsupportedMesh(name_of_material(scene, material) + " has " + use + base_colors_alone);
    }
    const gltf::Shading shading = shading_of(material);
    if (common && !are_equal(*common, shading)) {
      throw UnsupportedMesh(name_of_material(scene, material) +
                            " has another metalness or roughness than others; bake makes one material of all");
    }
    common = shading;
  }
  return common.value_or(gltf::Shading{});
}

/// Likewise. \throw io::ReadError for a material that isn't valid
gltf::Shading shading_of_all(const Scene& scene) {
  if (!scene.document) return {};
  try {
    return common_shading(scene, Json::parse(gltf_asset_of(scene).document()));
  } catch (const Json::exception&) {
    throw io::ReadError(scene.name, "a material has a value of a wrong type");
  }
}

/// Whether a material of the scene has a property. \param has of a material
template <class Has>
bool any_material(const render::Scene& scene, const Has& has) {
  return std::any_of(scene.parts.begin(), scene.parts.end(), [&](const render::Part& part) {
    return std::any_of(part.materials.begin(), part.materials.end(), has);
  });
}

bool has_colors(const render::Scene& scene) {
  return any_material(scene,
                      [](const Material& material) {
                        return material.base_color_texture || material.base_color != Material{}.base_color;
                      }) ||
         std::any_of(scene.parts.begin(), scene.parts.end(),
                     [](const render::Part& part) { return !part.mesh->colors.empty(); });
}

/// What the detailed file looks like. \throw UnsupportedMesh if it has no colours or transparent ones, or an image
/// can't be read
ReadScene read_look(const Scene& detailed) {
  ReadScene look = read_scene(detailed);
  if (!look.warnings.empty()) throw UnsupportedMesh(detailed.name + ": " + look.warnings.front());
  if (any_material(look.scene, [](const Material& material) { return material.alpha_mode != Alpha::opaque; })) {
    throw UnsupportedMesh(detailed.name + ": a material has transparency" + base_colors_alone);
  }
  if (!has_colors(look.scene)) {
    throw UnsupportedMesh(detailed.name + ": it has no colours to bake: no texture, and none at vertices");
  }
  return look;
}

std::shared_ptr<const Image> image_of(const render::Picture& picture, const char* name) {
  return std::make_shared<const Image>(Image{.name = name, .file = name, .bytes = write_png(picture)});
}

/// What of the coarse file isn't written, beside its look.
void add_warnings(const Scene& detailed, const Scene& coarse, BakedScene& baked) {
  constexpr double most_missed = 0.05;
  if (baked.missed_share > most_missed) {
    baked.warnings.push_back(coarse.name + ": " + significant(100 * baked.missed_share) + " % of it have no part of " +
                             detailed.name +
                             " near by that faces the same way, and got the colour of the nearest other part");
  }
  if (!coarse.document) return;
  const std::vector<std::string> others = gltf_asset_of(coarse).other_content();
  if (!others.empty()) baked.warnings.push_back(coarse.name + ": left out: " + listed(others));
}

bake::Baked baked_onto(const render::Scene& look, const Scene& coarse, const BakeSettings& settings) {
  bake::BakeOptions options;
  options.texture_size = settings.texture_size;
  options.makes_normal_map = settings.makes_normal_map;
  options.threads = settings.threads;
  options.progress = settings.progress;
  try {
    return bake::bake(look, coarse.read.mesh, options);
  } catch (const std::invalid_argument& error) {
    throw UnsupportedMesh(coarse.name + ": " + error.what());
  }
}

}  // namespace

BakedScene bake_scene(const Scene& detailed, const Scene& coarse, const BakeSettings& settings) {
  const ReadScene look = read_look(detailed);
  gltf::Shading shading = shading_of_all(detailed);
  BakeSettings lit = settings;
  lit.makes_normal_map = settings.makes_normal_map && !shading.is_unlit;
  bake::Baked baked = baked_onto(look.scene, coarse, lit);
  if (baked.n_missed == baked.n_samples) {
    throw UnsupportedMesh(coarse.name + ": no part of it is near " + detailed.name + " and faces the same way");
  }
  Material material;
  material.name = "baked";
  material.double_sided = any_material(look.scene, [](const Material& part) { return part.double_sided; });
  material.base_color_texture = Texture{.image = image_of(baked.base_color, "base_color")};
  if (baked.normal_map) shading.normal_map = image_of(*baked.normal_map, "normals");
  const std::size_t n_vertices = baked.mesh.normals.size();
  const std::size_t n_faces = baked.mesh.faces.size();
  BakedScene result{.asset = gltf::make_asset({.name = coarse.mesh_name,
                                               .mesh = std::move(baked.mesh),
                                               .materials = {std::move(material)},
                                               .shading = std::move(shading)}),
                    .n_vertices = n_vertices,
                    .n_faces = n_faces,
                    .texture_size = baked.base_color.width,
                    .n_charts = baked.n_charts,
                    .has_normal_map = baked.normal_map.has_value(),
                    .missed_share = static_cast<double>(baked.n_missed) / static_cast<double>(baked.n_samples),
                    .warnings = {}};
  add_warnings(detailed, coarse, result);
  return result;
}

}  // namespace whittle::app
