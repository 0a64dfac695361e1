#include "measure.hh"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <limits>
#include <string_view>
#include <utility>

#include "mesh.hh"
#include "observer.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/metrics/certificate.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/pipeline/json.hh"
#include "whittle/verify/verify.hh"

namespace whittle::python {
namespace {

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

void add_quality(Json& json, const IndexedMesh& mesh, unsigned threads, Observer& observer) {
  add_topology(json, metrics::topology(mesh));
  add_shape(json, metrics::shape(mesh));
  json["self_intersections"] =
      metrics::self_intersections(mesh, threads, observer.of_task("counting intersections")).size();
}

std::string info(const Mesh& mesh, unsigned threads, nb::object progress) {
  Observer observer(std::move(progress));
  return observer.call([&] {
    const IndexedMesh& surface = mesh.mesh();
    Json json = {{"vertices", surface.positions.size()}, {"faces", surface.faces.size()}};
    add_quality(json, surface, threads, observer);
    return text_of(json);
  });
}

std::string measure(const Mesh& reference, const Mesh& test, std::size_t samples, std::uint64_t seed, unsigned threads,
                    nb::object progress) {
  Observer observer(std::move(progress));
  return observer.call([&] {
    const metrics::SurfaceDistance distance = metrics::surface_distance(
        reference.mesh(), test.mesh(), {samples, seed, threads, observer.of_task("measuring")});
    Json json = {{"diagonal", distance.diagonal}};
    add_distance(json, distance);
    add_quality(json, test.mesh(), threads, observer);
    return text_of(json);
  });
}

/// The largest distances, both ways, as far as they are proven.
std::string certify(const Mesh& reference, const Mesh& test, double accuracy, unsigned threads, nb::object progress) {
  Observer observer(std::move(progress));
  return observer.call([&] {
    const metrics::LargestDistances largest =
        metrics::largest_distances(reference.mesh(), test.mesh(), accuracy, {threads, observer.of_task("certifying")});
    const double diagonal = diagonal_of(bounds_of(reference.mesh().positions));
    Json json;
    add_length(json, "proven", proven_distance(largest), diagonal);
    json["forward"] = largest_json(largest.forward, diagonal);
    json["backward"] = largest_json(largest.backward, diagonal);
    return text_of(json);
  });
}

/// The steps of a proof; None if it fails.
nb::object certificate(const Mesh& reference, const Mesh& test, double max_error, unsigned threads,
                       nb::object progress) {
  Observer observer(std::move(progress));
  const std::optional<std::string> steps = observer.call([&] {
    return metrics::make_certificate(reference.mesh(), test.mesh(), {.surface = max_error},
                                     {.threads = threads, .progress = observer.of_task("certifying")});
  });
  if (!steps) return nb::none();
  return nb::bytes(steps->data(), steps->size());
}

verify::Triangles triangles_of(const IndexedMesh& mesh) {
  return {{mesh.positions.data()->data(), 3 * mesh.positions.size()},
          {mesh.faces.data()->data(), 3 * mesh.faces.size()}};
}

verify::Verification check(const Mesh& reference, const Mesh& test, const nb::bytes& certificate, unsigned threads) {
  const std::string_view steps(certificate.c_str(), certificate.size());
  const nb::gil_scoped_release without_interpreter;
  return verify::verify(triangles_of(reference.mesh()), triangles_of(test.mesh()), steps, threads);
}

}  // namespace

void bind_measure(nb::module_& module) {
  nb::class_<verify::Verification>(module, "Verification")
      .def_ro("holds", &verify::Verification::holds)
      .def_ro("max_error", &verify::Verification::max_error)
      .def_ro("max_error_borders", &verify::Verification::max_error_borders)
      .def_ro("why_not", &verify::Verification::why_not)
      .def("__bool__", [](const verify::Verification& found) { return found.holds; });
  module.def("info", &info, nb::arg("mesh"), nb::arg("threads"), nb::arg("progress").none());
  module.def("measure", &measure, nb::arg("reference"), nb::arg("test"), nb::arg("samples"), nb::arg("seed"),
             nb::arg("threads"), nb::arg("progress").none());
  module.def("certify", &certify, nb::arg("reference"), nb::arg("test"), nb::arg("accuracy"), nb::arg("threads"),
             nb::arg("progress").none());
  module.def("certificate", &certificate, nb::arg("reference"), nb::arg("test"), nb::arg("max_error"),
             nb::arg("threads"), nb::arg("progress").none());
  module.def("verify", &check, nb::arg("reference"), nb::arg("test"), nb::arg("certificate"), nb::arg("threads"));
}

}  // namespace whittle::python
