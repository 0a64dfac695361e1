#include <string>
#include <utility>

#include "bench/peers/peer.hh"
#include "whittle/simplify/simplify.hh"

// Whittle as the program runs it with --effort or --cost: optimal placement, all guards, counted refusals, and a
// progress callback.

namespace whittle::bench {
namespace {

class Whittle : public Peer {
 public:
  Whittle(const WhittleKind& kind, unsigned threads) : kind_(kind), threads_(threads) {}

  IndexedMesh decimate(const IndexedMesh& input, std::size_t n_faces, Meter& meter) const override {
    SimplifyOptions options;
    options.decimate.cost = kind_.cost;
    options.decimate.threads = threads_;
    options.decimate.progress = [](const Progress&) { return true; };
    meter.start();
    Simplification simplified = simplify(input, DecimateTarget::faces(n_faces), kind_.effort, options);
    meter.stop();
    return std::move(simplified.mesh);
  }

  std::string twin() const override { return threads_ == 1 ? "" : std::string(kind_.name); }
  bool is_ours() const override { return true; }

 private:
  WhittleKind kind_;
  unsigned threads_;
};

}  // namespace

std::unique_ptr<Peer> make_whittle(const WhittleKind& kind, unsigned threads) {
  return std::make_unique<Whittle>(kind, threads);
}

}  // namespace whittle::bench
