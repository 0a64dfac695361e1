#include "ply/ply_fixed_rows.hh"

#include <algorithm>
#include <span>

#include "whittle/core/bytes/little_endian.hh"

namespace whittle::io {

namespace {

/// The numbers of a property in some rows.
struct Column {
  PlyRows rows;
  std::size_t n_rows;
  std::size_t place;  ///< bytes from the beginning of a row
  PlyType type;

  /// Calls `use(row, number)` for each.
  template <class Use>
  void for_each(const Use& use) const {
    with_scalar_type(type, [&]<class Number>(Number) {
      const char* at = rows.first + place;
      for (std::size_t row = 0; row < n_rows; ++row, at += rows.size) use(row, load<Number>(at, rows.order));
    });
  }

  bool are_all(double number) const {
    bool are = true;
    for_each([&](std::size_t, auto of_row) { are &= static_cast<double>(of_row) == number; });
    return are;
  }
};

void read_property(const Column& column, const PlyVertexPlan& plan, PlyRole role, const PlyTarget& target,
                   std::size_t begin, MeshBuilder& builder) {
  if (role <= z) {
    Vec3* const to = builder.positions().data() + begin;
    const auto axis = static_cast<Eigen::Index>(role);
    column.for_each([=](std::size_t i, auto number) { to[i][axis] = static_cast<double>(number); });
  } else if (role <= nz) {
    if (!plan.normals) return;
    auto* const to = builder.normals().data() + begin;
    column.for_each([=](std::size_t i, auto number) { to[i][role - nx] = static_cast<float>(number); });
  } else if (role <= alpha) {
    if (!plan.colors) return;
    Color* const to = builder.colors().data() + begin;
    const double unit = plan.color_units[role - red];
    column.for_each([=](std::size_t i, auto number) {
      to[i][role - red] = static_cast<float>(static_cast<double>(number) / unit);
    });
  } else if (role == tolerance) {
    double* const to = builder.tolerances().data() + begin;
    column.for_each([=](std::size_t i, auto number) { to[i] = static_cast<double>(number); });
  } else if (target.values != nullptr) {
    column.for_each([&](std::size_t i, auto number) { target.set(begin + i, static_cast<double>(number)); });
  }
}

/// The corners of faces at one place in them. \return whether all are vertices
bool read_corners(const Column& column, std::size_t place, std::uint64_t n_vertices, Triangle* faces) {
  bool are_vertices = true;
  column.for_each([&](std::size_t f, auto number) {
    const auto value = static_cast<double>(number);
    const bool is_vertex = value >= 0 && value < static_cast<double>(n_vertices);
    const Index vertex = is_vertex ? static_cast<Index>(value) : 0;
    are_vertices &= is_vertex && static_cast<double>(vertex) == value;
    faces[f][place] = vertex;
  });
  return are_vertices;
}

}  // namespace

std::vector<PlyTarget> targets_of(const PlyAttributes& planned, std::vector<Attribute>& attributes) {
  std::vector<PlyTarget> targets(planned.places.size());
  for (std::size_t p = 0; p < targets.size(); ++p) {
    if (!planned.places[p]) continue;
    Attribute& attribute = attributes[planned.places[p]->attribute];
    targets[p] = {attribute.values.data() + planned.places[p]->component, attribute.n_components,
                  planned.places[p]->unit};
  }
  return targets;
}

bool read_vertex_rows(const PlyRows& rows, const PlyElement& element, const PlyVertexPlan& plan,
                      const std::vector<PlyTarget>& targets, std::size_t begin, std::size_t end, MeshBuilder& builder) {
  std::size_t place = 0;
  for (std::size_t p = 0; p < plan.roles.size(); ++p) {
    const PlyType type = element.properties[p].type;
    read_property({rows.from(begin), end - begin, place, type}, plan, plan.roles[p], targets[p], begin, builder);
    place += size_of(type);
  }
  if (plan.colors && !plan.has[alpha]) {
    for (std::size_t v = begin; v < end; ++v) builder.colors()[v][3] = opaque;
  }
  const auto read = std::span(builder.positions()).subspan(begin, end - begin);
  return std::all_of(read.begin(), read.end(), [](const Vec3& position) { return position.allFinite(); });
}

bool read_triangle_rows(const PlyRows& rows, const PlyElement& element, const PlyFacePlan& plan,
                        const std::vector<PlyTarget>& targets, std::uint64_t n_vertices, std::size_t begin,
                        std::size_t end, PlyTriangles& read) {
  Column column{rows.from(begin), end - begin, 0, PlyType::uint8};
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    const bool are_corners = p == plan.corners;
    const std::size_t length = are_corners ? 3 : p == plan.texcoords ? 6 : 1;
    if (property.count_type) {
      column.type = *property.count_type;
      if (!column.are_all(static_cast<double>(length))) return false;
      column.place += size_of(column.type);
    }
    column.type = property.type;
    for (std::size_t i = 0; i < length; ++i, column.place += size_of(property.type)) {
      if (are_corners) {
        if (!read_corners(column, i, n_vertices, read.faces.data() + begin)) return false;
      } else if (p == plan.texcoords) {
        double* const to = read.texcoords.data() + 6 * begin + i;
        column.for_each([=](std::size_t f, auto number) { to[6 * f] = static_cast<double>(number); });
      } else if (targets[p].values != nullptr) {
        column.for_each([&](std::size_t f, auto number) { targets[p].set(begin + f, static_cast<double>(number)); });
      }
    }
  }
  return true;
}

}  // namespace whittle::io
