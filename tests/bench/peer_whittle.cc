#include "peer.hh"
#include "whittle/engine/decimate.hh"

// Whittle's engine with its defaults: quadrics, optimal placement, every guard, counted rejections; and with a progress
// callback, as the program has one.

namespace whittle::bench {
namespace {

class Whittle : public Peer {
 public:
  explicit Whittle(unsigned threads) : threads_(threads) {}

  IndexedMesh decimate(const IndexedMesh& input, std::size_t n_faces, Meter& meter) const override {
    DecimateOptions options;
    options.threads = threads_;
    options.progress = [](const Progress&) { return true; };
    meter.start();
    Decimation decimation = whittle::decimate(input, {.faces = n_faces}, options);
    meter.stop();
    return std::move(decimation.mesh);
  }

  std::string twin() const override { return threads_ == 1 ? "" : "whittle"; }
  bool is_ours() const override { return true; }

 private:
  unsigned threads_;
};

}  // namespace

std::unique_ptr<Peer> make_whittle(unsigned threads) { return std::make_unique<Whittle>(threads); }

}  // namespace whittle::bench
