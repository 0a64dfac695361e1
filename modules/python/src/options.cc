#include "options.hh"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <string>
#include <vector>

#include "whittle/pipeline/request.hh"

namespace whittle::python {
namespace {

namespace nb = nanobind;

/// An option as the interface in Python needs it.
struct Row {
  std::string name, meta, group, help, standard;
};

std::vector<Row> rows() {
  Request request;
  std::vector<Row> rows;
  for (const OptionRow& row : option_rows(request)) {
    if (row.names.empty()) continue;  // it is reported alone
    const std::string standard = row.standard.empty() ? to_string(row.access.get()) : row.standard;
    rows.push_back({long_name(row), row.access.meta, row.group, row.help, standard});
  }
  return rows;
}

}  // namespace

void bind_options(nb::module_& module) {
  nb::class_<Row>(module, "OptionRow")
      .def_ro("name", &Row::name)
      .def_ro("meta", &Row::meta)
      .def_ro("group", &Row::group)
      .def_ro("help", &Row::help)
      .def_ro("standard", &Row::standard);
  module.def("option_rows", &rows);
}

}  // namespace whittle::python
