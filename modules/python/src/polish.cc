#include "polish.hh"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <string>
#include <utility>
#include <vector>

#include "mesh.hh"
#include "observer.hh"
#include "whittle/pipeline/json.hh"
#include "whittle/pipeline/polish_to_reference.hh"
#include "whittle/pipeline/request.hh"

namespace whittle::python {
namespace {

/// A mesh that was fitted, and what is known of that.
struct Polished : Mesh {
  std::string report;                 ///< JSON
  std::vector<std::string> warnings;  ///< a line each
};

Polished polish(const Mesh& reference, const Mesh& mesh, unsigned passes, const std::string& fit, unsigned threads,
                nb::object progress) {
  PolishRequest request{.passes = passes, .threads = threads};
  fit_row(request.fit).access.set(fit);
  Observer observer(std::move(progress));
  request.progress = observer.of_task("polishing");
  return observer.call([&] {
    Polished result{mesh, {}, {}};
    result.replaced = mesh.mesh();
    request.locked = held_borders(mesh.scene, mesh.mesh(), threads, result.warnings);
    const PolishResult done = polish_to_reference(reference.mesh(), *result.replaced, request);
    if (done.cancelled) throw Cancelled();
    result.report = polish_json(done).dump();
    return result;
  });
}

}  // namespace

void bind_polish(nb::module_& module) {
  nb::class_<Polished, Mesh>(module, "Polished")
      .def_ro("report", &Polished::report)
      .def_ro("warnings", &Polished::warnings);
  module.def("polish", &polish, nb::arg("reference"), nb::arg("mesh"), nb::arg("passes"), nb::arg("fit"),
             nb::arg("threads"), nb::arg("progress").none());
}

}  // namespace whittle::python
