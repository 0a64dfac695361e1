#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "whittle/engine/decimate_target.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::web {

/// A value as JavaScript gives it.
struct GivenValue {
  std::string_view text;    ///< for words
  double number = 0;        ///< NaN if it is none
  bool is_percent = false;  ///< whether the number stood before a %
};

/// A length in model units, or a share of the diagonal of the mesh's bounding box.
struct GivenLength {
  double value = 0;
  bool is_relative = false;

  double in_units(double diagonal) const { return is_relative ? value * diagonal : value; }
};

/// The options of a run, before the mesh is known.
struct Settings {
  Effort effort = Effort::normal;
  SimplifyOptions options;
  std::optional<std::uint64_t> faces;
  std::optional<std::uint64_t> vertices;
  std::optional<double> ratio;
  std::optional<double> face_ratio;
  std::optional<double> max_cost;
  std::optional<GivenLength> max_error;
  std::optional<GivenLength> max_border_error;
  std::optional<GivenLength> threshold;
  std::optional<GivenLength> prune;
  GivenLength feature_tolerance{5e-4, true};

  bool has_target() const;
  /// The same as `resolve` of the pipeline, for the same options. \param diagonal of the mesh's bounding box
  DecimateTarget target(std::size_t n_vertices, std::size_t n_faces, double diagonal) const;
};

/// Sets the option of this name, a name of the program without "--".
/// \throw std::invalid_argument that says what is valid, or for an unknown name
void set_option(std::string_view name, const GivenValue& value, Settings& settings);

/// The names of all options that `set_option` knows, with spaces between.
std::string_view option_names();

}  // namespace whittle::web
