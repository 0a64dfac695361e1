#include <functional>
#include <stdexcept>
#include <utility>

#include "peer.hh"

namespace whittle::bench {
namespace {

using Factory = std::function<std::unique_ptr<Peer>()>;

/// WHITTLE_BENCH_HAS_… comes from CMake.
const std::vector<std::pair<std::string, Factory>>& factories() {
  static const std::vector<std::pair<std::string, Factory>> all = {
      {"whittle", [] { return make_whittle(1); }},
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

/// N of "whittle:N", 0 for any other name.
unsigned threads_of(std::string_view name) {
  constexpr std::string_view prefix = "whittle:";
  if (!name.starts_with(prefix)) return 0;
  const std::string digits(name.substr(prefix.size()));
  const bool is_number = !digits.empty() && digits.size() <= 3 && digits.find_first_not_of("0123456789") == digits.npos;
  return is_number ? static_cast<unsigned>(std::stoul(digits)) : 0;
}

}  // namespace

std::vector<std::string> peer_names() {
  std::vector<std::string> names;
  for (const auto& [name, factory] : factories()) names.push_back(name);
  return names;
}

std::unique_ptr<Peer> make_peer(std::string_view name) {
  if (const unsigned threads = threads_of(name)) return make_whittle(threads);
  std::string known;
  for (const auto& [known_name, factory] : factories()) {
    if (known_name == name) return factory();
    known += known_name + ", ";
  }
  throw std::invalid_argument("no peer '" + std::string(name) + "' is built in; there are: " + known + "whittle:N");
}

}  // namespace whittle::bench
