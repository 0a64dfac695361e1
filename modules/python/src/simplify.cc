#include "simplify.hh"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "mesh.hh"
#include "observer.hh"
#include "whittle/pipeline/json.hh"
#include "whittle/progressive/recording.hh"
#include "wishes.hh"

namespace whittle::python {
namespace {

/// What Python has of a run.
struct Result : Mesh {
  std::string report;                 ///< JSON
  std::vector<std::string> warnings;  ///< a line each
  std::vector<Index> vertex_map;      ///< points that were given → those of the result, or `invalid_index`
  std::vector<Index> face_origins;
  std::string certificate;
  std::optional<std::string> recording;
  bool met = false;
};

/// The vertices of the scene that stay, of points as they were given.
void lock(const Array& locked, Plan& plan) {
  const io::ReadResult& read = plan.scene.read;
  const std::vector<double> is_locked = numbers(locked);
  if (is_locked.size() != read.file_vertices) {
    throw std::invalid_argument("locked has not one value for each of " + std::to_string(read.file_vertices) +
                                " points");
  }
  std::vector<std::uint8_t>& all = plan.options.decimate.locked;
  all.resize(read.mesh.positions.size());
  for (std::size_t v = 0; v < is_locked.size(); ++v) {
    if (is_locked[v] != 0 && read.vertex_map[v] != invalid_index) all[read.vertex_map[v]] = 1;
  }
}

std::string recording_of(const Plan& plan, const Outcome& outcome) {
  std::ostringstream out;
  progressive::write_recording(out, plan.scene.read.mesh, outcome.simplified.steps, plan.options.decimate.normals,
                               "Python", {.threads = plan.threads()});
  return std::move(out).str();
}

std::string report_of(const Plan& plan, const Outcome& outcome, const std::vector<std::string>& warnings) {
  Request request = plan.request;
  Json json = new_report();
  json.update(run_json(plan, outcome, options_json(option_rows(request))));
  json["seconds"] = {
      {"decimate", outcome.seconds.decimate}, {"polish", outcome.seconds.polish}, {"certify", outcome.seconds.certify}};
  json["warnings"] = warnings;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// \pre the plan isn't needed any more
Result result_of(Plan plan, Outcome outcome, std::vector<std::string> warnings, bool is_float32) {
  Result result;
  result.is_float32 = is_float32;
  result.met = outcome.met;
  std::vector<std::string> more = all_warnings(plan, outcome);
  warnings.insert(warnings.end(), more.begin(), more.end());
  result.report = report_of(plan, outcome, warnings);
  if (plan.request.keeps_steps) result.recording = recording_of(plan, outcome);
  result.warnings = std::move(warnings);
  result.vertex_map = std::move(plan.scene.read.vertex_map);
  for (Index& v : result.vertex_map) v = v == invalid_index ? v : outcome.simplified.vertex_map[v];
  result.face_origins = std::move(outcome.simplified.face_origins);
  result.certificate = std::move(outcome.certificate);
  result.replaced = std::move(outcome.simplified.mesh);
  if (!plan.scene.document) plan.scene.read.mesh = {};
  result.scene = std::move(plan.scene);
  return result;
}

/// \param scene as it was read or made; it is used up
Result simplify(Scene scene, bool is_float32, const Wishes& wishes, nb::object progress) {
  Request request = request_of(wishes);
  std::vector<std::string> warnings = set_options(wishes, request);
  Observer observer(std::move(progress));
  return observer.call([&] {
    Plan settled = plan(std::move(scene), request);
    if (wishes.locked) lock(*wishes.locked, settled);
    Outcome outcome = run(settled, observer.of_run());
    return result_of(std::move(settled), std::move(outcome), std::move(warnings), is_float32);
  });
}

nb::bytes bytes_of(const std::string& text) { return nb::bytes(text.data(), text.size()); }

}  // namespace

void bind_simplify(nb::module_& module) {
  nb::class_<Result, Mesh>(module, "Result")
      .def_ro("report", &Result::report)
      .def_ro("warnings", &Result::warnings)
      .def_ro("met", &Result::met)
      .def_prop_ro("vertex_map", [](const Result& result) { return array_of(signed_numbers(result.vertex_map)); })
      .def_prop_ro("face_origins", [](const Result& result) { return array_of(signed_numbers(result.face_origins)); })
      .def_prop_ro("certificate", [](const Result& result) { return bytes_of(result.certificate); })
      .def_prop_ro("recording", [](const Result& result) -> nb::object {
        if (!result.recording) return nb::none();
        return bytes_of(*result.recording);
      });
  module.def(
      "simplify",
      [](Mesh& mesh, bool is_used_up, const Wishes& wishes, nb::object progress) {
        return simplify(scene_to_simplify(mesh, is_used_up), mesh.is_float32, wishes, std::move(progress));
      },
      nb::arg("mesh"), nb::arg("is_used_up"), nb::arg("wishes"), nb::arg("progress").none());
}

}  // namespace whittle::python
