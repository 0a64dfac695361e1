#include "mesh.hh"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "whittle/core/text/text.hh"
#include "whittle/core/wedges.hh"
#include "whittle/io/output_files.hh"
#include "whittle/pipeline/values.hh"
#include "whittle/scene/read_scene.hh"
#include "whittle/scene/scene_document.hh"
#include "whittle/scene/write_scene.hh"

namespace whittle::python {
namespace {

/// Name, kind, values.
using Named = std::tuple<std::string, std::string, Array>;

struct FaceArrays {
  std::vector<std::pair<std::string, Array>> attributes;
  std::optional<Array> groups;
  std::vector<std::string> group_names;
};

SceneReadOptions read_options(const std::string& weld, unsigned threads) {
  SceneReadOptions options;
  options.threads = threads;
  options.weld = weld != "off";
  if (weld == "auto") options.weld_tolerance.is_automatic = true;
  if (weld != "off" && weld != "auto") options.weld_tolerance.length = parse_length(weld, "T");
  return options;
}

void check_rows(const Array& array, std::size_t n, const std::string& name, const char* what) {
  if (array.ndim() > 0 && array.shape(0) == n) return;
  throw std::invalid_argument(name + " has not one value for each of " + std::to_string(n) + ' ' + what);
}

void add_face_arrays(const FaceArrays& arrays, IndexedMesh& mesh) {
  const std::size_t n = mesh.faces.size();
  for (const auto& [name, values] : arrays.attributes) {
    check_rows(values, n, name, "faces");
    Attribute attribute{.name = name, .values = numbers(values), .type = ScalarType::float64};
    if (n > 0) attribute.n_components = attribute.values.size() / n;
    mesh.face_attributes.push_back(std::move(attribute));
  }
  if (!arrays.groups) return;
  check_rows(*arrays.groups, n, "face_groups", "faces");
  mesh.face_groups = indices(*arrays.groups);
  mesh.group_names = arrays.group_names;
  Index n_groups = 0;
  for (const Index group : mesh.face_groups) n_groups = std::max(n_groups, group + 1);
  while (mesh.group_names.size() < n_groups) mesh.group_names.push_back(std::to_string(mesh.group_names.size()));
}

Mesh from_arrays(const Array& points, const Array& faces, const std::vector<Named>& arrays,
                 const FaceArrays& face_arrays, const std::optional<Array>& tolerances, const std::string& weld,
                 unsigned threads) {
  IndexedMesh mesh = mesh_of(points, faces);
  std::vector<NamedArray> attributes;
  for (const auto& [name, kind, values] : arrays) attributes.push_back({name, kind, values});
  add_attributes(attributes, mesh);
  add_face_arrays(face_arrays, mesh);
  std::vector<double> lengths;
  if (tolerances) {
    check_rows(*tolerances, mesh.positions.size(), "tolerances", "points");
    lengths = numbers(*tolerances);
  }
  Mesh result;
  result.is_float32 = points.dtype() == nb::dtype<float>();
  const nb::gil_scoped_release without_interpreter;
  result.scene = scene_of(std::move(mesh), "mesh", std::move(lengths), read_options(weld, threads));
  result.scene.read.notes.has_float32_positions = result.is_float32;
  return result;
}

Mesh read(const std::string& path, const std::string& weld, bool as_shown, unsigned threads) {
  const nb::gil_scoped_release without_interpreter;
  SceneReadOptions options = read_options(weld, threads);
  options.scope = as_shown ? SceneScope::scene : SceneScope::meshes;
  Mesh result;
  result.scene = read_scene(path, options);
  return result;
}

/// What a file loses because of the way in which its scene was read: a line, or empty.
std::string lost_by_scope(const Scene& scene, const IndexedMesh& mesh, const SceneOutput& output) {
  if (!scene.document) return {};
  if (output.format->is_document && !keeps_meshes(scene)) {
    const std::string lost = scene.document->left_out_of_one_mesh(mesh);
    return lost.empty() ? lost : about(output.path, "left out: " + lost + "; 'as_shown=False' at reading keeps it");
  }
  if (output.format->is_document || !keeps_meshes(scene)) return {};
  const std::vector<PlacedMesh> shown = scene.document->shown_meshes();
  const bool is_repeated = std::any_of(shown.begin(), shown.end(), [](const auto& m) { return m.places.size() > 1; });
  if (!is_repeated) return {};
  return about(output.path,
               "each mesh stands once, and the scene shows some several times; 'as_shown=True' at reading "
               "places them all");
}

/// \return warnings
std::vector<std::string> write(Mesh& mesh, const std::string& path, bool ascii, bool compress, bool quantize,
                               bool merge_meshes) {
  const nb::gil_scoped_release without_interpreter;
  SceneOutput output{path, format_by_name(path), ascii, {compress, quantize, merge_meshes}};
  if (output.format == nullptr) output.format = &format_of(io::format_of(path));  // which says what is wrong
  SceneMessages messages;
  io::OutputFiles files;
  files.protect(mesh.scene.needed_files);
  write_scene(files, output, mesh.scene, mesh.mesh(), messages);
  files.commit();
  if (std::string lost = lost_by_scope(mesh.scene, mesh.mesh(), output); !lost.empty()) {
    messages.warnings.push_back(std::move(lost));
  }
  return messages.warnings;
}

nb::object points(nb::handle self) {
  Mesh& mesh = nb::cast<Mesh&>(self);
  std::vector<Vec3>& positions = mesh.mesh().positions;
  if (!mesh.is_float32) return view(positions.data()->data(), positions.size(), 3, self);
  auto* const numbers = new float[3 * positions.size()];
  const nb::capsule owner(numbers, [](void* p) noexcept { delete[] static_cast<float*>(p); });
  for (std::size_t v = 0; v < positions.size(); ++v) {
    for (std::size_t i = 0; i < 3; ++i) {
      numbers[3 * v + i] = static_cast<float>(positions[v][static_cast<Eigen::Index>(i)]);
    }
  }
  const std::size_t shape[2] = {positions.size(), 3};
  return nb::cast(NewArray<float>(numbers, 2, shape, owner));
}

nb::object faces(nb::handle self) {
  std::vector<Triangle>& faces = nb::cast<Mesh&>(self).mesh().faces;
  return view(faces.data()->data(), faces.size(), 3, self);
}

/// (F, 3); None where each vertex has one wedge.
nb::object wedges(nb::handle self) {
  IndexedMesh& mesh = nb::cast<Mesh&>(self).mesh();
  if (mesh.wedges.empty()) return nb::none();
  return view(mesh.wedges.data(), mesh.faces.size(), 3, self);
}

nb::list described(std::span<Attribute> attributes, nb::handle self) {
  nb::list list;
  for (Attribute& attribute : attributes) {
    const std::size_t n = attribute.n_components;
    list.append(nb::make_tuple(attribute.name, attribute.kind == AttributeKind::texcoord,
                               view(attribute.values.data(), attribute.size(), n == 1 ? 0 : n, self)));
  }
  return list;
}

}  // namespace

Scene scene_to_simplify(Mesh& mesh, bool is_used_up) {
  Scene scene = is_used_up ? std::move(mesh.scene) : mesh.scene;
  if (!mesh.replaced) return scene;
  io::ReadResult& read = scene.read;
  read.mesh = is_used_up ? std::move(*mesh.replaced) : *mesh.replaced;
  read.file_vertices = read.mesh.positions.size();
  read.file_faces = read.mesh.faces.size();
  read.mesh.origins.resize(read.file_vertices);
  std::iota(read.mesh.origins.begin(), read.mesh.origins.end(), Index{0});
  read.vertex_map = read.mesh.origins;
  read.tolerances.clear();
  read.repairs = {};
  scene.warnings.clear();
  return scene;
}

std::vector<std::int64_t> signed_numbers(std::span<const Index> numbers) {
  std::vector<std::int64_t> result;
  result.reserve(numbers.size());
  for (const Index number : numbers) result.push_back(number == invalid_index ? -1 : std::int64_t{number});
  return result;
}

void bind_mesh(nb::module_& module) {
  nb::class_<FaceArrays>(module, "FaceArrays")
      .def(
          "__init__",
          [](FaceArrays* self, std::vector<std::pair<std::string, Array>> attributes, std::optional<Array> groups,
             std::vector<std::string> names) {
            new (self) FaceArrays{std::move(attributes), std::move(groups), std::move(names)};
          },
          nb::arg("attributes"), nb::arg("groups").none(), nb::arg("group_names"));
  nb::class_<Mesh>(module, "Mesh")
      .def_static("from_arrays", &from_arrays, nb::arg("points"), nb::arg("faces"), nb::arg("arrays"),
                  nb::arg("face_arrays"), nb::arg("tolerances").none(), nb::arg("weld"), nb::arg("threads"))
      .def_static("read", &read, nb::arg("path"), nb::arg("weld"), nb::arg("as_shown"), nb::arg("threads"))
      .def("write", &write, nb::arg("path"), nb::arg("ascii"), nb::arg("compress"), nb::arg("quantize"),
           nb::arg("merge_meshes"))
      .def_prop_ro("points", &points)
      .def_prop_ro("faces", &faces)
      .def_prop_ro("wedges", &wedges)
      .def_prop_ro("normals",
                   [](nb::handle self) -> nb::object {
                     auto& normals = nb::cast<Mesh&>(self).mesh().normals;
                     if (normals.empty()) return nb::none();
                     return view(normals.data()->data(), normals.size(), 3, self);
                   })
      .def_prop_ro("colors",
                   [](nb::handle self) -> nb::object {
                     auto& colors = nb::cast<Mesh&>(self).mesh().colors;
                     if (colors.empty()) return nb::none();
                     return view(colors.data()->data(), colors.size(), 4, self);
                   })
      .def_prop_ro("attributes",
                   [](nb::handle self) { return described(nb::cast<Mesh&>(self).mesh().attributes, self); })
      .def_prop_ro("face_attributes",
                   [](nb::handle self) { return described(nb::cast<Mesh&>(self).mesh().face_attributes, self); })
      .def_prop_ro("face_groups",
                   [](nb::handle self) -> nb::object {
                     auto& groups = nb::cast<Mesh&>(self).mesh().face_groups;
                     if (groups.empty()) return nb::none();
                     return view(groups.data(), groups.size(), 0, self);
                   })
      .def_prop_ro("group_names", [](const Mesh& mesh) { return mesh.mesh().group_names; })
      .def_prop_ro("origins", [](const Mesh& mesh) { return array_of(signed_numbers(mesh.mesh().origins)); })
      .def_prop_ro("warnings", [](const Mesh& mesh) { return mesh.scene.warnings; })
      .def_prop_ro("repairs",
                   [](const Mesh& mesh) {
                     nb::dict repairs;
                     for (const auto& [name, n] : mesh.scene.read.repairs.entries()) {
                       repairs[nb::str(name.data(), name.size())] = n;
                     }
                     return repairs;
                   })
      .def("split_at_seams", [](const Mesh& mesh) {
        Mesh split{.scene = {}, .replaced = split_at_wedges(mesh.mesh()), .is_float32 = mesh.is_float32};
        split.scene.name = split.scene.mesh_name = mesh.scene.name;
        split.scene.format = mesh.scene.format;
        return split;
      });
}

}  // namespace whittle::python
