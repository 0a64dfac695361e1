#include "whittle/polish/polish.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "fuzz/check/decimation.hh"
#include "fuzz/check/promise.hh"
#include "fuzz/decode/decimate_bytes.hh"
#include "fuzz/decode/mesh_bytes.hh"
#include "fuzz/targets.hh"
#include "oracle/crossing.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/radius_ratio.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/metrics/topology.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

/// What `polish` is given.
struct PolishCase {
  IndexedMesh original;
  std::vector<Index> vertex_map;
  IndexedMesh mesh;
  PolishOptions options;
  std::optional<unsigned> n_calls_left;  ///< the progress callback ends the run after so many calls
};

/// The original decimated, and where its features went.
void decimate_into(PolishCase& c, ByteSource& source) {
  DecimateOptions options;
  options.threads = 1;
  options.cost = source.one_in(2) ? Cost::memoryless : Cost::quadric;
  if (source.one_in(2)) options.max_normal_flip_deg = 180;
  if (source.one_in(4)) options.quadric.placement = Placement::endpoint;
  if (source.one_in(3)) options.feature_angle_deg = source.real(10, 170);
  Decimation d = decimate(c.original, DecimateTarget::faces(source.below(60)), options);
  c.options.features = d.feature_edges;
  c.options.feature_angle_deg = options.feature_angle_deg;
  c.mesh = std::move(d.mesh);
  c.vertex_map = std::move(d.vertex_map);
}

/// Any other mesh, and any map.
void decode_into(PolishCase& c, ByteSource& source) {
  c.mesh = decode_mesh(source);
  make_finite(c.mesh);
  const auto n = static_cast<unsigned>(std::min<std::size_t>(c.mesh.positions.size(), 255));
  for (std::size_t v = 0; v < c.original.positions.size(); ++v) {
    const Index to = source.below(n + 1);
    c.vertex_map.push_back(to == n ? invalid_index : to);
  }
  if (source.one_in(3)) c.options.feature_angle_deg = option_value(source, 10, 170);
  for (int i = source.below(4); i > 0; --i) c.options.features.push_back({source.below(24), source.below(24)});
}

PolishCase decode_polish_case(ByteSource& source) {
  PolishCase c;
  PolishOptions& options = c.options;
  options.threads = 1;
  options.passes = source.below(4);
  options.flips = source.one_in(2);
  options.fit_borders = !source.one_in(4);
  options.recompute_normals = !source.one_in(4);
  if (source.one_in(5)) options.min_radius_ratio = option_value(source, 0, 1);
  if (source.one_in(12)) c.n_calls_left = source.below(12);
  const bool is_decimated = !source.one_in(4);
  c.original = decode_mesh(source);
  make_finite(c.original);
  is_decimated ? decimate_into(c, source) : decode_into(c, source);
  for (Vec3& p : c.mesh.positions) {
    if (source.one_in(5)) p += Vec3{source.real(-0.2, 0.2), source.real(-0.2, 0.2), source.real(-0.2, 0.2)};
  }
  if (source.one_in(5)) {
    for (std::size_t v = 0; v < c.mesh.positions.size(); ++v) options.locked.push_back(source.one_in(3));
  }
  for (int i = source.below(4); i > 0; --i) options.original_features.push_back({source.below(24), source.below(24)});
  return c;
}

bool are_in_range(const std::vector<VertexPair>& edges, std::size_t n_vertices) {
  return std::all_of(edges.begin(), edges.end(),
                     [n_vertices](const VertexPair& e) { return std::max(e.a, e.b) < n_vertices; });
}

bool is_valid(const PolishCase& c) {
  const PolishOptions& options = c.options;
  const double angle = options.feature_angle_deg.value_or(90);
  const double ratio = options.min_radius_ratio.value_or(0);
  return angle > 0 && angle < 180 && ratio >= 0 && ratio <= 1 &&
         are_in_range(options.features, c.mesh.positions.size()) &&
         are_in_range(options.original_features, c.original.positions.size());
}

