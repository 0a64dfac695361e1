#pragma once

#include <string>
#include <string_view>

#include "document/json.hh"

namespace whittle::gltf {

inline constexpr std::string_view draco_extension = "KHR_draco_mesh_compression";
inline constexpr std::string_view meshopt_extension = "EXT_meshopt_compression";
inline constexpr std::string_view quantization_extension = "KHR_mesh_quantization";
inline constexpr std::string_view instancing_extension = "EXT_mesh_gpu_instancing";
inline constexpr std::string_view lod_extension = "MSFT_lod";
inline constexpr std::string_view visibility_extension = "KHR_node_visibility";
inline constexpr std::string_view structural_metadata_extension = "EXT_structural_metadata";
inline constexpr std::string_view outline_extension = "CESIUM_primitive_outline";
inline constexpr std::string_view manifold_extension = "EXT_mesh_manifold";
inline constexpr std::string_view texture_transform_extension = "KHR_texture_transform";
inline constexpr std::string_view specular_glossiness_extension = "KHR_materials_pbrSpecularGlossiness";

/// Whether the effect of an extension on geometry, accessors and buffer views is known.
bool is_known_extension(std::string_view name);

/// Refuses other versions than 2.x, and required extensions that aren't known. \throw io::ReadError
void check_version_and_extensions(const Part& root);

}  // namespace whittle::gltf
