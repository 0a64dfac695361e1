// Checks certificates. docs/dev/certificate.md has the format, and says why a proof that is followed holds.
//
// A test that a comparison with NaN decides must fail. So tests are written as `!(good)` where they refuse.

#include "whittle/verify/verify.hh"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace whittle::verify {
namespace {

using Index = std::uint32_t;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What each test has to spare. Lengths are about 1, so a computed one is wrong by 1e-15. The corner of a piece is
/// wrong by up to 3.1e-15: halving adds 5e-17, two thirds of which add up from one depth to the next.
constexpr double slack = 0.5e-14;
constexpr std::size_t most_depth = 96;

struct Vec {
  double x, y, z;
};

Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(double s, const Vec& a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double norm_sq(const Vec& a) { return dot(a, a); }
double norm(const Vec& a) { return std::sqrt(dot(a, a)); }
Vec cross(const Vec& a, const Vec& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
/// Of x and y alone: positive if b is to the left of a.
double cross_xy(const Vec& a, const Vec& b) { return a.x * b.y - a.y * b.x; }

using Corners = std::array<Vec, 3>;

/// Why the certificate doesn't hold.
struct Refusal {
  std::string why;
  bool is_malformed;
};

[[noreturn]] void refuse(std::string why) { throw Refusal{std::move(why), false}; }
[[noreturn]] void refuse_bytes(std::string why) { throw Refusal{std::move(why), true}; }

class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  bool is_at_end() const { return left_.empty(); }
  std::string_view bytes(std::uint64_t n) {
    if (n > left_.size()) refuse_bytes("it ends too early");
    const std::string_view taken = left_.substr(0, static_cast<std::size_t>(n));
    left_.remove_prefix(taken.size());
    return taken;
  }
  std::uint64_t number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      const std::uint64_t byte = static_cast<unsigned char>(bytes(1)[0]);
      if ((shift == 63 && byte > 1) || (shift > 0 && byte == 0)) break;
      value |= (byte & 127) << shift;
      if (byte < 128) return value;
    }
    refuse_bytes("a number is too long");
  }
  /// A length.
  double positive() {
    std::uint64_t bits = 0;
    unsigned shift = 0;
    for (const char byte : bytes(8))
      bits |= std::uint64_t{static_cast<unsigned char>(byte)} << std::exchange(shift, shift + 8);
    const auto value = std::bit_cast<double>(bits);
    if (!(value > 0)) refuse_bytes("a length is not positive");
    return value;
  }

 private:
  std::string_view left_;
};

/// In place of a face beyond an edge.
constexpr Index none = 0xffffffff;        ///< the edge occurs three times or more, or its face has two corners in one
constexpr Index none_but_own = none - 1;  ///< the edge occurs once

/// Triangles in the frame.
struct Surface {
  std::vector<Vec> positions;
  std::vector<Index> corners;  ///< three of each face
  std::vector<Index> beyond;   ///< over side i of face f, from corner i to the next: the face at 3f + i, or none
  std::vector<double> limits;  ///< of each face: how far others may be

  std::size_t n_faces() const { return limits.size(); }
  Corners at(std::size_t face) const {
    const Index* c = &corners[3 * face];
    return {positions[c[0]], positions[c[1]], positions[c[2]]};
  }
};

Vec position(const Triangles& mesh, std::size_t vertex) {
  const double* p = &mesh.coordinates[3 * vertex];
  return {p[0], p[1], p[2]};
}

void check(const Triangles& mesh, const std::string& name) {
  constexpr std::size_t most_corners = none_but_own;
  const auto is_small = [](double x) { return std::abs(x) <= 3e150; };
  if (mesh.coordinates.size() % 3 != 0 || mesh.corners.size() % 3 != 0 || mesh.corners.size() > most_corners) {
    refuse(name + " has a number of coordinates or corners that is not divisible by 3, or too many faces");
  }
  for (const Index v : mesh.corners) {
    if (v >= mesh.coordinates.size() / 3) refuse(name + " has a face with a corner that is not there");
    const Vec p = position(mesh, v);
    if (is_small(p.x) && is_small(p.y) && is_small(p.z)) continue;
    refuse(name + ": the position of vertex " + std::to_string(v) + " is not finite, or above 3e150");
  }
}

