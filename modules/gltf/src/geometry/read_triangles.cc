#include "geometry/read_triangles.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "geometry/layout.hh"
#include "geometry/surface.hh"
#include "model/read_model.hh"
#include "whittle/core/attribute_kinds.hh"

namespace whittle::gltf {
namespace {

/// A primitive's triangles, and which of its vertices they use.
struct UsedSurface {
  std::size_t primitive;
  Surface surface;
  std::vector<Index> used;  // ascending
};

/// Renumbers the vertices of the faces: the used ones, from 0 on. Returns these.
std::vector<Index> keep_used_vertices(Surface& surface) {
  std::vector<Index> numbers(surface.n_vertices, invalid_index);
  for (const Triangle& face : surface.faces) {
    for (const Index v : face) numbers[v] = 0;
  }
  std::vector<Index> used;
  for (Index v = 0; v < numbers.size(); ++v) {
    if (numbers[v] == invalid_index) continue;
    numbers[v] = static_cast<Index>(used.size());
    used.push_back(v);
  }
  for (Triangle& face : surface.faces) {
    for (Index& v : face) v = numbers[v];
  }
  return used;
}

std::vector<UsedSurface> read_surfaces(const Model& model, std::size_t mesh) {
  std::vector<UsedSurface> surfaces;
  const auto& primitives = model.meshes[mesh].primitives;
  for (std::size_t p = 0; p < primitives.size(); ++p) {
    if (!primitives[p].is_surface()) continue;
    UsedSurface used{p, read_surface(model, mesh, p), {}};
    used.used = keep_used_vertices(used.surface);
    surfaces.push_back(std::move(used));
  }
  return surfaces;
}

/// Reads a value; components that aren't finite become zero.
void read_finite(const Elements& elements, std::size_t i, std::span<double> components) {
  elements.read(i, components);
  for (double& x : components) {
    if (!std::isfinite(x)) x = 0;
  }
}

/// Fills the arrays of a mesh from its surfaces, one after another.
class Filler {
 public:
  Filler(const Model& model, std::size_t number, std::size_t n_vertices, IndexedMesh& to)
      : model_(model), number_(number), n_vertices_(n_vertices), mesh_(to) {
    mesh_.positions.reserve(n_vertices);
    mesh_.attributes = attributes_of(model, model.meshes[number]);
    for (Attribute& attribute : mesh_.attributes) attribute.values.resize(n_vertices * attribute.n_components);
    n_sets_ = n_joint_sets(model.meshes[number]);
  }

  void add(const UsedSurface& surface) {
    const std::size_t first = mesh_.positions.size();
    for (Triangle face : surface.surface.faces) {
      for (Index& v : face) v += static_cast<Index>(first);
      mesh_.faces.push_back(face);
      mesh_.face_groups.push_back(static_cast<Index>(surface.primitive));
    }
    add_positions(surface);
    const Primitive& primitive = model_.meshes[number_].primitives[surface.primitive];
    for (const Channel& channel : channels_of(primitive)) {
      const Elements& elements = *surface.surface.attribute(channel.name);
      if (channel.name == "NORMAL") {
        fill_normals(elements, surface.used, first);
      } else if (channel.name == "COLOR_0") {
        fill_colors(elements, surface.used, first);
      } else if (channel.name != "POSITION") {
        fill(place_of(model_, channel, primitive, n_sets_), elements, surface.used, first);
      }
    }
  }

 private:
  void add_positions(const UsedSurface& surface) {
    const Elements& positions = *surface.surface.attribute("POSITION");
    for (const Index v : surface.used) {
      Vec3 position;
      positions.read(v, std::span(position.data(), 3));
      if (!(position.array().abs() <= largest_coordinate).all()) {
        fail_in_primitive(model_, number_, surface.primitive,
                          "the position of vertex " + std::to_string(v) + " is not finite");
      }
      mesh_.positions.push_back(position);
    }
  }

  void fill_normals(const Elements& elements, std::span<const Index> used, std::size_t first) {
    mesh_.normals.resize(n_vertices_);
    for (std::size_t i = 0; i < used.size(); ++i) {
      std::array<double, 3> normal{};
      read_finite(elements, used[i], normal);
      for (std::size_t k = 0; k < 3; ++k) mesh_.normals[first + i][k] = static_cast<float>(normal[k]);
    }
  }

  void fill_colors(const Elements& elements, std::span<const Index> used, std::size_t first) {
    mesh_.colors.resize(n_vertices_);
    for (std::size_t i = 0; i < used.size(); ++i) {
      std::array<double, 4> color{0, 0, 0, 1};
      read_finite(elements, used[i], color);
      for (std::size_t k = 0; k < 4; ++k) mesh_.colors[first + i][k] = static_cast<float>(color[k]);
    }
  }

  void fill(const Place& place, const Elements& elements, std::span<const Index> used, std::size_t first) {
    Attribute& attribute = *std::find_if(mesh_.attributes.begin(), mesh_.attributes.end(),
                                         [&](const Attribute& a) { return a.name == place.attribute; });
    if (place.first >= attribute.n_components) return;  // as two channels of one name may be
    const std::size_t n = std::min(place.n, attribute.n_components - place.first);
    for (std::size_t i = 0; i < used.size(); ++i) {
      read_finite(elements, used[i], attribute.value(first + i).subspan(place.first, n));
    }
  }

  const Model& model_;
  std::size_t number_;
  std::size_t n_vertices_;
  IndexedMesh& mesh_;
  std::size_t n_sets_ = 0;
};

}  // namespace

std::vector<std::string> material_names(const Model& model, const Json& document, std::size_t mesh) {
  const Json* const materials = member(document, "materials");
  std::vector<std::string> names;
  for (const Primitive& primitive : model.meshes[mesh].primitives) {
    std::string name = "no material";
    if (primitive.material) {
      name = "material " + std::to_string(*primitive.material);
      if (materials && materials->is_array() && *primitive.material < materials->size()) {
        const Json* const text = member((*materials)[*primitive.material], "name");
        if (text && text->is_string()) name = printable(text->get_ref<const std::string&>());
      }
    }
    names.push_back(std::move(name));
  }
  return names;
}

IndexedMesh read_triangles(const Model& model, const Json& document, std::size_t mesh) {
  IndexedMesh triangles;
  const std::vector<UsedSurface> surfaces = read_surfaces(model, mesh);
  std::size_t n_vertices = 0;
  std::size_t n_faces = 0;
  for (const UsedSurface& surface : surfaces) {
    n_vertices += surface.used.size();
    n_faces += surface.surface.faces.size();
    if (n_vertices >= invalid_index || n_faces >= invalid_index) {
      fail_in_primitive(model, mesh, surface.primitive, "the mesh has too many vertices or triangles");
    }
  }
  Filler filler(model, mesh, n_vertices, triangles);
  for (const UsedSurface& surface : surfaces) filler.add(surface);
  find_whole_categories(triangles);
  triangles.group_names = material_names(model, document, mesh);
  return triangles;
}

}  // namespace whittle::gltf