std::string described(const PolishCase& c) {
  std::ostringstream text;
  const PolishOptions& o = c.options;
  text << "passes " << o.passes << " flips " << o.flips << " fit_borders " << o.fit_borders << " feature_angle_deg "
       << o.feature_angle_deg.value_or(180) << " min_radius_ratio " << o.min_radius_ratio.value_or(0) << "\nlocked";
  for (std::size_t v = 0; v < o.locked.size(); ++v) {
    if (o.locked[v] != 0) text << ' ' << v;
  }
  text << "\nfeatures";
  for (const auto& [a, b] : o.features) text << ' ' << a << '-' << b;
  text << "\noriginal features";
  for (const auto& [a, b] : o.original_features) text << ' ' << a << '-' << b;
  text << "\nvertex map";
  for (const Index v : c.vertex_map) text << ' ' << static_cast<int>(v);
  return text.str() + "\noriginal " + text_of(c.original) + "mesh " + text_of(c.mesh);
}

struct Polished {
  IndexedMesh mesh;
  PolishResult result;
};

Polished run(const PolishCase& c) {
  Polished polished{c.mesh, {}};
  PolishOptions options = c.options;
  unsigned n_calls = 0;
  if (c.n_calls_left) options.progress = [&](const TaskProgress&) { return n_calls++ < *c.n_calls_left; };
  polished.result = polish(c.original, c.vertex_map, polished.mesh, options);
  return polished;
}

/// In the frame of the mesh before, so that no product over- or underflows.
double ratio_of(const IndexedMesh& mesh, const Frame& frame, const Triangle& f) {
  const auto at = [&](std::size_t i) { return frame.to_frame(mesh.positions[f[i]]); };
  return radius_ratio(at(0), at(1), at(2));
}

void check_result(const PolishCase& c, const Polished& after) {
  const PolishResult& result = after.result;
  require(result.n_passes <= c.options.passes, "there are no more passes than asked for");
  require(std::isfinite(result.rms_before) && std::isfinite(result.rms_after), "distances are numbers");
  require(result.rms_before >= 0 && result.rms_after >= 0, "distances are not negative");
  require(!result.cancelled || c.n_calls_left, "only the callback cancels");
  std::uint64_t n_moved = 0;
  for (std::size_t v = 0; v < c.mesh.positions.size(); ++v) {
    require(after.mesh.positions[v].allFinite(), "positions are finite");
    n_moved += after.mesh.positions[v] != c.mesh.positions[v];
  }
  require(n_moved <= result.n_moved, "vertices moved are counted");
  if (result.n_passes > 0) return;
  require(n_moved == 0 && result.n_moved == 0 && after.mesh.faces == c.mesh.faces, "no pass, no change");
  require(result.rms_before == result.rms_after || result.cancelled, "no pass, no change");
}

void check_faces(const PolishCase& c, const Polished& after) {
  require(after.mesh.faces.size() == c.mesh.faces.size(), "faces keep their numbers");
  if (!c.options.flips) {
    require(after.mesh.faces == c.mesh.faces, "without flips faces stay");
    return;
  }
  const metrics::Topology before = metrics::topology(c.mesh);
  const metrics::Topology now = metrics::topology(after.mesh);
  require(now.euler == before.euler && now.components == before.components, "flips keep the topology");
  require(now.boundary_edges == before.boundary_edges && now.boundary_loops == before.boundary_loops,
          "flips keep borders");
  require(now.nonmanifold_edges == before.nonmanifold_edges && now.nonmanifold_vertices == before.nonmanifold_vertices,
          "flips make nothing non-manifold");
  require(now.misoriented_edges == before.misoriented_edges, "flips keep the orientation");
  require(now.collapsed_faces == before.collapsed_faces, "flips make no face with two equal corners");
}

