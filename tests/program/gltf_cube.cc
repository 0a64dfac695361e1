#include "program/gltf_cube.hh"

#include <nlohmann/json.hpp>
#include <utility>

#include "support/shapes/shapes.hh"
#include "whittle/core/wedges.hh"
#include "whittle/gltf/asset.hh"

namespace whittle::test {
namespace {

using Json = nlohmann::json;

/// All numbers are zeros of the buffer.
Json document_with_empty_triangles() {
  const auto accessor = [](const char* type, std::size_t n) {
    Json json = {{"bufferView", 0}, {"componentType", 5126}, {"count", n}, {"type", type}};
    if (std::string(type) == "VEC3") json["min"] = json["max"] = {0, 0, 0};
    return json;
  };
  const auto triangle = [](int material) {
    return Json{{"attributes", {{"POSITION", 0}, {"NORMAL", 0}, {"TEXCOORD_0", 1}}}, {"material", material}};
  };
  return {
      {"asset", {{"version", "2.0"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", {0, 1}}}}},
      {"nodes", {{{"mesh", 0}, {"scale", {3, 3, 3}}, {"name", "box"}}, {{"camera", 0}}}},
      {"cameras", {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}}}},
      {"materials", {{{"name", "brick"}}, {{"name", "glass"}, {"alphaMode", "BLEND"}}}},
      {"meshes",
       {{{"name", "cube"},
         {"primitives", {triangle(0), triangle(1), {{"attributes", {{"POSITION", 0}}}, {"mode", 0}}}}}}},
      {"animations",
       {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
         {"samplers", {{{"input", 2}, {"output", 0}}}}}}},
      {"accessors",
       {accessor("VEC3", 3),
        accessor("VEC2", 3),
        {{"bufferView", 1}, {"componentType", 5126}, {"count", 3}, {"type", "SCALAR"}, {"min", {0}}, {"max", {2}}}}},
      {"bufferViews", {{{"buffer", 0}, {"byteLength", 36}}, {{"buffer", 0}, {"byteOffset", 36}, {"byteLength", 12}}}},
      // 36 zeros, then 0, 1 and 2
      {"buffers",
       {{{"byteLength", 48},
         {"uri", "data:application/octet-stream;base64," + std::string(48, 'A') + "AAAAAAAAgD8AAABA"}}}},
      {"extras", {{"maker", "a test"}}}};
}

}  // namespace

void write_gltf_cube(const std::string& path, int n) {
  gltf::Asset asset = gltf::Asset::read(document_with_empty_triangles().dump(), "cube.gltf");
  IndexedMesh mesh = charted_cube(n);
  mesh.attributes[0].name = "TEXCOORD_0";
  for (Index& group : mesh.face_groups) group %= 2;
  mesh.group_names.resize(2);
  join_equal_wedges(mesh);
  asset.set_triangles(0, std::move(mesh));
  asset.write(path);
}

}  // namespace whittle::test
