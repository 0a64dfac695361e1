#include <string>
#include <utility>

#include "bench/peers/peer.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/polish/polish.hh"

// Whittle's engine as the program runs it with --effort: optimal placement, all guards, counted refusals, and a
// progress callback.

namespace whittle::bench {
namespace {

class Whittle : public Peer {
 public:
  Whittle(WhittleEffort effort, unsigned threads) : effort_(effort), threads_(threads) {}

  IndexedMesh decimate(const IndexedMesh& input, std::size_t n_faces, Meter& meter) const override {
    DecimateOptions options;
    if (effort_ != WhittleEffort::fast) options.cost = Cost::memoryless;
    options.threads = threads_;
    options.progress = [](const Progress&) { return true; };
    PolishOptions polish_options;
    polish_options.passes = effort_ == WhittleEffort::best ? 3 : 1;
    polish_options.flips = effort_ == WhittleEffort::best;
    polish_options.threads = threads_;
    meter.start();
    Decimation decimation = whittle::decimate(input, DecimateTarget::faces(n_faces), options);
    if (effort_ != WhittleEffort::fast) polish(input, decimation.vertex_map, decimation.mesh, polish_options);
    meter.stop();
    return std::move(decimation.mesh);
  }

  std::string twin() const override { return threads_ == 1 ? "" : std::string(name_of(effort_)); }
  bool is_ours() const override { return true; }

 private:
  WhittleEffort effort_;
  unsigned threads_;
};

}  // namespace

std::string_view name_of(WhittleEffort effort) {
  switch (effort) {
    case WhittleEffort::normal:
      return "whittle-normal";
    case WhittleEffort::best:
      return "whittle-best";
    case WhittleEffort::fast:
      break;
  }
  return "whittle";
}

std::unique_ptr<Peer> make_whittle(WhittleEffort effort, unsigned threads) {
  return std::make_unique<Whittle>(effort, threads);
}

}  // namespace whittle::bench
