#include "ply/ply_columns.hh"

#include <algorithm>
#include <cmath>
#include <limits>

#include "format/colors.hh"
#include "ply/ply_plan.hh"
#include "whittle/core/float32_positions.hh"

namespace whittle::io {
namespace {

struct Range {
  double least;
  double most;
};

template <class Integer>
constexpr Range range_of{std::numeric_limits<Integer>::min(), std::numeric_limits<Integer>::max()};

Range range(ScalarType type) {
  switch (type) {
    case ScalarType::int8:
      return range_of<std::int8_t>;
    case ScalarType::uint8:
      return range_of<std::uint8_t>;
    case ScalarType::int16:
      return range_of<std::int16_t>;
    case ScalarType::uint16:
      return range_of<std::uint16_t>;
    case ScalarType::int32:
      return range_of<std::int32_t>;
    case ScalarType::uint32:
      return range_of<std::uint32_t>;
    case ScalarType::float32:
    case ScalarType::float64:
      break;
  }
  return {0, 0};
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::size_t n_color_components(const IndexedMesh& mesh, const FileNotes& notes) {
  if (mesh.colors.empty()) return 0;
  return has_opacity(mesh) || contains(notes.vertex_properties, "alpha") ? 4 : 3;
}

ScalarType color_type(const WriteOptions& options) {
  const ScalarType noted = options.notes.color_type;
  if (options.exact_colors || noted == ScalarType::float32) return ScalarType::float32;
  return noted == ScalarType::uint16 ? noted : ScalarType::uint8;
}

/// A name that no column has yet.
std::string free_name(std::string name, const std::vector<PlyColumn>& columns) {
  const auto is_taken = [&](const std::string& tried) {
    return std::any_of(columns.begin(), columns.end(), [&](const PlyColumn& column) { return column.name == tried; });
  };
  if (!is_taken(name)) return name;
  for (int number = 2;; ++number) {
    std::string tried = name + "_" + std::to_string(number);
    if (!is_taken(tried)) return tried;
  }
}

/// The type of an attribute's properties. In PLY, integers are plain numbers, except colours. Their meaning in glTF (a
/// share of their range, or a value that a map moves) is real.
ScalarType type_in_ply(const Attribute& attribute, const std::string& first_name) {
  const bool is_plain = attribute.kind == AttributeKind::scalar || attribute.kind == AttributeKind::category;
  const bool is_color = attribute.kind == AttributeKind::color && first_name == "red";
  const bool is_real = attribute.type == ScalarType::float32 || attribute.type == ScalarType::float64;
  const bool stays = is_real || is_color || (is_plain && !attribute.is_normalized);
  return stays ? attribute.type : ScalarType::float32;
}

void add_attributes(const std::vector<Attribute>& attributes, std::vector<PlyColumn>& columns) {
  std::size_t n_texcoords = 0;
  for (const Attribute& attribute : attributes) {
    const std::vector<std::string> names = property_names(attribute, n_texcoords);
    n_texcoords += attribute.kind == AttributeKind::texcoord;
    const ScalarType type = type_in_ply(attribute, names.front());
    for (std::size_t i = 0; i < attribute.n_components; ++i) {
      columns.push_back({.name = free_name(names[i], columns),
                         .type = type,
                         .doubles = attribute.values.data() + i,
                         .stride = attribute.n_components,
                         .is_normalized = attribute.is_normalized});
    }
  }
}

}  // namespace

std::string_view ply_name_of(ScalarType type) {
  constexpr std::string_view names[] = {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
  return names[static_cast<std::size_t>(type)];
}

double to_integer(double value, ScalarType type, bool is_normalized) {
  const auto [least, most] = range(type);
  const double stored = is_normalized ? value * most : value;
  if (!(stored > least)) return std::isnan(stored) ? 0 : least;
  return std::round(std::min(stored, most));
}

std::vector<PlyColumn> vertex_columns(const IndexedMesh& mesh, const WriteOptions& options) {
  std::vector<PlyColumn> columns;
  constexpr const char* axes[] = {"x", "y", "z"};
  const ScalarType position_type = fit_float32(mesh.positions) ? ScalarType::float32 : ScalarType::float64;
  for (std::size_t i = 0; i < 3; ++i) {
    columns.push_back(
        {.name = axes[i], .type = position_type, .doubles = mesh.positions.data()->data() + i, .stride = 3});
  }
  for (std::size_t i = 0; i < 3 && !mesh.normals.empty(); ++i) {
    columns.push_back({.name = std::string("n") + axes[i], .floats = mesh.normals.data()->data() + i, .stride = 3});
  }
  constexpr const char* channels[] = {"red", "green", "blue", "alpha"};
  for (std::size_t i = 0; i < n_color_components(mesh, options.notes); ++i) {
    columns.push_back({.name = channels[i],
                       .type = color_type(options),
                       .floats = mesh.colors.data()->data() + i,
                       .stride = 4,
                       .is_normalized = true});
  }
  add_attributes(mesh.attributes, columns);
  const std::vector<std::string>& order = options.notes.vertex_properties;
  std::stable_sort(columns.begin(), columns.end(), [&](const PlyColumn& a, const PlyColumn& b) {
    return std::find(order.begin(), order.end(), a.name) < std::find(order.begin(), order.end(), b.name);
  });
  return columns;
}

std::vector<PlyColumn> columns_of(const std::vector<Attribute>& attributes) {
  std::vector<PlyColumn> columns;
  add_attributes(attributes, columns);
  return columns;
}

std::vector<PlyColumn> runs_of(const std::vector<PlyColumn>& columns) {
  std::vector<PlyColumn> runs;
  for (const PlyColumn& column : columns) {
    if (!runs.empty()) {
      PlyColumn& run = runs.back();
      const bool is_next = run.floats != nullptr ? column.floats == run.floats + run.n_components
                                                 : column.doubles == run.doubles + run.n_components;
      if (is_next && column.type == run.type && column.stride == run.stride &&
          column.is_normalized == run.is_normalized && run.n_components < run.stride) {
        ++run.n_components;
        continue;
      }
    }
    runs.push_back(column);
  }
  return runs;
}

}  // namespace whittle::io