/// Makes both meshes about as large as 1, with the middle of their box at the origin.
struct Frame {
  Vec middle{0, 0, 0};
  double scale = 1;  ///< a power of two

  Frame(const Triangles& a, const Triangles& b) {
    Vec low{infinity, infinity, infinity};
    Vec high{-infinity, -infinity, -infinity};
    for (const Triangles* mesh : {&a, &b}) {
      for (const Index v : mesh->corners) {
        const Vec p = position(*mesh, v);
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    }
    const Vec extent = high - low;
    const double most = std::max({extent.x, extent.y, extent.z});
    if (most >= 0) middle = 0.5 * (low + high);
    if (most > 0) scale = std::ldexp(1.0, std::min(-1 - std::ilogb(most), 1000));
  }

  std::vector<Vec> positions(const Triangles& mesh) const {
    std::vector<Vec> result(mesh.coordinates.size() / 3);
    for (std::size_t v = 0; v < result.size(); ++v) result[v] = scale * (position(mesh, v) - middle);
    return result;
  }
};

/// Calls `use(lower vertex, higher vertex, side)` for each side of a face with three different corners.
template <class Use>
void for_each_side(std::span<const Index> corners, const Use& use) {
  for (std::size_t f = 0; f < corners.size(); f += 3) {
    const Index* c = &corners[f];
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index to = c[(i + 1) % 3];
      use(std::min(c[i], to), std::max(c[i], to), static_cast<Index>(f + i));
    }
  }
}

/// The face over each side, as `Surface::beyond`. Sides are gathered by their lower vertex, then sorted by the higher.
std::vector<Index> faces_beyond(std::span<const Index> corners, std::size_t n_vertices) {
  std::vector<Index> end(n_vertices + 1, 0);
  for_each_side(corners, [&](Index low, Index, Index) { ++end[low + 1]; });
  for (std::size_t v = 0; v < n_vertices; ++v) end[v + 1] += end[v];
  std::vector<std::uint64_t> sides(end[n_vertices]);  // the higher vertex, then the side
  for_each_side(corners,
                [&](Index low, Index high, Index side) { sides[end[low]++] = std::uint64_t{high} << 32 | side; });
  std::vector<Index> beyond(corners.size(), none);
  std::uint64_t* begin = sides.data();
  for (std::size_t v = 0; v < n_vertices; ++v) {  // its sides end where those of the next vertex began
    std::uint64_t* const last = sides.data() + end[v];
    std::sort(begin, last);
    while (begin < last) {
      std::uint64_t* const next =
          std::find_if(begin, last, [begin](std::uint64_t s) { return s >> 32 != *begin >> 32; });
      const auto side = static_cast<Index>(begin[0]);
      if (next - begin == 1) beyond[side] = none_but_own;
      if (next - begin == 2) {
        const auto other = static_cast<Index>(begin[1]);
        beyond[side] = other / 3;
        beyond[other] = side / 3;
      }
      begin = next;
    }
  }
  return beyond;
}

/// Triangles a, b, b of the edges that occur once.
Surface border_of(const Surface& surface, double limit) {
  Surface border;
  for (std::size_t side = 0; side < surface.corners.size(); ++side) {
    if (surface.beyond[side] != none_but_own) continue;
    const Index to = surface.corners[side % 3 == 2 ? side - 2 : side + 1];
    border.corners.insert(border.corners.end(), {surface.corners[side], to, to});
  }
  if (!border.corners.empty()) border.positions = surface.positions;
  border.beyond.assign(border.corners.size(), none);
  border.limits.assign(border.corners.size() / 3, limit);
  return border;
}

