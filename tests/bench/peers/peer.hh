#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/processes/meter.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::bench {

/// A decimater that is measured: ours, or somebody else's.
class Peer {
 public:
  Peer() = default;
  virtual ~Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  /// Decimates until at most `n_faces` faces are left, otherwise with the peer's own defaults.
  /// \param meter is started when the input is in the peer's own form, and stopped when the result is in that form
  /// \throw std::runtime_error if the peer can't hold the mesh
  virtual IndexedMesh decimate(const IndexedMesh& input, std::size_t n_faces, Meter& meter) const = 0;

  /// Name of the peer whose answer this one's must equal byte for byte; empty = none.
  virtual std::string twin() const { return {}; }
  /// Whether a wrong answer is an error of Whittle.
  virtual bool is_ours() const { return false; }
};

/// The names `make_peer` knows, in the order of the table: the peers that this benchmark was built with. "whittle:N" is
/// whittle on N threads; likewise for the others of `whittle_kinds`.
std::vector<std::string> peer_names();
/// \throw std::invalid_argument for a name that isn't among them
std::unique_ptr<Peer> make_peer(std::string_view name);

/// Whittle with one of its efforts or costs.
struct WhittleKind {
  std::string_view name;  ///< of the peer
  Effort effort;
  std::optional<Cost> cost{};  ///< default: that of the effort
};
inline constexpr WhittleKind whittle_kinds[] = {{"whittle", Effort::fast},
                                                {"whittle-normal", Effort::normal},
                                                {"whittle-best", Effort::best},
                                                {"whittle-quadric", Effort::fast, Cost::quadric}};

// One file for each peer; cgal has two peers in one file.
std::unique_ptr<Peer> make_whittle(const WhittleKind& kind, unsigned threads);
std::unique_ptr<Peer> make_meshoptimizer();
std::unique_ptr<Peer> make_openmesh();
std::unique_ptr<Peer> make_pair_decimater();
std::unique_ptr<Peer> make_cgal_lindstrom_turk();
std::unique_ptr<Peer> make_cgal_garland_heckbert();
std::unique_ptr<Peer> make_vtk();
std::unique_ptr<Peer> make_open3d();

}  // namespace whittle::bench
