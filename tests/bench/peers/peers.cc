#include <functional>
#include <stdexcept>
#include <utility>

#include "bench/peers/peer.hh"

namespace whittle::bench {
namespace {

using Factory = std::function<std::unique_ptr<Peer>()>;

/// CMake defines WHITTLE_BENCH_HAS_….
const std::vector<std::pair<std::string, Factory>>& factories() {
  static const std::vector<std::pair<std::string, Factory>> all = {
      {"whittle", [] { return make_whittle(whittle_kinds[0], 1); }},
      {"whittle-normal", [] { return make_whittle(whittle_kinds[1], 1); }},
      {"whittle-best", [] { return make_whittle(whittle_kinds[2], 1); }},
      {"whittle-quadric", [] { return make_whittle(whittle_kinds[3], 1); }},
#ifdef WHITTLE_BENCH_HAS_MESHOPTIMIZER
      {"meshoptimizer", make_meshoptimizer},
#endif
      {"openmesh", make_openmesh},
      {"pair-decimater", make_pair_decimater},
#ifdef WHITTLE_BENCH_HAS_CGAL
      {"cgal-lindstrom-turk", make_cgal_lindstrom_turk},
      {"cgal-garland-heckbert", make_cgal_garland_heckbert},
#endif
#ifdef WHITTLE_BENCH_HAS_VTK
      {"vtk", make_vtk},
#endif
#ifdef WHITTLE_BENCH_HAS_OPEN3D
      {"open3d", make_open3d},
#endif
  };
  return all;
}

/// Whittle on N threads, for "NAME:N" with one of its names; null for any other name.
std::unique_ptr<Peer> whittle_on_threads(std::string_view name) {
  const std::size_t colon = name.find(':');
  if (colon == name.npos) return nullptr;
  const std::string digits(name.substr(colon + 1));
  const bool is_number = !digits.empty() && digits.size() <= 3 && digits.find_first_not_of("0123456789") == digits.npos;
  const unsigned threads = is_number ? static_cast<unsigned>(std::stoul(digits)) : 0;
  if (threads == 0) return nullptr;
  for (const WhittleKind& kind : whittle_kinds) {
    if (name.substr(0, colon) == kind.name) return make_whittle(kind, threads);
  }
  return nullptr;
}

}  // namespace

std::vector<std::string> peer_names() {
  std::vector<std::string> names;
  for (const auto& [name, factory] : factories()) names.push_back(name);
  return names;
}

std::unique_ptr<Peer> make_peer(std::string_view name) {
  if (std::unique_ptr<Peer> whittle = whittle_on_threads(name)) return whittle;
  std::string known;
  for (const auto& [known_name, factory] : factories()) {
    if (known_name == name) return factory();
    known += known_name + ", ";
  }
  throw std::invalid_argument("no peer '" + std::string(name) + "' is built in; there are: " + known + "whittle:N");
}

}  // namespace whittle::bench
