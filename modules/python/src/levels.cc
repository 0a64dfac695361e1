#include "levels.hh"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "mesh.hh"
#include "observer.hh"
#include "whittle/pipeline/levels.hh"
#include "whittle/pipeline/values.hh"
#include "whittle/progressive/geomorph.hh"
#include "whittle/progressive/recording.hh"
#include "whittle/progressive/replay.hh"
#include "wishes.hh"

namespace whittle::python {
namespace {

/// A level, and what is proven of it.
struct Level : Mesh {
  std::optional<double> error;  ///< model units
};

/// A level as a mesh of the scene, which is written with what else the scene has.
Level level_in(const Scene& scene, whittle::Level level, bool is_float32) {
  Level result;
  result.scene = scene;
  if (!scene.document) result.scene.read.mesh = {};
  result.replaced = std::move(level.simplified.mesh);
  result.is_float32 = is_float32;
  result.error = level.error;
  return result;
}

std::vector<Length> lengths_of(const std::vector<std::string>& texts) {
  std::vector<Length> lengths;
  lengths.reserve(texts.size());
  for (const std::string& text : texts) lengths.push_back(parse_length(text, "E"));
  return lengths;
}

/// The target of the finest level, by which a plan settles what depends on one.
Targets finest_of(const LevelTargets& levels) {
  Targets targets;
  if (!levels.faces.empty()) targets.faces = *std::max_element(levels.faces.begin(), levels.faces.end());
  if (!levels.ratios.empty()) targets.ratio = *std::max_element(levels.ratios.begin(), levels.ratios.end());
  if (!levels.face_ratios.empty()) {
    targets.face_ratio = *std::max_element(levels.face_ratios.begin(), levels.face_ratios.end());
  }
  if (!levels.errors.empty()) targets.faces = 1;  // the run goes as far as it can
  return targets;
}

/// \return the levels, and warnings
std::pair<std::vector<Level>, std::vector<std::string>> levels(Scene scene, bool is_float32,
                                                               const LevelTargets& targets, const Wishes& wishes,
                                                               nb::object progress) {
  Request request = request_of(wishes);
  request.targets = finest_of(targets);
  std::vector<std::string> warnings = set_options(wishes, request);
  Observer observer(std::move(progress));
  return observer.call([&] {
    const Plan settled = plan(std::move(scene), request);
    SimplifyOptions options = settled.options;
    options.pauses = std::nullopt;
    options.decimate.progress = [run = observer.of_run()](const Progress& p) { return run(run_progress(p)); };
    Levels made = make_levels(settled.scene, targets, request.effort, options, request.output, request.reading);
    std::vector<Level> meshes;
    for (whittle::Level& level : made.levels) meshes.push_back(level_in(settled.scene, std::move(level), is_float32));
    warnings.insert(warnings.end(), settled.warnings.begin(), settled.warnings.end());
    warnings.insert(warnings.end(), made.warnings.begin(), made.warnings.end());
    return std::pair(std::move(meshes), std::move(warnings));
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
  nb::class_<Level, Mesh>(module, "Level").def_ro("error", &Level::error);
  nb::class_<LevelTargets>(module, "LevelTargets")
      .def(nb::init<>())
      .def_rw("ratios", &LevelTargets::ratios)
      .def_rw("face_ratios", &LevelTargets::face_ratios)
      .def_rw("faces", &LevelTargets::faces)
      .def("set_errors",
           [](LevelTargets& targets, const std::vector<std::string>& texts) { targets.errors = lengths_of(texts); });
  module.def(
      "levels",
      [](Mesh& mesh, bool is_used_up, const LevelTargets& targets, const Wishes& wishes, nb::object progress) {
        return levels(scene_to_simplify(mesh, is_used_up), mesh.is_float32, targets, wishes, std::move(progress));
      },
      nb::arg("mesh"), nb::arg("is_used_up"), nb::arg("targets"), nb::arg("wishes"), nb::arg("progress").none());
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
