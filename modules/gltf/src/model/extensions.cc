#include "model/extensions.hh"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <utility>

namespace whittle::gltf {
namespace {

// Extensions of geometry, whose numbers references.cc knows, and others that name neither accessors nor buffer views.
constexpr std::string_view known_extensions[] = {draco_extension,
                                                 meshopt_extension,
                                                 quantization_extension,
                                                 instancing_extension,
                                                 structural_metadata_extension,
                                                 outline_extension,
                                                 manifold_extension,
                                                 "EXT_mesh_features",
                                                 "EXT_instance_features",
                                                 "KHR_gaussian_splatting",
                                                 texture_transform_extension,
                                                 "KHR_texture_basisu",
                                                 "EXT_texture_webp",
                                                 "EXT_texture_avif",
                                                 "MSFT_texture_dds",
                                                 "EXT_texture_astc",
                                                 "KHR_lights_punctual",
                                                 "EXT_lights_image_based",
                                                 "EXT_lights_ies",
                                                 "KHR_animation_pointer",
                                                 "KHR_xmp_json_ld",
                                                 "KHR_xmp",
                                                 visibility_extension,
                                                 "KHR_node_hoverability",
                                                 "KHR_node_selectability",
                                                 lod_extension,
                                                 "CESIUM_RTC",
                                                 "AGI_articulations",
                                                 "AGI_stk_metadata",
                                                 "ADOBE_materials_thin_transparency",
                                                 "KHR_techniques_webgl",
                                                 "VRM",
                                                 "VRMC_vrm",
                                                 "VRMC_materials_mtoon",
                                                 "VRMC_node_constraint",
                                                 "VRMC_springBone"};
constexpr std::string_view known_beginnings[] = {"KHR_materials_", "EXT_materials_", "MSFT_packing_"};

/// The numbers of "2.0".
std::optional<std::pair<int, int>> parsed_version(const std::string& text) {
  int major = 0;
  int minor = 0;
  const char* const end = text.data() + text.size();
  const auto [dot, error] = std::from_chars(text.data(), end, major);
  if (error != std::errc{} || dot == end || *dot != '.') return {};
  const auto [last, minor_error] = std::from_chars(dot + 1, end, minor);
  if (minor_error != std::errc{} || last != end) return {};
  return std::pair(major, minor);
}

}  // namespace

bool is_known_extension(std::string_view name) {
  return std::find(std::begin(known_extensions), std::end(known_extensions), name) != std::end(known_extensions) ||
         std::any_of(std::begin(known_beginnings), std::end(known_beginnings),
                     [&](std::string_view beginning) { return name.starts_with(beginning); });
}

void check_version_and_extensions(const Part& root) {
  const std::optional<Part> asset = root.object("asset");
  if (!asset) root.fail("the document has no \"asset\", so it is no glTF 2.0");
  const Json* const json = member(asset->json(), "version");
  // glTF 1.0 may have a number there.
  const std::string version = json && json->is_number() ? json->dump() : asset->required_text("version");
  const auto number = parsed_version(version);
  if (!number || number->first != 2) root.fail("glTF version " + printable(version) + "; only 2.0 is supported");
  if (const auto least = asset->text("minVersion")) {
    const auto least_number = parsed_version(*least);
    if (!least_number || *least_number > std::pair(2, 0)) {
      root.fail("the asset needs glTF " + printable(*least) + "; only 2.0 is supported");
    }
  }
  const Json* required = member(root.json(), "extensionsRequired");
  if (!required) return;
  if (!required->is_array()) root.fail("\"extensionsRequired\" is not an array");
  for (const Json& name : *required) {
    if (!name.is_string()) root.fail("\"extensionsRequired\" has an element that is not a string");
    const auto& text = name.get_ref<const std::string&>();
    if (!is_known_extension(text)) {
      root.fail("the asset needs the extension " + printable(text) + ", which is not supported");
    }
  }
}

}  // namespace whittle::gltf
