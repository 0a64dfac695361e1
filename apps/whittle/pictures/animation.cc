#include "pictures/animation.hh"

#include <memory>
#include <stdexcept>

#ifdef WHITTLE_WEBP
#include <webp/encode.h>
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

void require_animations() {}

void Animation::add(const RgbPicture& picture) {
  constexpr float quality = 90;  // of 100
  std::uint8_t* bytes = nullptr;
  const auto width = static_cast<int>(picture.width);
  const std::size_t n_bytes =
      WebPEncodeRGB(picture.bytes.data(), width, static_cast<int>(picture.height), 3 * width, quality, &bytes);
  if (n_bytes == 0) throw std::runtime_error("libwebp can't store a picture");
  pictures_.emplace_back(reinterpret_cast<const char*>(bytes), n_bytes);
  WebPFree(bytes);
}

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

void require_animations() {
  throw std::runtime_error("this whittle was built without libwebp: it makes no moving pictures");
}

void Animation::add(const RgbPicture&) { require_animations(); }

std::string Animation::finished() const { return {}; }

#endif

}  // namespace whittle::app
