#include "commands/page/animation.hh"

#include <memory>
#include <stdexcept>

#ifdef WHITTLE_WEBP
#include <webp/mux.h>
#endif

namespace whittle::app {

#ifdef WHITTLE_WEBP

namespace {

constexpr int milliseconds = 120;
constexpr int milliseconds_of_last = 1500;

struct DeleteMux {
  void operator()(WebPMux* mux) const { WebPMuxDelete(mux); }
};

WebPData data_of(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

void require(WebPMuxError error) {
  if (error != WEBP_MUX_OK)
    throw std::runtime_error("libwebp can't make a moving picture: error " + std::to_string(error));
}

}  // namespace

bool has_animations() { return true; }

std::string Animation::finished() const {
  const std::unique_ptr<WebPMux, DeleteMux> mux(WebPMuxNew());
  if (!mux) throw std::bad_alloc();
  for (const std::string& picture : pictures_) {
    WebPMuxFrameInfo frame{};
    frame.bitstream = data_of(picture);
    frame.duration = &picture == &pictures_.back() ? milliseconds_of_last : milliseconds;
    frame.id = WEBP_CHUNK_ANMF;
    frame.dispose_method = WEBP_MUX_DISPOSE_NONE;
    frame.blend_method = WEBP_MUX_NO_BLEND;
    require(WebPMuxPushFrame(mux.get(), &frame, 1));
  }
  const WebPMuxAnimParams parameters{0xffffffff, 0};  // white; for ever
  require(WebPMuxSetAnimationParams(mux.get(), &parameters));
  WebPData file{};
  require(WebPMuxAssemble(mux.get(), &file));
  std::string bytes(reinterpret_cast<const char*>(file.bytes), file.size);
  WebPDataClear(&file);
  return bytes;
}

#else

bool has_animations() { return false; }

std::string Animation::finished() const {
  throw std::runtime_error("this whittle was built without libwebp: it makes no moving pictures");
}

#endif

}  // namespace whittle::app
