#include "program/gltf_sheet.hh"

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/gltf/asset.hh"

namespace whittle::test {
namespace {

using Json = nlohmann::json;

/// 48 zeros, then the times 0 and 1, and the scales 1 1 1 and 3 3 3.
const std::string buffer_uri =
    "data:application/octet-stream;base64," + std::string(64, 'A') + "AAAAAAAAgD8AAIA/AACAPwAAgD8AAEBAAABAQAAAQEA=";

Json accessor(int view, const char* type, int component_type, int count, std::size_t offset = 0) {
  Json json = {{"bufferView", view},
               {"byteOffset", offset},
               {"componentType", component_type},
               {"count", count},
               {"type", type}};
  if (std::string(type) == "VEC3") json["min"] = json["max"] = {0, 0, 0};
  return json;
}

/// All numbers of its triangle are zeros.
Json document_of(const GltfSheet& sheet) {
  constexpr int floats = 5126, bytes = 5121;
  Json primitive = {{"attributes", {{"POSITION", 0}}}};
  if (sheet.has_skin) primitive["attributes"].update({{"JOINTS_0", 1}, {"WEIGHTS_0", 2}});
  if (sheet.has_target) primitive["targets"] = {{{"POSITION", 0}}};
  Json document = {
      {"asset", {{"version", "2.0"}}},
      {"nodes", {{{"mesh", 0}}, {{"scale", {sheet.scale, sheet.scale, sheet.scale}}}}},
      {"meshes", {{{"primitives", {std::move(primitive)}}}}},
      {"accessors",
       {accessor(0, "VEC3", floats, 3), accessor(0, "VEC4", bytes, 3), accessor(0, "VEC4", floats, 3),
        accessor(1, "SCALAR", floats, 2), accessor(1, "VEC3", floats, 2, 8)}},
      {"bufferViews", {{{"buffer", 0}, {"byteLength", 48}}, {{"buffer", 0}, {"byteOffset", 48}, {"byteLength", 32}}}},
      {"buffers", {{{"byteLength", 80}, {"uri", buffer_uri}}}}};
  if (sheet.has_skin) {
    document["nodes"][0]["skin"] = 0;
    document["skins"] = {{{"joints", {1}}}};
  }
  if (sheet.is_animated) {
    document["animations"] = {{{"name", "grow"},
                               {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "scale"}}}}}},
                               {"samplers", {{{"input", 3}, {"output", 4}}}}}};
  }
  return document;
}

}  // namespace

void write_gltf_sheet(const std::string& path, const GltfSheet& sheet, int n) {
  gltf::Asset asset = gltf::Asset::read(document_of(sheet).dump(), "sheet.gltf");
  IndexedMesh mesh = moved(scaled(grid(n, n), 4.0 / n), Vec3(0, 0, sheet.height));
  const std::size_t n_vertices = mesh.positions.size();
  if (sheet.has_skin) {
    Attribute& joints = mesh.attributes.emplace_back(
        Attribute{.name = "JOINTS_0+WEIGHTS_0", .kind = AttributeKind::joint_weights, .n_components = 8});
    joints.values.resize(8 * n_vertices);
    for (std::size_t v = 0; v < n_vertices; ++v) joints.value(v)[4] = 1;
  }
  if (sheet.has_target) {
    Attribute& target = mesh.attributes.emplace_back(
        Attribute{.name = "target 0 POSITION", .kind = AttributeKind::displacement, .n_components = 3});
    for (std::size_t v = 0; v < n_vertices; ++v) target.values.insert(target.values.end(), {0, 0, sheet.height});
  }
  asset.set_triangles(0, std::move(mesh));
  asset.write(path);
}

}  // namespace whittle::test
