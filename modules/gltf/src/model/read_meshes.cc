#include <algorithm>

#include "model/extensions.hh"
#include "model/read_model.hh"

namespace whittle::gltf {
namespace {

constexpr std::size_t n_modes = 7;

/// Draco's ids are not numbers of accessors.
constexpr std::size_t any_number = ~std::size_t{0};

DracoData read_draco(const Model& model, const Part& part) {
  DracoData draco;
  draco.view = part.required_index("bufferView", model.views.size(), "buffer view");
  const std::optional<Part> attributes = part.object("attributes");
  if (!attributes) part.fail("\"attributes\" is missing");
  draco.attributes = attributes->named_indices(any_number, "attribute");
  return draco;
}

bool has_its_shape(const std::string& name, const ElementShape& shape) {
  if (name == "POSITION" || name == "NORMAL") return shape == ElementShape{3, 1};
  if (name == "COLOR_0") return shape == ElementShape{3, 1} || shape == ElementShape{4, 1};
  return (!name.starts_with("JOINTS_") && !name.starts_with("WEIGHTS_")) || shape == ElementShape{4, 1};
}

/// \throw io::ReadError if there is an accessor with fewer values than there are positions
void check_counts(const Model& model, const Part& part, const Primitive& primitive) {
  const std::optional<std::size_t> position = primitive.attribute("POSITION");
  if (!position) return;
  const Accessor& positions = model.accessors[*position];
  for (const auto& [name, accessor] : primitive.attributes) {
    const ElementShape& shape = model.accessors[accessor].shape;
    if (!has_its_shape(name, shape)) part.fail(printable(name) + " can't be " + name_of(shape));
  }
  const bool has_bytes = positions.view || primitive.draco;
  if (!has_bytes && positions.count > model.n_bytes) part.fail("POSITION has more values than the file has bytes");
  const auto check = [&](const NamedNumbers& attributes) {
    for (const auto& [name, accessor] : attributes) {
      const std::size_t count = model.accessors[accessor].count;
      if (count < positions.count) {
        part.fail(printable(name) + " has " + std::to_string(count) + " values for " + std::to_string(positions.count) +
                  " vertices");
      }
    }
  };
  check(primitive.attributes);
  for (const NamedNumbers& target : primitive.targets) check(target);
}

void check_indices(const Model& model, const Part& part, const Primitive& primitive) {
  if (!primitive.indices) return;
  const Accessor& indices = model.accessors[*primitive.indices];
  if (indices.shape != ElementShape{1, 1} || !is_integer(indices.type) || indices.is_normalized) {
    part.fail("its indices are not plain whole numbers");
  }
  const bool has_bytes = indices.view || primitive.draco;
  if (!has_bytes && indices.count > model.n_bytes) part.fail("it has more indices than the file has bytes");
}

Primitive read_primitive(const Model& model, const Part& part) {
  Primitive primitive;
  const std::size_t n_accessors = model.accessors.size();
  primitive.mode = static_cast<PrimitiveMode>(part.index("mode", n_modes, "mode").value_or(4));
  if (const std::optional<Part> attributes = part.object("attributes")) {
    primitive.attributes = attributes->named_indices(n_accessors, "accessor");
  }
  for (const Part& target : part.array("targets", "target")) {
    primitive.targets.push_back(target.named_indices(n_accessors, "accessor"));
  }
  primitive.indices = part.index("indices", n_accessors, "accessor");
  primitive.material = part.whole("material");
  if (const std::optional<Part> draco = part.extension(draco_extension)) primitive.draco = read_draco(model, *draco);
  if (primitive.mode >= PrimitiveMode::triangles) {
    check_indices(model, part, primitive);
    check_counts(model, part, primitive);
  }
  return primitive;
}

template <std::size_t n>
void read_numbers(const Part& part, std::string_view key, std::array<double, n>& vector) {
  if (const auto numbers = part.numbers(key, n)) std::copy(numbers->begin(), numbers->end(), vector.begin());
}

void read_placement(const Part& part, Node& node) {
  if (const auto matrix = part.numbers("matrix", 16)) {
    node.matrix = Eigen::Map<const Eigen::Matrix4d>(matrix->data());
    return;
  }
  Transform& transform = node.transform.emplace();
  read_numbers(part, "translation", transform.translation);
  read_numbers(part, "rotation", transform.rotation);
  read_numbers(part, "scale", transform.scale);
  node.matrix = transform.matrix();
}

NamedNumbers read_instances(const Model& model, const Part& node) {
  const std::optional<Part> part = node.extension(instancing_extension);
  const std::optional<Part> attributes = part ? part->object("attributes") : std::nullopt;
  if (!attributes) return {};
  NamedNumbers instances = attributes->named_indices(model.accessors.size(), "accessor");
  for (const auto& [name, accessor] : instances) {
    if (model.accessors[accessor].count > model.n_bytes) attributes->fail("more instances than the file has bytes");
  }
  return instances;
}

/// \throw io::ReadError if a node is among its own descendants
void check_for_loops(const Model& model, const Part& root) {
  constexpr std::size_t no_walk = ~std::size_t{0};
  std::vector<std::size_t> seen_in(model.nodes.size(), no_walk);
  for (std::size_t start = 0; start < model.nodes.size(); ++start) {
    std::optional<std::size_t> node = start;
    while (node && seen_in[*node] == no_walk) {
      seen_in[*node] = start;
      node = model.nodes[*node].parent;
    }
    if (node && seen_in[*node] == start) root.fail("node " + std::to_string(*node) + " is its own descendant");
  }
}

}  // namespace

void read_meshes(Model& model, const Part& root) {
  for (const Part& part : root.array("meshes", "mesh")) {
    Mesh mesh;
    for (const Part& primitive : part.array("primitives", "primitive")) {
      mesh.primitives.push_back(read_primitive(model, primitive));
    }
    model.meshes.push_back(std::move(mesh));
  }
}

void read_nodes(Model& model, const Part& root) {
  const std::vector<Part> parts = root.array("nodes", "node");
  model.nodes.resize(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Node& node = model.nodes[i];
    read_placement(parts[i], node);
    node.mesh = parts[i].index("mesh", model.meshes.size(), "mesh");
    if (node.mesh) node.instances = read_instances(model, parts[i]);
    for (const std::size_t child : parts[i].indices("children", parts.size(), "node")) {
      if (!model.nodes[child].parent) model.nodes[child].parent = i;
    }
  }
  check_for_loops(model, root);
}

}  // namespace whittle::gltf
