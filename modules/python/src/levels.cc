#include "levels.hh"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <sstream>
#include <stdexcept>
#include <utility>

#include "mesh.hh"
#include "observer.hh"
#include "whittle/progressive/geomorph.hh"
#include "whittle/progressive/recording.hh"
#include "whittle/progressive/replay.hh"
#include "wishes.hh"

namespace whittle::python {
namespace {

/// A mesh of a scene's content.
Mesh mesh_in(const Scene& scene, IndexedMesh mesh, bool is_float32) {
  Mesh result{.scene = {}, .replaced = std::move(mesh), .is_float32 = is_float32};
  result.scene.name = result.scene.mesh_name = scene.name;
  result.scene.format = scene.format;
  result.scene.read.notes = scene.read.notes;
  return result;
}

/// \param n_faces descending
std::vector<Mesh> levels(Scene scene, bool is_float32, const std::vector<std::uint64_t>& n_faces, const Wishes& wishes,
                         nb::object progress) {
  Request request = request_of(wishes);
  request.targets.faces = n_faces.front();
  set_options(wishes, request);
  Observer observer(std::move(progress));
  return observer.call([&] {
    const Plan settled = plan(std::move(scene), request);
    SimplifyOptions options = settled.options;
    options.pauses = std::nullopt;
    options.decimate.progress = [run = observer.of_run()](const Progress& p) { return run(run_progress(p)); };
    std::vector<DecimateTarget> targets;
    targets.reserve(n_faces.size());
    for (const std::uint64_t n : n_faces) targets.push_back(DecimateTarget::faces(n));
    std::vector<Mesh> meshes;
    for (Simplification& level : simplify_to_levels(settled.scene.read.mesh, targets, request.effort, options)) {
      meshes.push_back(mesh_in(settled.scene, std::move(level.mesh), is_float32));
    }
    observer.check();
    return meshes;
  });
}

/// The levels of a run.
class Recording {
 public:
  explicit Recording(const std::string& bytes) : bytes_(bytes) {
    std::istringstream in(bytes);
    progressive::Recording recording = progressive::read_recording(in);
    if (!recording.input) throw std::invalid_argument("the recording hasn't the input mesh in it");
    replay_.emplace(std::move(*recording.input), std::move(recording.steps), recording.normals);
  }

  const std::string& bytes() const { return bytes_; }
  progressive::Replay& replay() { return *replay_; }
  Mesh level(std::size_t step) {
    replay_->go_to(step);
    return mesh(replay_->decimation().mesh);
  }
  /// The last level with at most so many. \throw std::invalid_argument if there is none
  std::size_t level_of(std::optional<std::uint64_t> n_faces, std::optional<std::uint64_t> n_vertices) const {
    const std::optional<std::size_t> level =
        n_faces ? replay_->level_of_faces(*n_faces) : replay_->level_of_vertices(n_vertices.value_or(0));
    if (!level) throw std::invalid_argument("the last level of the recording has more");
    return *level;
  }
  static Mesh mesh(IndexedMesh mesh) {
    Mesh result{.scene = {}, .replaced = std::move(mesh)};
    result.scene.name = result.scene.mesh_name = "mesh";
    result.scene.format = &format_of(io::Format::ply);
    return result;
  }

 private:
  std::string bytes_;
  std::optional<progressive::Replay> replay_;
};

}  // namespace

void bind_levels(nb::module_& module) {
  module.def(
      "levels",
      [](Mesh& mesh, bool is_used_up, const std::vector<std::uint64_t>& n_faces, const Wishes& wishes,
         nb::object progress) {
        return levels(scene_to_simplify(mesh, is_used_up), mesh.is_float32, n_faces, wishes, std::move(progress));
      },
      nb::arg("mesh"), nb::arg("is_used_up"), nb::arg("n_faces"), nb::arg("wishes"), nb::arg("progress").none());
  nb::class_<progressive::Geomorph>(module, "Geomorph")
      .def(
          "at", [](const progressive::Geomorph& morph, double share) { return Recording::mesh(morph.at(share)); },
          nb::arg("share"))
      .def("glb", [](const progressive::Geomorph& morph) {
        std::ostringstream out;
        progressive::write_glb(out, morph);
        const std::string bytes = std::move(out).str();
        return nb::bytes(bytes.data(), bytes.size());
      });
  nb::class_<Recording>(module, "Recording")
      .def(
          "__init__",
          [](Recording* self, const nb::bytes& bytes) {
            new (self) Recording(std::string(bytes.c_str(), bytes.size()));
          },
          nb::arg("bytes"))
      .def_prop_ro(
          "bytes",
          [](const Recording& recording) { return nb::bytes(recording.bytes().data(), recording.bytes().size()); })
      .def_prop_ro("n_levels", [](Recording& recording) { return recording.replay().n_steps() + 1; })
      .def_prop_ro("n_faces", [](Recording& recording) { return recording.replay().input().faces.size(); })
      .def_prop_ro("n_vertices", [](Recording& recording) { return recording.replay().input().positions.size(); })
      .def("level", &Recording::level, nb::arg("step"))
      .def("level_of", &Recording::level_of, nb::arg("n_faces").none(), nb::arg("n_vertices").none())
      .def(
          "geomorph",
          [](Recording& recording, std::size_t fine, std::size_t coarse) {
            return progressive::Geomorph(recording.replay(), fine, coarse);
          },
          nb::arg("fine"), nb::arg("coarse"));
}

}  // namespace whittle::python
