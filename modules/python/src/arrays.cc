#include "arrays.hh"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "whittle/core/attribute_kinds.hh"
#include "whittle/core/wedges.hh"

namespace whittle::python {
namespace {

/// Calls `function` with a pointer to the array's numbers.
template <class Function>
void with_numbers(const Array& array, const Function& function) {
  const auto is = [type = array.dtype()]<class T>(const T*) { return type == nb::dtype<T>(); };
  const auto try_type = [&]<class T>(const T* none) {
    if (!is(none)) return false;
    function(static_cast<const T*>(array.data()));
    return true;
  };
  const auto try_types = [&]<class... T>(const T*... none) { return (try_type(none) || ...); };
  const bool is_known = try_types(static_cast<const double*>(nullptr), static_cast<const float*>(nullptr),
                                  static_cast<const std::int8_t*>(nullptr), static_cast<const std::uint8_t*>(nullptr),
                                  static_cast<const std::int16_t*>(nullptr), static_cast<const std::uint16_t*>(nullptr),
                                  static_cast<const std::int32_t*>(nullptr), static_cast<const std::uint32_t*>(nullptr),
                                  static_cast<const std::int64_t*>(nullptr), static_cast<const std::uint64_t*>(nullptr),
                                  static_cast<const bool*>(nullptr));
  if (!is_known) throw std::invalid_argument("an array has neither real numbers nor integers");
}

ScalarType scalar_type(const Array& array) {
  const nb::dlpack::dtype type = array.dtype();
  const auto is = [type]<class T>(T) { return type == nb::dtype<T>(); };
  for (const ScalarType known : {ScalarType::int8, ScalarType::uint8, ScalarType::int16, ScalarType::uint16,
                                 ScalarType::int32, ScalarType::uint32, ScalarType::float32}) {
    if (with_scalar_type(known, is)) return known;
  }
  return ScalarType::float64;  // what holds the others
}

std::size_t n_rows(const Array& array) { return array.ndim() == 0 ? 0 : array.shape(0); }
std::size_t n_columns(const Array& array) { return array.ndim() == 2 ? array.shape(1) : 1; }

std::string shape_text(const Array& array) {
  std::string text;
  for (std::size_t i = 0; i < array.ndim(); ++i) text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  return "(" + text + (array.ndim() == 1 ? ",)" : ")");
}

void check_triples(const Array& array, const char* what, const char* shape) {
  if (array.ndim() == 2 && array.shape(1) == 3) return;
  throw std::invalid_argument(std::string(what) + " has the shape " + shape_text(array) + ", not " + shape);
}

template <class T>
Index checked_index(T number, std::size_t n, std::size_t face) {
  if (number >= 0 && static_cast<std::uint64_t>(number) < n) return static_cast<Index>(number);
  throw std::invalid_argument("faces: face " + std::to_string(face) + " has the vertex " + std::to_string(number) +
                              ", but there are " + std::to_string(n) + " points");
}

std::vector<Vec3> positions(const Array& points) {
  check_triples(points, "points", "(V, 3)");
  std::vector<Vec3> result(n_rows(points));
  with_numbers(points, [&](const auto* numbers) {
    for (std::size_t v = 0; v < result.size(); ++v) {
      for (std::size_t i = 0; i < 3; ++i) {
        result[v][static_cast<Eigen::Index>(i)] = static_cast<double>(numbers[3 * v + i]);
      }
    }
  });
  const auto bad = std::find_if_not(result.begin(), result.end(), [](const Vec3& p) { return p.allFinite(); });
  if (bad == result.end()) return result;
  throw std::invalid_argument("points: a coordinate of point " + std::to_string(bad - result.begin()) +
                              " is not finite");
}

std::vector<Triangle> triangles(const Array& faces, std::size_t n_points) {
  check_triples(faces, "faces", "(F, 3)");
  std::vector<Triangle> result(n_rows(faces));
  with_numbers(faces, [&]<class T>(const T* numbers) {
    if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
      for (std::size_t f = 0; f < result.size(); ++f) {
        for (std::size_t i = 0; i < 3; ++i) result[f][i] = checked_index(numbers[3 * f + i], n_points, f);
      }
    } else {
      throw std::invalid_argument("faces: the numbers are no integers");
    }
  });
  return result;
}

/// A value for each wedge.
std::vector<double> by_wedge(const NamedArray& array, const IndexedMesh& mesh) {
  std::vector<double> values = numbers(array.values);
  if (mesh.wedges.empty() || n_rows(array.values) != mesh.positions.size()) return values;
  const std::size_t n = n_columns(array.values);
  std::vector<double> result;
  result.reserve(3 * mesh.faces.size() * n);
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(v * n);
      result.insert(result.end(), first, first + static_cast<std::ptrdiff_t>(n));
    }
  }
  return result;
}

