#include "model/model.hh"

#include <Eigen/Geometry>
#include <algorithm>

#include "model/extensions.hh"
#include "model/read_model.hh"
#include "whittle/io/errors.hh"

namespace whittle::gltf {

std::optional<std::size_t> Primitive::attribute(std::string_view name) const {
  const auto found =
      std::find_if(attributes.begin(), attributes.end(), [&](const auto& pair) { return pair.first == name; });
  if (found == attributes.end()) return {};
  return found->second;
}

bool Primitive::is_surface() const { return mode >= PrimitiveMode::triangles && attribute("POSITION"); }

void fail_in_primitive(const Model& model, std::size_t mesh, std::size_t primitive, const std::string& problem) {
  throw io::ReadError(model.file,
                      "mesh " + std::to_string(mesh) + " primitive " + std::to_string(primitive) + ": " + problem);
}

std::size_t n_triangles_of(PrimitiveMode mode, std::size_t n_corners) {
  if (mode == PrimitiveMode::triangles) return n_corners / 3;
  const bool has_triangles = mode == PrimitiveMode::strip || mode == PrimitiveMode::fan;
  return has_triangles && n_corners > 2 ? n_corners - 2 : 0;
}

Eigen::Matrix4d Transform::matrix() const {
  const Eigen::Quaterniond turn(rotation[3], rotation[0], rotation[1], rotation[2]);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = turn.toRotationMatrix() * Eigen::Vector3d(scale[0], scale[1], scale[2]).asDiagonal();
  matrix.topRightCorner<3, 1>() = Eigen::Vector3d(translation[0], translation[1], translation[2]);
  return matrix;
}

Model read_model(const Json& document, const Source& source) {
  Model model;
  model.file = source.file;
  const Part root(document, "", source.file);
  if (!document.is_object()) root.fail("the document is not an object, so it is no glTF");
  check_version_and_extensions(root);
  read_buffers(model, root, source);
  read_views(model, root);
  read_accessors(model, root);
  read_meshes(model, root);
  read_nodes(model, root);
  read_scene(model, root);
  return model;
}

}  // namespace whittle::gltf