double distance_sq_to_segment(const Vec& p, const Vec& a, const Vec& b) {
  const Vec ab = b - a;
  const double length_sq = norm_sq(ab);
  const double t = length_sq > 0 ? std::clamp(dot(p - a, ab) / length_sq, 0.0, 1.0) : 0;
  return norm_sq(p - a - t * ab);
}

/// Whether some point of the face is that near. It looks at the point below p if that is inside, and at the sides.
bool is_near(const Vec& p, const Corners& face, double distance) {
  if (!(distance > 0)) return false;
  const double most = distance * distance;
  const auto& [a, b, c] = face;
  const Vec ab = b - a;
  const Vec ac = c - a;
  const Vec ap = p - a;
  // ac and p in the direction of ab, and what is perpendicular to it: exact for thin faces, too.
  const double length_sq = norm_sq(ab);
  const double ac_along = dot(ac, ab) / length_sq;
  const double ap_along = dot(ap, ab) / length_sq;
  const Vec height = ac - ac_along * ab;
  const double to_c = dot(ap - ap_along * ab, height) / norm_sq(height);
  const double to_b = ap_along - to_c * ac_along;
  if (to_b >= 0 && to_c >= 0 && to_b + to_c <= 1 && norm_sq(ap - to_b * ab - to_c * ac) <= most) return true;
  return distance_sq_to_segment(p, a, b) <= most || distance_sq_to_segment(p, b, c) <= most ||
         distance_sq_to_segment(p, c, a) <= most;
}

/// A vertex as it is seen along a triangle's normal: z is the height over its plane.
struct Seen {
  Index vertex;
  unsigned outside;  ///< a bit for each side of the triangle: surely outside of that
  Vec at;
};

/// A triangle as it is seen along its normal, made a little smaller.
class View {
 public:
  /// \return why not, or nothing
  const char* look_at(const Corners& triangle) {
    origin_ = triangle[0];
    const Vec ab = triangle[1] - triangle[0];
    const Vec ac = triangle[2] - triangle[0];
    const double base = norm(ab);
    axes_[0] = (1 / base) * ab;
    Vec height = ac - dot(axes_[0], ac) * axes_[0];
    height = height - dot(axes_[0], height) * axes_[0];  // again: of thin triangles rounding left some
    const double area = base * norm(height);
    const double longest = std::sqrt(std::max({base * base, norm_sq(ac), norm_sq(ac - ab)}));
    if (!(area > least_height * longest)) return "it is too thin for a patch";
    axes_[1] = (1 / norm(height)) * height;
    axes_[2] = cross(axes_[0], axes_[1]);
    for (std::size_t i = 0; i < 3; ++i) corners_[i] = project(triangle[i]);
    const bool is_flat = std::abs(corners_[1].z) <= 2e-15 && std::abs(corners_[2].z) <= 2e-15;
    shrink();
    const bool is_left = cross_xy(corners_[1] - corners_[0], corners_[2] - corners_[0]) > 0.5 * area;
    return is_flat && is_left && margin_ < infinity ? nullptr : "its normal is too inexact for a patch";
  }

  /// Each point of the triangle is within this distance of the smaller one.
  double margin() const { return margin_; }
  /// A point of the smaller triangle.
  Vec point(double to_b, double to_c) const {
    return corners_[0] + to_b * (corners_[1] - corners_[0]) + to_c * (corners_[2] - corners_[0]);
  }
  Seen see(Index vertex, const Vec& position) const {
    Seen seen{vertex, 0, project(position)};
    for (unsigned i = 0; i < 3; ++i) seen.outside |= unsigned{beyond_side(i, seen.at) > slack} << i;
    return seen;
  }

  /// Whether a line surely parts the segment from the triangle: one along a side of the triangle, or along the segment.
  bool is_apart(const Seen& a, const Seen& b) const {
    if ((a.outside & b.outside) != 0) return true;
    if (a.outside == 0 || b.outside == 0) return false;
    const Vec way{b.at.x - a.at.x, b.at.y - a.at.y, 0};
    const double least = slack * norm(way);
    const auto left = [&](const Vec& corner) { return cross_xy(way, corner - a.at); };
    return std::all_of(corners_.begin(), corners_.end(), [&](const Vec& corner) { return left(corner) > least; }) ||
           std::all_of(corners_.begin(), corners_.end(), [&](const Vec& corner) { return left(corner) < -least; });
  }

