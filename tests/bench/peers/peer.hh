#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/processes/meter.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::bench {

/// A decimater that is measured: ours, or somebody else's.
class Peer {
 public:
  Peer() = default;
  virtual ~Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  /// Decimates until at most `n_faces` faces are left, by the peer's own defaults otherwise.
  /// \param meter is started when the input is in the form that the peer takes, and stopped when the result is in the
  ///        form that it gives
  /// \throw std::runtime_error if the peer can't hold the mesh
  virtual IndexedMesh decimate(const IndexedMesh& input, std::size_t n_faces, Meter& meter) const = 0;

  /// Name of the peer whose answer this one's must equal in every byte; empty = none.
  virtual std::string twin() const { return {}; }
  /// Whether a wrong answer is a fault of Whittle's.
  virtual bool is_ours() const { return false; }
};

/// The names `make_peer` knows, in the order of the table: those that were asked for when the benchmark was built.
/// "whittle:N" is whittle on N threads, and so with "whittle-normal" and "whittle-best".
std::vector<std::string> peer_names();
/// \throw std::invalid_argument for a name that isn't among them
std::unique_ptr<Peer> make_peer(std::string_view name);

/// As the program's.
enum class WhittleEffort { fast, normal, best };
std::string_view name_of(WhittleEffort effort);

// A file each; both of CGAL in one.
std::unique_ptr<Peer> make_whittle(WhittleEffort effort, unsigned threads);
std::unique_ptr<Peer> make_meshoptimizer();
std::unique_ptr<Peer> make_openmesh();
std::unique_ptr<Peer> make_pair_decimater();
std::unique_ptr<Peer> make_cgal_lindstrom_turk();
std::unique_ptr<Peer> make_cgal_garland_heckbert();
std::unique_ptr<Peer> make_vtk();
std::unique_ptr<Peer> make_open3d();

}  // namespace whittle::bench