void require_columns(const NamedArray& array, std::size_t low, std::size_t high) {
  const std::size_t n = n_columns(array.values);
  if (n >= low && n <= high) return;
  throw std::invalid_argument(array.name + " has the shape " + shape_text(array.values) + ", with " +
                              std::to_string(n) + " numbers for each vertex");
}

void add_normals(const NamedArray& array, IndexedMesh& mesh) {
  require_columns(array, 3, 3);
  const std::vector<double> values = by_wedge(array, mesh);
  for (std::size_t i = 0; i < values.size(); i += 3) {
    const Vec3 normal = Vec3(values[i], values[i + 1], values[i + 2]).stableNormalized();
    mesh.normals.push_back(
        {static_cast<float>(normal.x()), static_cast<float>(normal.y()), static_cast<float>(normal.z())});
  }
}

void add_colors(const NamedArray& array, IndexedMesh& mesh) {
  require_columns(array, 3, 4);
  const std::size_t n = n_columns(array.values);
  const std::vector<double> values = by_wedge(array, mesh);
  const double one = scalar_type(array.values) == ScalarType::uint8    ? 255
                     : scalar_type(array.values) == ScalarType::uint16 ? 65535
                                                                       : 1;
  for (std::size_t i = 0; i < values.size(); i += n) {
    Color color{0, 0, 0, 1};
    for (std::size_t k = 0; k < n; ++k) color[k] = static_cast<float>(std::clamp(values[i + k] / one, 0.0, 1.0));
    mesh.colors.push_back(color);
  }
}

}  // namespace

std::vector<double> numbers(const Array& array) {
  std::vector<double> result(array.size());
  with_numbers(array, [&]<class T>(const T* first) {
    std::transform(first, first + result.size(), result.begin(), [](T x) { return static_cast<double>(x); });
  });
  return result;
}

std::vector<Index> indices(const Array& array) {
  std::vector<Index> result(array.size());
  with_numbers(array, [&]<class T>(const T* first) {
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = static_cast<Index>(first[i]);
      if (static_cast<T>(result[i]) != first[i] || first[i] < T{0}) {
        throw std::invalid_argument(std::to_string(first[i]) + " is no number of a group");
      }
    }
  });
  return result;
}

IndexedMesh mesh_of(const Array& points, const Array& faces) {
  IndexedMesh mesh;
  mesh.positions = positions(points);
  mesh.faces = triangles(faces, mesh.positions.size());
  return mesh;
}

void add_attributes(const std::vector<NamedArray>& arrays, IndexedMesh& mesh) {
  const std::size_t n_vertices = mesh.positions.size();
  const std::size_t n_corners = 3 * mesh.faces.size();
  for (const NamedArray& array : arrays) {
    const std::size_t n = n_rows(array.values);
    if (array.values.ndim() > 2 || (n != n_vertices && n != n_corners)) {
      throw std::invalid_argument(array.name + " has the shape " + shape_text(array.values) +
                                  ", neither one value for " + "each of " + std::to_string(n_vertices) +
                                  " points, nor for each of " + std::to_string(n_corners) + " corners of faces");
    }
    if (n == n_vertices || !mesh.wedges.empty()) continue;
    for (Index corner = 0; corner < n_corners; ++corner) mesh.wedges.push_back(corner);
  }
  for (const NamedArray& array : arrays) {
    if (array.kind == "normal") {
      add_normals(array, mesh);
    } else if (array.kind == "color") {
      add_colors(array, mesh);
    } else {
      const ScalarType type = scalar_type(array.values);
      const bool is_texture = array.kind == "texcoord";
      if (is_texture) require_columns(array, 2, 3);
      mesh.attributes.push_back({.name = array.name,
                                 .kind = is_texture ? AttributeKind::texcoord : kind_of_numbers(array.name, type),
                                 .n_components = n_columns(array.values),
                                 .values = by_wedge(array, mesh),
                                 .type = type});
    }
  }
  find_whole_categories(mesh);
}

}  // namespace whittle::python
