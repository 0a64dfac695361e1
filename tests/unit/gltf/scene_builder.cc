#include "scene_builder.hh"

#include <cstdint>

#include "document/glb.hh"
#include "model/scalars.hh"

namespace whittle::gltf::test {

std::size_t SceneBuilder::add(const std::string& type, int component_type, std::size_t n_numbers,
                              const std::string& packed) {
  const std::size_t n_components = element_shape(type).value().n_components();
  buffer.append((4 - buffer.size() % 4) % 4, '\0');
  json["accessors"].push_back({{"bufferView", json["bufferViews"].size()},
                               {"componentType", component_type},
                               {"count", n_numbers / n_components},
                               {"type", type}});
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", packed.size()}});
  buffer += packed;
  return json["accessors"].size() - 1;
}

std::size_t SceneBuilder::floats(const std::string& type, const std::vector<float>& numbers) {
  std::string packed;
  for (const float x : numbers) append_little_endian(packed, x);
  return add(type, 5126, numbers.size(), packed);
}

std::size_t SceneBuilder::bytes(const std::string& type, const std::vector<std::size_t>& numbers) {
  std::string packed;
  for (const std::size_t x : numbers) packed += static_cast<char>(x);
  return add(type, 5121, numbers.size(), packed);
}

std::size_t SceneBuilder::fractions(const std::string& type, const std::vector<int>& numbers) {
  std::string packed;
  for (const int x : numbers) append_little_endian(packed, static_cast<std::int16_t>(x));
  const std::size_t number = add(type, 5122, numbers.size(), packed);
  json["accessors"][number]["normalized"] = true;
  return number;
}

std::size_t SceneBuilder::animate(std::size_t node, const std::string& path, const std::vector<float>& times,
                                  std::size_t values, const std::string& interpolation) {
  const std::size_t input = floats("SCALAR", times);
  json["animations"].push_back(
      {{"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}},
       {"samplers", {{{"input", input}, {"output", values}, {"interpolation", interpolation}}}}});
  return json["animations"].size() - 1;
}

std::string SceneBuilder::glb() const {
  Json document = json;
  document["buffers"] = {{{"byteLength", buffer.size()}}};
  return join_glb(document.dump(), buffer);
}

SceneBuilder bar() {
  SceneBuilder scene;
  const std::size_t positions = scene.floats("VEC3", {0, 0, 0, 1, 0, 0, 2, 0, 0});
  const std::size_t joints = scene.bytes("VEC4", {0, 0, 0, 0, 0, 1, 0, 0, 1, 7, 0, 0});  // 7 has no weight
  const std::size_t weights = scene.floats("VEC4", {1, 0, 0, 0, 0.5F, 0.5F, 0, 0, 1, 0, 0, 0});
  const std::size_t inverse = scene.floats("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,  //
                                                    1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1});
  scene.json["meshes"] = {
      {{"primitives", {{{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}}}}}}};
  scene.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", inverse}}};
  scene.json["nodes"] = {
      {{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}}, {{"children", {2}}}, {{"translation", {1, 0, 0}}}};
  return scene;
}

SceneBuilder morphing_triangle() {
  SceneBuilder scene;
  const std::size_t positions = scene.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::size_t up = scene.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
  const std::size_t aside = scene.floats("VEC3", {0, 0, 0, 4, 0, 0, 0, 0, 0});
  scene.json["meshes"] = {
      {{"primitives",
        {{{"attributes", {{"POSITION", positions}}}, {"targets", {{{"POSITION", up}}, {{"POSITION", aside}}}}}}}}};
  scene.json["nodes"] = {{{"mesh", 0}}};
  return scene;
}

}  // namespace whittle::gltf::test
