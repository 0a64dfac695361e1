// Checks certificates. docs/dev/certificate.md has the format, and says why a proof that is followed holds.
//
// A test that a comparison with NaN decides must fail. So tests are written as `!(good)` where they refuse.

#include "whittle/verify/verify.hh"

#include <atomic>
#include <bit>
#include <exception>
#include <mutex>
#include <numeric>
#include <thread>
#include <utility>

#include "triangles.hh"

namespace whittle::verify {
namespace {

using Index = std::uint32_t;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr unsigned most_depth = 96;  ///< of halving a triangle

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
    const std::string_view taken = bytes(8);
    std::uint64_t bits = 0;
    for (std::size_t i = 8; i-- > 0;) bits = bits << 8 | static_cast<unsigned char>(taken[i]);
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

Vec position(const Triangles& mesh, std::size_t vertex) {
  const double* p = &mesh.coordinates[3 * vertex];
  return {p[0], p[1], p[2]};
}
Index next_corner(const Triangles& mesh, std::size_t side) { return mesh.corners[side % 3 == 2 ? side - 2 : side + 1]; }

void check(const Triangles& mesh, const std::string& name) {
  const auto is_small = [](double x) { return std::abs(x) <= 3e150; };
  if (mesh.coordinates.size() % 3 != 0 || mesh.corners.size() % 3 != 0 || mesh.corners.size() > none_but_own) {
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
};

/// Triangles in the frame. A view: the arrays must outlive it.
struct Surface {
  Triangles mesh;
  Frame frame;
  std::vector<Index> beyond;     ///< over side i of face f, from corner i to the next: the face at 3f + i, or none
  double limit;                  ///< largest distance of others
  std::vector<double> limits{};  ///< of each face, in place of that; or empty
  std::size_t n_faces() const { return mesh.corners.size() / 3; }
  double limit_of(std::size_t face) const { return limits.empty() ? limit : limits[face]; }
  Corners at(std::size_t face) const {
    const Index* c = &mesh.corners[3 * face];
    const auto in_frame = [&](Index v) { return frame.scale * (position(mesh, v) - frame.middle); };
    return {in_frame(c[0]), in_frame(c[1]), in_frame(c[2])};
  }
};

/// `Surface::beyond`. Sides are gathered by their lower vertex, then sorted by the higher.
std::vector<Index> faces_beyond(const Triangles& mesh) {
  std::vector<Index> end(mesh.coordinates.size() / 3 + 1, 0);
  const auto for_each_side = [&](const auto& use) {  // (lower vertex, higher vertex, side)
    for (std::size_t f = 0; f < mesh.corners.size(); f += 3) {
      const Index* c = &mesh.corners[f];
      if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
      for (std::size_t i = 0; i < 3; ++i) use(std::minmax(c[i], c[(i + 1) % 3]), f + i);
    }
  };
  for_each_side([&](const auto& ends, std::size_t) { ++end[ends.first + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Index> sides(end.back());
  for_each_side([&](const auto& ends, std::size_t side) { sides[end[ends.first]++] = static_cast<Index>(side); });
  const auto higher = [&](Index side) { return std::max(mesh.corners[side], next_corner(mesh, side)); };
  std::vector<Index> beyond(mesh.corners.size(), none);
  auto begin = sides.begin();
  for (const Index n : end) {  // the sides of a vertex end where the next vertex' sides began
    const auto last = sides.begin() + n;
    std::sort(begin, last, [&](Index a, Index b) { return higher(a) < higher(b); });
    for (auto next = begin; begin < last; begin = next) {
      next = std::find_if(begin, last, [&](Index side) { return higher(side) != higher(*begin); });
      if (next - begin <= 2) beyond[*begin] = next - begin == 1 ? none_but_own : next[-1] / 3;
      if (next - begin == 2) beyond[next[-1]] = *begin / 3;
    }
  }
  return beyond;
}

/// \param tolerances of the vertices, or none
std::vector<double> limits_of(const Surface& surface, std::span<const double> tolerances) {
  std::vector<double> limits(tolerances.empty() ? 0 : surface.n_faces(), surface.limit);
  for (std::size_t i = 0; i < 3 * limits.size(); ++i) {
    limits[i / 3] = std::min(limits[i / 3], surface.frame.scale * tolerances[surface.mesh.corners[i]]);
  }
  return limits;
}

/// The corners a, b, b of the edges that occur once; none if nothing is claimed of them.
std::vector<Index> border_of(const Surface& surface, double max_error) {
  std::vector<Index> corners;
  if (!(max_error < infinity)) return corners;
  for (std::size_t side = 0; side < surface.beyond.size(); ++side) {
    if (surface.beyond[side] != none_but_own) continue;
    const Index to = next_corner(surface.mesh, side);
    corners.insert(corners.end(), {surface.mesh.corners[side], to, to});
  }
  return corners;
}

/// Checks whether patches of a surface cover triangles. Keeps its memory from one to the next.
class Patch {
 public:
  explicit Patch(const Surface& surface) : surface_(surface), place_(surface.n_faces()) {}

  /// \param first the face that the patch starts from
  /// \param limit of the triangle; each face has one, too
  /// \throw Refusal if it doesn't
  void check(const Corners& triangle, Index first, double limit) {
    const auto fail = [first](const std::string& why) {
      refuse(why + "; the patch starts from face " + std::to_string(first));
    };
    if (const char* why_not = view_.look_at(triangle)) refuse(why_not);
    faces_.clear();
    over_.clear();
    add(first);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const Index face = faces_[i];
      const auto [a, b, c] = surface_.at(face);
      const std::array<Seen, 3> seen{view_.see(a), view_.see(b), view_.see(c)};
      if ((seen[0].outside & seen[1].outside & seen[2].outside) != 0) continue;
      over_.push_back({seen[0].at, seen[1].at, seen[2].at});
      const double least = std::min(limit, surface_.limit_of(face));
      if (!view_.is_within(over_.back(), least)) fail("a face of its patch is not within the distance");
      for (std::size_t side = 0; side < 3; ++side) {
        if (view_.is_apart(seen[side], seen[(side + 1) % 3])) continue;
        const Index other = surface_.beyond[3 * std::size_t{face} + side];
        if (other >= none_but_own) fail("its patch has an edge over it without just two faces");
        add(other);
      }
    }
    if (!covers_oddly()) fail("its patch does not cover it");
  }

 private:
  void add(Index face) {
    Index& place = place_[face];
    if (place < faces_.size() && faces_[place] == face) return;
    place = static_cast<Index>(faces_.size());
    faces_.push_back(face);
  }

  /// Whether an odd number of faces lies over the first point of the triangle of which that is sure.
  bool covers_oddly() const {
    for (int i = 0; i < 16; ++i) {
      const double to_b = 0.95 * std::fmod(0.353 + 0.754877666 * i, 1);  // spread, and in general position
      const double to_c = 0.95 * std::fmod(0.317 + 0.569840291 * i, 1 - to_b);
      bool is_odd = false;
      bool is_sure = true;
      for (const Corners& face : over_) {
        const std::optional<bool> counts = is_over(face, view_.point(to_b, to_c));
        is_sure &= counts.has_value();
        is_odd ^= counts.value_or(false);
      }
      if (is_sure) return is_odd;
    }
    return false;
  }

  const Surface& surface_;
  View view_;
  std::vector<Index> faces_;   ///< the patch
  std::vector<Index> place_;   ///< of a face in it, if it is there
  std::vector<Corners> over_;  ///< its faces that may be over the triangle, projected
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
        follow_step(steps, chunk.of->at(triangle), 0, chunk.of->limit_of(triangle));
        if (triangle + 1 == chunk.end && !steps.is_at_end()) refuse_bytes("bytes follow its proof");
      } catch (Refusal& refusal) {
        refusal.why = std::string(chunk.name) + " " + std::to_string(triangle) + ": " + refusal.why;
        throw;
      }
    }
  }

 private:
  /// \param piece of the triangle, halved so often
  void follow_step(Reader& steps, const Corners& piece, unsigned depth, double limit) {
    const std::uint64_t step = steps.number();
    const std::uint64_t rest = step / 4;
    if (step % 4 == 0) return check_by_face(piece, named_face(rest), limit);
    if (step % 4 == 1) return patch_->check(piece, named_face(rest), limit);
    if (step % 4 == 2) return halve(steps, piece, rest, depth, limit);
    refuse_bytes("a step is of no known kind");
  }

  void check_by_face(const Corners& piece, Index face, double limit) const {
    const Corners corners = to_->at(face);
    const double most = std::min(limit, to_->limit_of(face)) - slack;
    for (const Vec& corner : piece) {
      if (!is_near(corner, corners, most))
        refuse("a corner is not within the distance of face " + std::to_string(face));
    }
  }

  void halve(Reader& steps, const Corners& piece, std::uint64_t edge, unsigned depth, double limit) {
    if (edge > 2) refuse_bytes("a step halves an edge that is not there");
    if (depth == most_depth) refuse("it is halved too often");
    const Vec& from = piece[edge];
    const Vec& to = piece[(edge + 1) % 3];
    const Vec& opposite = piece[(edge + 2) % 3];
    const Vec middle = 0.5 * (from + to);
    const bool is_segment = to.x == opposite.x && to.y == opposite.y && to.z == opposite.z;
    follow_step(steps, {from, middle, is_segment ? middle : opposite}, depth + 1, limit);
    follow_step(steps, {middle, to, opposite}, depth + 1, limit);
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
};

/// Follows all proofs. \throw Refusal the first one
void follow_all(const std::vector<Chunk>& chunks, std::size_t n_threads) {
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> end{chunks.size()};
  std::exception_ptr thrown;  // by chunk `end`
  std::mutex mutex;           // of both
  const auto work = [&] {
    Follower follower;
    for (std::size_t i = next++; i < end; i = next++) {
      try {
        follower.follow(chunks[i]);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (i < end) thrown = std::current_exception();
        end = std::min(i, end.load());
      }
    }
  };
  std::vector<std::thread> others;
  try {
    while (others.size() + 1 < std::min(n_threads, chunks.size())) others.emplace_back(work);
  } catch (const std::exception&) {  // thread creation failed; continue with the threads we have
  }
  work();
  for (std::thread& other : others) other.join();
  if (thrown) std::rethrow_exception(thrown);
}

/// Reads the certificate's claim.
Verification read_head(Reader& file, const Triangles& in, const Triangles& out) {
  constexpr std::string_view first_line = "whittle certificate 1\n";
  if (file.bytes(first_line.size()) != first_line) refuse_bytes("its first line is not 'whittle certificate 1'");
  Verification claim;
  claim.max_error = file.positive();
  claim.max_error_borders = file.positive();
  for (const auto& [mesh, name] : {std::pair(&in, "IN"), std::pair(&out, "OUT")}) {
    const std::uint64_t n_vertices = file.number();
    const std::uint64_t n_faces = file.number();
    if (n_vertices == mesh->coordinates.size() / 3 && n_faces == mesh->corners.size() / 3) continue;
    refuse("it is about other meshes: " + std::string(name) + " is to have " + std::to_string(n_vertices) +
           " vertices and " + std::to_string(n_faces) + " faces");
  }
  const std::uint64_t n_tolerances = file.number();
  if (n_tolerances != 0 && n_tolerances != in.coordinates.size() / 3) {
    refuse_bytes("it has tolerances of some vertices alone");
  }
  for (std::uint64_t i = 0; i < n_tolerances; ++i) claim.tolerances.push_back(file.positive());
  return claim;
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
  Verification claim = read_head(file, in, out);
  const Frame frame(in, out);
  const auto surface = [&](const Triangles& mesh) {
    return Surface{mesh, frame, faces_beyond(mesh), frame.scale * claim.max_error};
  };
  Surface first = surface(in);
  const Surface second = surface(out);
  first.limits = limits_of(first, claim.tolerances);
  const auto border = [&](const Triangles& mesh, const std::vector<Index>& corners) {
    return Surface{
        {mesh.coordinates, corners}, frame, std::vector(corners.size(), none), frame.scale * claim.max_error_borders};
  };
  const std::vector<Index> first_edges = border_of(first, claim.max_error_borders);
  const std::vector<Index> second_edges = border_of(second, claim.max_error_borders);
  const Surface first_border = border(in, first_edges);
  const Surface second_border = border(out, second_edges);
  std::vector<Chunk> chunks;
  add_chunks(file, first, second, "IN, face", chunks);
  add_chunks(file, second, first, "OUT, face", chunks);
  add_chunks(file, first_border, second_border, "IN, border edge", chunks);
  add_chunks(file, second_border, first_border, "OUT, border edge", chunks);
  if (!file.is_at_end()) refuse_bytes("bytes follow the last proof");
  follow_all(chunks, n_threads);
  claim.holds = true;
  return claim;
}

}  // namespace

Verification verify(const Triangles& in, const Triangles& out, std::string_view certificate, unsigned threads) {
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  try {
    return check_all(in, out, certificate, threads);
  } catch (const Refusal& refusal) {
    return {.why_not = refusal.why, .is_malformed = refusal.is_malformed};
  }
}

}  // namespace whittle::verify