void check_fixed(const PolishCase& c, const Polished& after) {
  for (std::size_t v = 0; v < c.options.locked.size(); ++v) {
    require(c.options.locked[v] == 0 || after.mesh.positions[v] == c.mesh.positions[v], "locked vertices stay");
  }
  std::vector<VertexPair> sides;
  for (const Triangle& f : c.mesh.faces) {
    if (!has_three_corners(f)) continue;
    for (std::size_t i = 0; i < 3; ++i)
      sides.push_back({std::min(f[i], f[(i + 1) % 3]), std::max(f[i], f[(i + 1) % 3])});
  }
  std::sort(sides.begin(), sides.end());
  for (const auto& [a, b] : sides) {
    const auto n = std::count(sides.begin(), sides.end(), VertexPair{a, b});
    if (n == 2 || (n == 1 && c.options.fit_borders)) continue;
    for (const Index v : {a, b}) {
      require(after.mesh.positions[v] == c.mesh.positions[v],
              n == 1 ? "border vertices stay if told so" : "vertices that are not manifold stay");
    }
  }
}

void check_thin(const PolishCase& c, const Polished& after) {
  const Frame frame = Frame::of_points(c.mesh.positions);
  const double limit = std::max(0.001, c.options.min_radius_ratio.value_or(0));
  double least_before = 1;
  for (const Triangle& f : c.mesh.faces) least_before = std::min(least_before, ratio_of(c.mesh, frame, f));
  for (std::size_t f = 0; f < c.mesh.faces.size(); ++f) {
    const double before = c.options.flips ? least_before : ratio_of(c.mesh, frame, c.mesh.faces[f]);
    require(ratio_of(after.mesh, frame, after.mesh.faces[f]) >= std::min(limit, before) - 1e-9,
            "no face becomes thinner than allowed");
  }
}

/// The angle between the normals of two faces at a regular edge, for each such edge, degrees. None at a face without
/// area.
std::vector<std::pair<VertexPair, double>> angles_of(const IndexedMesh& mesh, const Frame& frame) {
  struct Side {
    VertexPair edge;
    bool is_turned;
    std::size_t face;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!has_three_corners(mesh.faces[f])) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = mesh.faces[f][i];
      const Index b = mesh.faces[f][(i + 1) % 3];
      sides.push_back({{std::min(a, b), std::max(a, b)}, a > b, f});
    }
  }
  std::sort(sides.begin(), sides.end());
  const auto normal = [&](std::size_t f) -> Vec3 {
    const auto [a, b, d] = mesh.faces[f];
    const Vec3 p = frame.to_frame(mesh.positions[a]);
    return (frame.to_frame(mesh.positions[b]) - p).cross(frame.to_frame(mesh.positions[d]) - p);
  };
  std::vector<std::pair<VertexPair, double>> angles;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].edge == sides[begin].edge) ++end;
    if (end - begin != 2 || sides[begin].is_turned == sides[begin + 1].is_turned) continue;
    const std::size_t f = sides[begin].face;
    const std::size_t g = sides[begin + 1].face;
    if (std::min(ratio_of(mesh, frame, mesh.faces[f]), ratio_of(mesh, frame, mesh.faces[g])) < 1e-9) continue;
    const double angle = std::atan2(normal(f).cross(normal(g)).norm(), normal(f).dot(normal(g)));
    angles.emplace_back(sides[begin].edge, angle * 180 / std::numbers::pi);
  }
  return angles;
}

/// No two faces come to lie more than 142 degrees apart, unless they were. Without flips, which change the edges.
void check_folds(const PolishCase& c, const Polished& after) {
  if (c.options.flips) return;
  const Frame frame = Frame::of_points(c.mesh.positions);
  const auto before = angles_of(c.mesh, frame);
  for (const auto& [edge, angle] : angles_of(after.mesh, frame)) {
    if (angle <= 142.1) continue;
    const auto at = std::lower_bound(before.begin(), before.end(), edge,
                                     [](const auto& entry, const VertexPair& e) { return entry.first < e; });
    if (at == before.end() || at->first != edge) continue;  // a face had no area
    require(angle <= at->second + 1e-3, "no fold is made");
  }
}

