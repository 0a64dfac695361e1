#include "codec/draco.hh"

#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <utility>

#ifdef WHITTLE_DRACO
#include <draco/compression/decode.h>
#endif

namespace whittle::gltf {

#ifdef WHITTLE_DRACO

bool has_draco() { return true; }

namespace {

std::optional<ScalarType> scalar_type_of(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return ScalarType::int8;
    case draco::DT_UINT8:
      return ScalarType::uint8;
    case draco::DT_INT16:
      return ScalarType::int16;
    case draco::DT_UINT16:
      return ScalarType::uint16;
    case draco::DT_INT32:
      return ScalarType::int32;
    case draco::DT_UINT32:
      return ScalarType::uint32;
    case draco::DT_FLOAT32:
      return ScalarType::float32;
    case draco::DT_FLOAT64:
      return ScalarType::float64;
    default:
      return {};
  }
}

DracoAttribute attribute_of(const draco::Mesh& mesh, const std::string& name, std::size_t id) {
  const draco::PointAttribute* const from =
      id <= ~std::uint32_t{0} ? mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id)) : nullptr;
  if (!from) throw std::runtime_error("Draco's data have no " + printable(name));
  const std::optional<ScalarType> type = scalar_type_of(from->data_type());
  if (!type || from->num_components() < 1) throw std::runtime_error(printable(name) + " has an unknown type");
  DracoAttribute attribute{name, *type, static_cast<std::size_t>(from->num_components()), {}};
  const std::size_t stride = attribute.n_components * size_of(*type);
  attribute.bytes.reserve(stride * mesh.num_points());
  for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
    const draco::AttributeValueIndex value = from->mapped_index(point);
    if (value.value() >= from->size()) throw std::runtime_error(printable(name) + " is damaged");
    attribute.bytes.append(reinterpret_cast<const char*>(from->GetAddress(value)), stride);
  }
  return attribute;
}

DracoMesh decoded_mesh(const draco::Mesh& from, const NamedNumbers& attributes) {
  DracoMesh mesh;
  mesh.n_vertices = from.num_points();
  mesh.faces.reserve(from.num_faces());
  for (draco::FaceIndex f(0); f < from.num_faces(); ++f) {
    Triangle face;
    for (std::size_t c = 0; c < 3; ++c) {
      face[c] = from.face(f)[c].value();
      if (face[c] >= mesh.n_vertices) throw std::runtime_error("Draco's data have an index that is too large");
    }
    mesh.faces.push_back(face);
  }
  for (const auto& [name, id] : attributes) mesh.attributes.push_back(attribute_of(from, name, id));
  return mesh;
}

std::unique_ptr<draco::Mesh> decoded_by_draco(std::string_view packed) {
  draco::DecoderBuffer buffer;
  buffer.Init(packed.data(), packed.size());
  draco::Decoder decoder;
  auto result = decoder.DecodeMeshFromBuffer(&buffer);
  if (!result.ok())
    throw std::runtime_error("Draco's data are damaged: " + printable(result.status().error_msg_string()));
  return std::move(result).value();
}

}  // namespace

DracoMesh decode_draco(std::string_view packed, const NamedNumbers& attributes) {
  try {
    return decoded_mesh(*decoded_by_draco(packed), attributes);
  } catch (const std::bad_alloc&) {
    throw std::runtime_error("Draco's data are damaged: they ask for too much memory");
  } catch (const std::length_error&) {
    throw std::runtime_error("Draco's data are damaged: they ask for too much memory");
  }
}

#else

bool has_draco() { return false; }
DracoMesh decode_draco(std::string_view, const NamedNumbers&) {
  throw std::runtime_error("it is compressed by Draco, and this build can't read that: it has no Draco");
}

#endif

}  // namespace whittle::gltf