  /// Whether the part of a face over the triangle is nowhere farther above its plane, or below, than `most`.
  bool is_within(const Corners& face, double most) const {
    const auto is_low = [most](const Vec& p) { return std::abs(p.z) <= most; };
    if (is_low(face[0]) && is_low(face[1]) && is_low(face[2])) return true;
    Polygon part{{face[0], face[1], face[2]}, 3};
    for (std::size_t side = 0; side < 3; ++side) part = clipped(part, side);
    return std::all_of(part.corners.data(), part.corners.data() + part.size, is_low);
  }

 private:
  static constexpr double least_height = 0.5e-10;
  static constexpr double inset = 4e-14;

  /// A clipped triangle. Each of three clippings turns n corners into 3n / 2 at most.
  struct Polygon {
    std::array<Vec, 12> corners;
    std::size_t size;
  };

  Vec project(const Vec& point) const {
    const Vec offset = point - origin_;
    return {dot(axes_[0], offset), dot(axes_[1], offset), dot(axes_[2], offset)};
  }
  double beyond_side(std::size_t side, const Vec& p) const {
    return outward_[side].x * (p.x - corners_[side].x) + outward_[side].y * (p.y - corners_[side].y);
  }
  /// Sets `outward_`: perpendicular to each side, of unit length.
  void find_outward() {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec way = corners_[(i + 1) % 3] - corners_[i];
      const Vec right{way.y, -way.x, 0};
      outward_[i] = (1 / norm(right)) * right;
    }
  }
  /// Moves the sides inward.
  void shrink() {
    find_outward();
    margin_ = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec sum = outward_[i] + outward_[(i + 2) % 3];
      const Vec move = 2 * inset / norm_sq(sum) * sum;
      corners_[i] = corners_[i] - move;
      margin_ = std::max(norm(move), margin_);
    }
    find_outward();
  }
  /// The part inside of a side, or a little outside.
  Polygon clipped(const Polygon& whole, std::size_t side) const {
    Polygon part{{}, 0};
    for (std::size_t i = 0; i < whole.size; ++i) {
      const Vec& from = whole.corners[i];
      const Vec& to = whole.corners[i + 1 < whole.size ? i + 1 : 0];
      const double beyond_from = beyond_side(side, from) - 2 * slack;
      const double beyond_to = beyond_side(side, to) - 2 * slack;
      if (beyond_from <= 0) part.corners[part.size++] = from;
      if ((beyond_from <= 0) == (beyond_to <= 0)) continue;
      part.corners[part.size++] = from + beyond_from / (beyond_from - beyond_to) * (to - from);
    }
    return part;
  }

  Vec origin_{};
  Corners axes_{};
  Corners corners_{};  ///< of the smaller triangle
  Corners outward_{};
  double margin_ = 0;
};

/// Whether a point is seen inside of a face; nothing if it is too near to a side to tell.
std::optional<bool> is_over(const Corners& face, const Vec& point) {
  bool has_left = false;
  bool has_right = false;
  bool is_sure = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec way = face[(i + 1) % 3] - face[i];
    const Vec offset = point - face[i];
    const double left = cross_xy(way, offset);
    const double unsure = 1e-15 * (std::abs(way.x * offset.y) + std::abs(way.y * offset.x));
    has_left |= left > unsure;
    has_right |= left < -unsure;
    is_sure &= std::abs(left) > unsure;
  }
  if (has_left && has_right) return false;
  return is_sure ? std::optional(true) : std::nullopt;
}

/// Checks whether patches of a surface cover triangles. Keeps its memory from one to the next.
class Patch {
 public:
  explicit Patch(const Surface& surface)
      : surface_(surface), place_in_seen_(surface.positions.size()), place_in_faces_(surface.n_faces()) {}

