#include "write/new_geometry.hh"

#include <algorithm>
#include <utility>

#include "geometry/split.hh"
#include "geometry/surface.hh"
#include "model/extensions.hh"

namespace whittle::gltf {
namespace {

void drop_extension(Json& object, std::string_view name) {
  const auto extensions = object.find("extensions");
  if (extensions == object.end() || !extensions->is_object() || !member(*extensions, name)) return;
  extensions->erase(std::string(name));
  if (extensions->empty()) object.erase("extensions");
}

void strip_primitive(Json& primitive) {
  if (const auto attributes = primitive.find("attributes"); attributes != primitive.end()) *attributes = Json::object();
  if (const auto targets = primitive.find("targets"); targets != primitive.end()) {
    for (Json& target : *targets) target = Json::object();
  }
  if (const auto indices = primitive.find("indices"); indices != primitive.end()) *indices = nullptr;
  if (const auto mode = primitive.find("mode"); mode != primitive.end()) *mode = 4;
  drop_extension(primitive, draco_extension);
  drop_extension(primitive, outline_extension);
}

/// The pieces of a mesh, with faces in an order that compresses well if that is asked for.
std::vector<Piece> pieces_of(const Mesh& mesh, const IndexedMesh& triangles, bool compress) {
  std::vector<Piece> pieces = split_by_primitive(mesh, triangles);
  if (!compress) return pieces;
  for (Piece& piece : pieces) {
    const std::vector<Index> order = optimize_order(piece.faces, piece.wedges.size());
    const auto reorder = [&](std::vector<Index>& values) {
      std::vector<Index> reordered;
      reordered.reserve(order.size());
      for (const Index i : order) reordered.push_back(values[i]);
      values = std::move(reordered);
    };
    reorder(piece.wedges);
    reorder(piece.vertices);
  }
  return pieces;
}

/// The template for written values: the accessor of the input, except for joints and weights to be packed.
Accessor documented_for(const Model& model, const Channel& channel, const Packing& packing) {
  Accessor accessor = model.accessors[channel.accessor];
  const bool are_weights = channel.name.starts_with("WEIGHTS_");
  if (packing.quantizes && (are_weights || channel.name.starts_with("JOINTS_"))) {
    accessor.type = ScalarType::uint8;  // large numbers of joints get 16 bits
    accessor.is_normalized = are_weights;
  } else if (packing.compresses && are_weights && !is_integer(accessor.type)) {
    accessor.type = ScalarType::uint16;
    accessor.is_normalized = true;
  }
  return accessor;
}

/// The channels of a piece, and its indices.
class PieceEncoder {
 public:
  PieceEncoder(const Model& model, std::size_t mesh, const IndexedMesh& triangles, const Packing& packing)
      : model_(model), mesh_(mesh), triangles_(triangles), packing_(packing) {}

  void append(const Piece& piece, std::vector<NewAccessor>& to) const {
    const Primitive& primitive = model_.meshes[mesh_].primitives[piece.primitive];
    for (const auto& [name, accessor] : primitive.attributes) append(piece, {name, accessor}, name, {}, to);
    for (std::size_t i = 0; i < primitive.targets.size(); ++i) {
      for (const auto& [name, accessor] : primitive.targets[i]) {
        append(piece, {"target " + std::to_string(i) + ' ' + name, accessor}, name, i, to);
      }
    }
    const Accessor* const documented = primitive.indices ? &model_.accessors[*primitive.indices] : nullptr;
    to.push_back({mesh_,
                  piece.primitive,
                  "",
                  {},
                  primitive.indices,
                  encode_indices(piece.faces, piece.wedges.size(), documented, packing_)});
  }

 private:
  void append(const Piece& piece, const Channel& channel, const std::string& name, std::optional<std::size_t> target,
              std::vector<NewAccessor>& to) const {
    const Accessor documented = documented_for(model_, channel, packing_);
    const auto values = values_of(model_, model_.meshes[mesh_], triangles_, piece, channel, documented);
    if (!values) return;
    NewAccessor accessor{mesh_,  piece.primitive,  name,
                         target, channel.accessor, encode_channel(channel, documented, *values, packing_)};
    const bool had_bytes =
        documented.view || documented.sparse || model_.meshes[mesh_].primitives[piece.primitive].draco;
    accessor.has_bytes =
        had_bytes || std::any_of(values->begin(), values->end(), [](double value) { return value != 0; });
    to.push_back(std::move(accessor));
  }

  const Model& model_;
  std::size_t mesh_;
  const IndexedMesh& triangles_;
  Packing packing_;
};

}  // namespace

void strip_geometry(Json& document, const Model& model, const Replacements& replacements) {
  for (const auto& [number, triangles] : replacements) {
    const Mesh& mesh = model.meshes[number];
    const std::vector<bool> with_faces = primitives_with_faces(mesh, triangles);
    const std::vector<bool> lost = lost_primitives(model, mesh, triangles);
    for (std::size_t p = 0; p < lost.size(); ++p) {
      if (lost[p] || with_faces[p]) strip_primitive(document["meshes"][number]["primitives"][p]);
    }
    drop_extension(document["meshes"][number], manifold_extension);
  }
}

std::vector<NewAccessor> new_accessors(const Model& model, const Replacements& replacements,
                                       const std::function<Packing(std::size_t)>& packing) {
  std::vector<NewAccessor> all;
  for (const auto& [mesh, triangles] : replacements) {
    const Packing of_mesh = packing(mesh);
    const PieceEncoder encoder(model, mesh, triangles, of_mesh);
    for (const Piece& piece : pieces_of(model.meshes[mesh], triangles, of_mesh.compresses)) encoder.append(piece, all);
  }
  return all;
}

Json& place_in(Json& document, const NewAccessor& accessor) {
  if (accessor.skin) return document["skins"][*accessor.skin]["inverseBindMatrices"];
  Json& primitive = document["meshes"][accessor.mesh]["primitives"][accessor.primitive];
  if (accessor.name.empty()) return primitive["indices"];
  return accessor.target ? primitive["targets"][*accessor.target][accessor.name]
                         : primitive["attributes"][accessor.name];
}

void drop_lost_primitives(Json& document, const Model& model, const Replacements& replacements) {
  for (const auto& [mesh, triangles] : replacements) {
    const std::vector<bool> lost = lost_primitives(model, model.meshes[mesh], triangles);
    Json& primitives = document["meshes"][mesh]["primitives"];
    Json kept = Json::array();
    for (std::size_t p = 0; p < lost.size(); ++p) {
      if (!lost[p]) kept.push_back(std::move(primitives[p]));
    }
    primitives = std::move(kept);
  }
}

}  // namespace whittle::gltf