/// Whether two faces lie in one plane, as far as rounding lets tell: they may overlap already.
bool are_in_one_plane(const IndexedMesh& mesh, const std::array<Index, 2>& pair) {
  const auto corner = [&](std::size_t face, std::size_t i) { return mesh.positions[mesh.faces[pair[face]][i]]; };
  double size = 0;
  for (std::size_t i = 0; i < 6; ++i) size = std::max(size, (corner(i / 3, i % 3) - corner(0, 0)).norm());
  for (std::size_t face = 0; face < 2; ++face) {
    const Vec3 normal = (corner(face, 1) - corner(face, 0)).cross(corner(face, 2) - corner(face, 0)).normalized();
    double height = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      height = std::max(height, std::abs(normal.dot(corner(1 - face, i) - corner(face, 0))));
    }
    if (height <= 1e-9 * size) return true;
  }
  return false;
}

/// No face newly intersects another. Without flips, which change the faces.
void check_intersections(const PolishCase& c, const Polished& after) {
  if (c.mesh.faces.empty() || after.result.n_passes == 0 || c.options.flips) return;
  auto now = clear_crossings(after.mesh);
  std::erase_if(now, [&](const auto& pair) { return are_in_one_plane(c.mesh, pair); });
  if (now.empty()) return;
  const auto before = metrics::self_intersections(c.mesh, 1);
  require(std::includes(before.begin(), before.end(), now.begin(), now.end()), "no intersection is made");
}

void check_threads(const PolishCase& c, const Polished& after) {
  if (c.n_calls_left) return;
  PolishCase three = c;
  three.options.threads = 3;
  const Polished other = run(three);
  require(after.mesh.positions == other.mesh.positions && after.mesh.faces == other.mesh.faces &&
              after.result.rms_after == other.result.rms_after,
          "no result depends on the number of threads");
}

void check(const PolishCase& c, std::uint64_t hash) {
  Polished after;
  try {
    after = run(c);
  } catch (const std::invalid_argument&) {
    require(!is_valid(c), "what is documented is taken");
    return;
  }
  require(is_valid(c), "what is not documented is refused");
  check_result(c, after);
  check_faces(c, after);
  check_fixed(c, after);
  if (has_ordinary_sizes(c.original) && has_ordinary_sizes(c.mesh)) {
    check_thin(c, after);
    check_folds(c, after);
    check_intersections(c, after);
  }
  if (hash % 64 == 1) check_threads(c, after);
}

/// `simplify`, which polishes what it decimates.
void check_simplify(ByteSource& source) {
  DecimateCase c = decode_decimate_case(source);
  const auto effort = static_cast<Effort>(source.below(3));
  SimplifyOptions options{.decimate = c.options};
  options.decimate.cost.reset();
  if (source.one_in(3)) options.polish_passes = source.below(3);
  if (source.one_in(3)) options.flips = source.one_in(2);
  c.options = with_effort(effort, options).decimate;
  try {
    Simplification s;
    try {
      s = simplify(c.mesh, c.target, effort, options);
    } catch (const std::invalid_argument&) {
      require(!is_valid(c), "what is documented is taken");
      return;
    }
    require(is_valid(c), "what is not documented is refused");
    check_sound(s.mesh);
    require(s.vertex_map.size() == c.mesh.positions.size(), "the vertex map is total");
    for (std::size_t v = 0; v < c.options.locked.size(); ++v) {
      if (c.options.locked[v] == 0 || s.vertex_map[v] == invalid_index) continue;
      require(s.mesh.positions[s.vertex_map[v]] == c.mesh.positions[v], "locked vertices stay");
    }
  } catch (const std::exception& error) {
    throw BrokenPromise(error.what() + std::string("\neffort ") + std::to_string(static_cast<int>(effort)) + ' ' +
                        text_of(c));
  }
}

}  // namespace

void fuzz_polish(std::string_view bytes) {
  ByteSource source(bytes);
  if (source.one_in(4)) return check_simplify(source);
  const PolishCase c = decode_polish_case(source);
  try {
    check(c, hash_of(bytes));
  } catch (const std::exception& error) {
    throw BrokenPromise(error.what() + std::string("\n") + described(c));
  }
}

}  // namespace whittle::test
