#include "geometry/surface.hh"

#include <algorithm>
#include <stdexcept>

#include "codec/draco.hh"

namespace whittle::gltf {
namespace {

/// More triangles than these for each byte of the asset are refused: indices take a byte a triangle at least, but
/// primitives may share them.
constexpr std::size_t most_triangles_a_byte = 16;

std::size_t n_corners_of(const Model& model, const Primitive& primitive) {
  if (primitive.indices) return model.accessors[*primitive.indices].count;
  return model.accessors[*primitive.attribute("POSITION")].count;
}

/// The corners of a triangle, by their places in the sequence of vertices. Section 3.7.2.1.
Triangle corners_of(PrimitiveMode mode, std::size_t triangle) {
  const auto i = static_cast<Index>(triangle);
  switch (mode) {
    case PrimitiveMode::strip:
      return {i, i + 1 + i % 2, i + 2 - i % 2};
    case PrimitiveMode::fan:
      return {i + 1, i + 2, 0};
    default:
      return {3 * i, 3 * i + 1, 3 * i + 2};
  }
}

std::vector<Triangle> read_faces(const Model& model, std::size_t mesh, std::size_t number, std::size_t n_vertices) {
  const Primitive& primitive = model.meshes[mesh].primitives[number];
  std::vector<Triangle> faces(n_triangles_of(model, primitive));
  for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = corners_of(primitive.mode, f);
  if (!primitive.indices) return faces;
  const Elements indices(model.accessors[*primitive.indices]);
  for (Triangle& face : faces) {
    for (Index& corner : face) {
      const std::size_t index = indices.whole(corner);
      if (index >= n_vertices) {
        fail_in_primitive(
            model, mesh, number,
            "index " + std::to_string(index) + " is above the " + std::to_string(n_vertices) + " vertices");
      }
      corner = static_cast<Index>(index);
    }
  }
  return faces;
}

/// An accessor of decoded Draco data, with the meaning of the document's accessor.
Accessor accessor_of(const DracoAttribute& attribute, std::string_view bytes, std::size_t count,
                     const Accessor& documented) {
  Accessor accessor;
  accessor.type = attribute.type;
  accessor.is_normalized = documented.is_normalized && is_integer(attribute.type);
  accessor.shape = {attribute.n_components, 1};
  accessor.count = count;
  accessor.bytes = bytes;
  accessor.stride = accessor.shape.packed_stride(accessor.type);
  return accessor;
}

Surface read_compressed_surface(const Model& model, std::size_t mesh, std::size_t number) {
  const Primitive& primitive = model.meshes[mesh].primitives[number];
  Surface surface;
  DracoMesh decoded;
  try {
    decoded = decode_draco(model.views[primitive.draco->view].bytes, primitive.draco->attributes);
  } catch (const std::runtime_error& error) {
    fail_in_primitive(model, mesh, number, error.what());
  }
  surface.n_vertices = decoded.n_vertices;
  surface.faces = std::move(decoded.faces);
  for (DracoAttribute& attribute : decoded.attributes) {
    const std::optional<std::size_t> documented = primitive.attribute(attribute.name);
    if (!documented) continue;
    surface.decoded.push_back(std::make_shared<const std::string>(std::move(attribute.bytes)));
    const Accessor accessor =
        accessor_of(attribute, *surface.decoded.back(), surface.n_vertices, model.accessors[*documented]);
    surface.attributes.emplace_back(attribute.name, Elements(accessor));
  }
  return surface;
}

}  // namespace

std::vector<Channel> channels_of(const Primitive& primitive) {
  std::vector<Channel> channels;
  for (const auto& [name, accessor] : primitive.attributes) channels.push_back({name, accessor});
  for (std::size_t i = 0; i < primitive.targets.size(); ++i) {
    for (const auto& [name, accessor] : primitive.targets[i]) {
      channels.push_back({"target " + std::to_string(i) + ' ' + name, accessor});
    }
  }
  return channels;
}

const Elements* Surface::attribute(std::string_view name) const {
  const auto found =
      std::find_if(attributes.begin(), attributes.end(), [&](const auto& pair) { return pair.first == name; });
  return found == attributes.end() ? nullptr : &found->second;
}

Surface read_surface(const Model& model, std::size_t mesh, std::size_t number) {
  const Primitive& primitive = model.meshes[mesh].primitives[number];
  Surface surface;
  if (primitive.draco) {
    surface = read_compressed_surface(model, mesh, number);
  } else {
    surface.n_vertices = model.accessors[*primitive.attribute("POSITION")].count;
    if (surface.n_vertices >= invalid_index || n_corners_of(model, primitive) >= invalid_index) {
      fail_in_primitive(model, mesh, number, "it has too many vertices or indices");
    }
    surface.faces = read_faces(model, mesh, number, surface.n_vertices);
  }
  for (const Channel& channel : channels_of(primitive)) {
    if (surface.attribute(channel.name)) continue;
    const Accessor& accessor = model.accessors[channel.accessor];
    if (accessor.count < surface.n_vertices) {
      fail_in_primitive(model, mesh, number,
                        printable(channel.name) + " has " + std::to_string(accessor.count) + " values for " +
                            std::to_string(surface.n_vertices) + " vertices");
    }
    surface.attributes.emplace_back(channel.name, Elements(accessor));
  }
  if (surface.attribute("POSITION")->shape() != ElementShape{3, 1}) {
    fail_in_primitive(model, mesh, number, "its positions don't have 3 components");
  }
  if (surface.faces.size() / most_triangles_a_byte > model.n_bytes) {
    fail_in_primitive(model, mesh, number, "it has more triangles than the file can hold");
  }
  return surface;
}

std::size_t n_triangles_of(const Model& model, const Primitive& primitive) {
  if (!primitive.is_surface()) return 0;
  return n_triangles_of(primitive.mode, n_corners_of(model, primitive));
}

}  // namespace whittle::gltf
