#include "wishes.hh"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <stdexcept>

namespace whittle::python {

Request request_of(const Wishes& wishes) {
  Request request;
  request.reading.threads = wishes.threads;
  request.output.format = &format_of(io::Format::ply);  // it keeps every digit
  request.makes_certificate = wishes.certificate;
  request.keeps_steps = wishes.recording;
  return request;
}

std::vector<std::string> set_options(const Wishes& wishes, Request& request) {
  const OptionRows rows = option_rows(request);
  for (const auto& [name, value] : wishes.options) {
    const OptionRow* const row = find_row(rows, name);
    if (row == nullptr) throw std::invalid_argument("there is no option " + name);
    try {
      row->access.set(value);
    } catch (const std::invalid_argument& problem) {
      throw std::invalid_argument(name + ": " + problem.what());
    }
  }
  const IsGiven is_given = [&wishes](const std::string& side) {
    return std::any_of(wishes.options.begin(), wishes.options.end(), [&side](const auto& option) {
      return side == option.first || side == option.first + " " + option.second;
    });
  };
  const std::string conflict = find_conflict(rows, is_given);
  if (!conflict.empty()) throw std::invalid_argument(conflict);
  if (!request.targets.any()) throw std::invalid_argument("no target: give at least one");
  return find_idle(rows, is_given);
}

void bind_wishes(nb::module_& module) {
  nb::class_<Wishes>(module, "Wishes")
      .def(nb::init<>())
      .def_rw("options", &Wishes::options)
      .def_rw("locked", &Wishes::locked, nb::arg().none())
      .def_rw("certificate", &Wishes::certificate)
      .def_rw("recording", &Wishes::recording)
      .def_rw("threads", &Wishes::threads);
}

}  // namespace whittle::python