  /// \param first the face that the patch starts from
  /// \param limit of the triangle; each face has one, too
  /// \return why not, or nothing
  const char* why_not(const Corners& triangle, Index first, double limit) {
    if (const char* why = view_.look_at(triangle)) return why;
    seen_.clear();
    faces_.clear();
    over_.clear();
    add(first);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const Index face = faces_[i];
      const Index* corners = &surface_.corners[3 * std::size_t{face}];
      const std::array<Seen, 3> seen{see(corners[0]), see(corners[1]), see(corners[2])};
      if ((seen[0].outside & seen[1].outside & seen[2].outside) != 0) continue;
      over_.push_back({seen[0].at, seen[1].at, seen[2].at});
      const double most = std::min(limit, surface_.limits[face]) - view_.margin() - 2 * slack;
      if (!view_.is_within(over_.back(), most)) return "a face of its patch is not within the distance";
      for (std::size_t side = 0; side < 3; ++side) {
        if (view_.is_apart(seen[side], seen[(side + 1) % 3])) continue;
        const Index other = surface_.beyond[3 * std::size_t{face} + side];
        if (other >= none_but_own) return "its patch has an edge over it without just two faces";
        add(other);
      }
    }
    return covers_oddly() ? nullptr : "its patch does not cover it";
  }

 private:
  void add(Index face) {
    Index& place = place_in_faces_[face];
    if (place < faces_.size() && faces_[place] == face) return;
    place = static_cast<Index>(faces_.size());
    faces_.push_back(face);
  }

  Seen see(Index vertex) {
    Index& place = place_in_seen_[vertex];
    if (place >= seen_.size() || seen_[place].vertex != vertex) {
      place = static_cast<Index>(seen_.size());
      seen_.push_back(view_.see(vertex, surface_.positions[vertex]));
    }
    return seen_[place];
  }

  /// Whether an odd number of faces lies over the first point of the triangle of which that is sure.
  bool covers_oddly() const {
    for (int i = 0; i < 16; ++i) {
      const double to_b = 0.95 * std::fmod(0.353 + 0.754877666 * i, 1);  // spread, and in general position
      const double to_c = 0.95 * std::fmod(0.317 + 0.569840291 * i, 1 - to_b);
      const std::optional<bool> is_odd = is_odd_over(view_.point(to_b, to_c));
      if (is_odd) return *is_odd;
    }
    return false;
  }

  std::optional<bool> is_odd_over(const Vec& point) const {
    bool is_odd = false;
    for (const Corners& face : over_) {
      const std::optional<bool> counts = is_over(face, point);
      if (!counts) return std::nullopt;
      is_odd ^= *counts;
    }
    return is_odd;
  }

  const Surface& surface_;
  View view_;
  std::vector<Seen> seen_;             ///< vertices of the patch
  std::vector<Index> faces_;           ///< the patch
  std::vector<Corners> over_;          ///< those of its faces that may be over the triangle, as they are seen
  std::vector<Index> place_in_seen_;   ///< of a vertex, if it is there
  std::vector<Index> place_in_faces_;  ///< of a face, if it is there
};

/// Proofs that triangles of a surface are near to another one.
struct Chunk {
  const Surface* of;
  const Surface* to;
  std::string_view name;   ///< "IN, face"
  std::size_t begin, end;  ///< triangles
  std::string_view steps;
};

/// Follows proofs. Keeps its memory from one to the next.
class Follower {
 public:
  /// \throw Refusal
  void follow(const Chunk& chunk) {
    if (to_ != chunk.to) patch_.emplace(*chunk.to);
    to_ = chunk.to;
    face_ = 0;
    Reader steps(chunk.steps);
    for (std::size_t triangle = chunk.begin; triangle < chunk.end; ++triangle) {
      try {
        follow_triangle(steps, chunk.of->at(triangle), chunk.of->limits[triangle]);
        if (triangle + 1 == chunk.end && !steps.is_at_end()) refuse_bytes("bytes follow its proof");
      } catch (Refusal& refusal) {
        refusal.why = std::string(chunk.name) + " " + std::to_string(triangle) + ": " + refusal.why;
        throw;
      }
    }
  }

