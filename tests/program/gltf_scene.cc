#include "program/gltf_scene.hh"

#include "whittle/gltf/asset.hh"

namespace whittle::test {

void write_gltf_scene(const std::string& path, const std::vector<IndexedMesh>& meshes, const nlohmann::json& nodes,
                      const nlohmann::json& roots) {
  using Json = nlohmann::json;
  const Json point = {{"attributes", {{"POSITION", 0}}}};
  // A triangle of zeros stands for each mesh.
  Json document = {
      {"asset", {{"version", "2.0"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", roots}}}},
      {"nodes", nodes},
      {"accessors",
       {{{"bufferView", 0},
         {"componentType", 5126},
         {"count", 3},
         {"type", "VEC3"},
         {"min", {0, 0, 0}},
         {"max", {0, 0, 0}}}}},
      {"bufferViews", {{{"buffer", 0}, {"byteLength", 36}}}},
      {"buffers", {{{"byteLength", 36}, {"uri", "data:application/octet-stream;base64," + std::string(48, 'A')}}}}};
  for (std::size_t i = 0; i < meshes.size(); ++i) document["meshes"].push_back({{"primitives", Json::array({point})}});
  gltf::Asset asset = gltf::Asset::read(document.dump(), path);
  for (std::size_t i = 0; i < meshes.size(); ++i) asset.set_triangles(i, meshes[i]);
  asset.write(path);
}

}  // namespace whittle::test
