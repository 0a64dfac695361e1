// The extension `whittle._core`: what the package makes its interface of. Its functions are not for users.
#include <nanobind/nanobind.h>

#include "levels.hh"
#include "measure.hh"
#include "mesh.hh"
#include "options.hh"
#include "polish.hh"
#include "simplify.hh"
#include "whittle/io/errors.hh"
#include "whittle/progressive/recording.hh"
#include "whittle/scene/errors.hh"
#include "whittle/version.hh"
#include "wishes.hh"

NB_MODULE(_core, module) {
  namespace nb = nanobind;
  module.attr("__version__") = whittle::version();
  nb::exception<whittle::io::ReadError>(module, "ReadError", PyExc_ValueError);
  nb::exception<whittle::io::WriteError>(module, "WriteError", PyExc_OSError);
  nb::exception<whittle::progressive::RecordingError>(module, "RecordingError", PyExc_ValueError);
  nb::exception<whittle::UnsupportedMesh>(module, "UnsupportedMesh", PyExc_ValueError);
  whittle::python::bind_options(module);
  whittle::python::bind_mesh(module);
  whittle::python::bind_wishes(module);
  whittle::python::bind_simplify(module);
  whittle::python::bind_levels(module);
  whittle::python::bind_measure(module);
  whittle::python::bind_polish(module);
}