 private:
  /// A part of a triangle.
  struct Piece {
    Corners corners;
    std::size_t depth;
  };

  void follow_triangle(Reader& steps, const Corners& triangle, double limit) {
    pieces_.assign(1, {triangle, 0});
    while (!pieces_.empty()) {
      const Piece piece = pieces_.back();
      pieces_.pop_back();
      const std::uint64_t step = steps.number();
      if (step % 4 == 3) refuse_bytes("a step is of no known kind");
      if (step % 4 == 2) {
        halve(piece, step / 4);
      } else {
        check(piece.corners, step % 4 == 1, named_face(step / 4), limit);
      }
    }
  }

  void check(const Corners& piece, bool by_patch, Index face, double limit) {
    if (by_patch) {
      const char* const why_not = patch_->why_not(piece, face, limit);
      if (why_not != nullptr) refuse(why_not + ("; the patch starts from face " + std::to_string(face)));
      return;
    }
    const double most = std::min(limit, to_->limits[face]) - slack;
    const auto is_near_face = [&](const Vec& corner) { return is_near(corner, to_->at(face), most); };
    if (std::all_of(piece.begin(), piece.end(), is_near_face)) return;
    refuse("a corner is not within the distance of face " + std::to_string(face));
  }

  void halve(const Piece& piece, std::uint64_t edge) {
    if (edge > 2) refuse_bytes("a step halves an edge that is not there");
    if (piece.depth == most_depth) refuse("it is halved too often");
    const Vec& from = piece.corners[edge];
    const Vec& to = piece.corners[(edge + 1) % 3];
    const Vec& opposite = piece.corners[(edge + 2) % 3];
    const Vec middle = 0.5 * (from + to);
    pieces_.push_back({{middle, to, opposite}, piece.depth + 1});
    pieces_.push_back({{from, middle, opposite}, piece.depth + 1});
  }

  Index named_face(std::uint64_t rest) {
    const auto half = static_cast<std::int64_t>(rest / 2);
    face_ += rest % 2 == 0 ? half : -half - 1;
    if (face_ < 0 || face_ >= static_cast<std::int64_t>(to_->n_faces())) refuse_bytes("a step names no face");
    return static_cast<Index>(face_);
  }

  const Surface* to_ = nullptr;
  std::optional<Patch> patch_;
  std::int64_t face_ = 0;  ///< named last
  std::vector<Piece> pieces_;
};

/// Follows all proofs. \throw Refusal the first one
void follow_all(const std::vector<Chunk>& chunks, std::size_t n_threads) {
  std::vector<std::exception_ptr> thrown(chunks.size());
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> end{chunks.size()};
  const auto work = [&] {
    Follower follower;
    for (std::size_t i = next++; i < end; i = next++) {
      try {
        follower.follow(chunks[i]);
      } catch (...) {
        thrown[i] = std::current_exception();
        std::size_t before = end;
        while (i < before && !end.compare_exchange_weak(before, i)) {
        }
      }
    }
  };
  const std::size_t n_others = std::max<std::size_t>(1, std::min(n_threads, chunks.size())) - 1;
  std::vector<std::thread> others;
  others.reserve(n_others);
  try {
    while (others.size() < n_others) others.emplace_back(work);
  } catch (const std::system_error&) {  // there are no more threads: those that run do it all
  }
  work();
  for (std::thread& other : others) other.join();
  if (end < chunks.size()) std::rethrow_exception(thrown[end]);
}

/// What a certificate claims.
struct Claim {
  double max_error;
  double max_error_borders;
  std::vector<double> tolerances;  ///< of the vertices of IN, or none
};

void check_size(Reader& file, const Triangles& mesh, const std::string& name) {
  const std::uint64_t n_vertices = file.number();
  const std::uint64_t n_faces = file.number();
  if (n_vertices == mesh.coordinates.size() / 3 && n_faces == mesh.corners.size() / 3) return;
  refuse("it is about other meshes: " + name + " is to have " + std::to_string(n_vertices) + " vertices and " +
         std::to_string(n_faces) + " faces");
}

Claim read_head(Reader& file, const Triangles& in, const Triangles& out) {
  constexpr std::string_view first_line = "whittle certificate 1\n";
  if (file.bytes(first_line.size()) != first_line) refuse_bytes("its first line is not 'whittle certificate 1'");
  Claim claim{file.positive(), file.positive(), {}};
  check_size(file, in, "IN");
  check_size(file, out, "OUT");
  const std::uint64_t n_tolerances = file.number();
  if (n_tolerances != 0 && n_tolerances != in.coordinates.size() / 3) {
    refuse_bytes("it has tolerances of some vertices alone");
  }
  for (std::uint64_t i = 0; i < n_tolerances; ++i) claim.tolerances.push_back(file.positive());
  return claim;
}

/// The limit of each face, in the frame.
std::vector<double> limits_of(const Claim& claim, std::span<const Index> corners, double scale) {
  std::vector<double> limits(corners.size() / 3, scale * claim.max_error);
  if (claim.tolerances.empty()) return limits;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    limits[i / 3] = std::min(limits[i / 3], scale * claim.tolerances[corners[i]]);
  }
  return limits;
}

void add_chunks(Reader& file, const Surface& of, const Surface& to, std::string_view name, std::vector<Chunk>& chunks) {
  constexpr std::size_t chunk_length = 1024;
  for (std::size_t begin = 0; begin < of.n_faces(); begin += chunk_length) {
    const std::size_t end = std::min(begin + chunk_length, of.n_faces());
    chunks.push_back({&of, &to, name, begin, end, file.bytes(file.number())});
  }
}

Verification check_all(const Triangles& in, const Triangles& out, std::string_view certificate, std::size_t n_threads) {
  check(in, "IN");
  check(out, "OUT");
  Reader file(certificate);
  const Claim claim = read_head(file, in, out);
  const Frame frame(in, out);
  const auto surface = [&](const Triangles& mesh, std::vector<double> limits) {
    std::vector<Index> corners(mesh.corners.begin(), mesh.corners.end());
    std::vector<Index> beyond = faces_beyond(corners, mesh.coordinates.size() / 3);
    return Surface{frame.positions(mesh), std::move(corners), std::move(beyond), std::move(limits)};
  };
  const auto border = [&](const Surface& faces) {
    return claim.max_error_borders < infinity ? border_of(faces, frame.scale * claim.max_error_borders) : Surface{};
  };
  const Surface first = surface(in, limits_of(claim, in.corners, frame.scale));
  const Surface second = surface(out, limits_of({claim.max_error, 0, {}}, out.corners, frame.scale));
  const Surface first_border = border(first);
  const Surface second_border = border(second);
  std::vector<Chunk> chunks;
  add_chunks(file, first, second, "IN, face", chunks);
  add_chunks(file, second, first, "OUT, face", chunks);
  add_chunks(file, first_border, second_border, "IN, border edge", chunks);
  add_chunks(file, second_border, first_border, "OUT, border edge", chunks);
  if (!file.is_at_end()) refuse_bytes("bytes follow the last proof");
  follow_all(chunks, n_threads);
  return {true, claim.max_error, claim.max_error_borders, claim.tolerances.size()};
}

}  // namespace

Verification verify(const Triangles& in, const Triangles& out, std::string_view certificate, unsigned threads) {
  Verification result;
  try {
    result =
        check_all(in, out, certificate, threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency()));
  } catch (const Refusal& refusal) {
    result.why_not = refusal.why;
    result.is_malformed = refusal.is_malformed;
  }
  return result;
}

}  // namespace whittle::verify
