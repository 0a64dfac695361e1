#include "write/share_buffer.hh"

#include <cstddef>
#include <optional>
#include <utility>

#include "document/json.hh"
#include "document/uri.hh"
#include "write/pack_buffers.hh"
#include "write/references.hh"

namespace whittle::gltf {
namespace {

/// As new geometry is aligned.
std::size_t rounded_up(std::size_t n_bytes) { return (n_bytes + 3) / 4 * 4; }

/// "image/png" of a data URI.
std::string media_type_of(const std::string& uri) {
  const std::size_t begin = uri.find(':') + 1;
  return uri.substr(begin, uri.find_first_of(";,", begin) - begin);
}

/// Moves images that are part of the text into a buffer. \param bytes of the buffer
void take_images(Json& document, std::size_t buffer, std::string& bytes) {
  const std::size_t n_images = elements_of(document, "images").size();
  for (std::size_t i = 0; i < n_images; ++i) {
    Json& image = document["images"][i];
    const Json* const uri = member(image, "uri");
    if (uri == nullptr || !uri->is_string() || !is_data_uri(uri->get_ref<const std::string&>())) continue;
    const std::optional<std::string> content = decode_data_uri(uri->get_ref<const std::string&>());
    if (!content || content->empty()) continue;
    bytes.resize(rounded_up(bytes.size()));
    Json& views = document["bufferViews"];
    if (!image.contains("mimeType")) image["mimeType"] = media_type_of(uri->get<std::string>());
    image["bufferView"] = views.size();
    image.erase("uri");
    views.push_back({{"buffer", buffer}, {"byteOffset", bytes.size()}, {"byteLength", content->size()}});
    bytes += *content;
  }
}

/// Moves ranges in the first bytes of the first buffer to another buffer, and others to the beginning of the first.
/// \param n_bytes that leave the buffer
void move_ranges(Json& document, std::size_t n_bytes, std::size_t to) {
  for_each_range(document, [&](Json& range) {
    if (as_whole(range["buffer"]) != first_buffer) return;
    const Json* const given = member(range, "byteOffset");
    const std::size_t offset = given ? as_whole(*given).value_or(0) : 0;
    if (offset < n_bytes) {
      range["buffer"] = to;
    } else {
      range["byteOffset"] = offset - n_bytes;
    }
  });
}

}  // namespace

std::string take_shared_buffer(Output& output, const std::string& uri) {
  const std::size_t n_bytes = rounded_up(output.n_kept_bytes);
  if (n_bytes >= output.buffer.size()) return {};  // there is no geometry of its own
  const std::size_t number = output.document["buffers"].size();
  std::string shared = output.buffer.substr(0, output.n_kept_bytes);
  if (n_bytes > 0) move_ranges(output.document, n_bytes, number);
  take_images(output.document, number, shared);
  if (shared.empty()) return {};
  output.buffer.erase(0, n_bytes);
  Json& buffers = output.document["buffers"];
  buffers[first_buffer]["byteLength"] = output.buffer.size();
  buffers.push_back({{"uri", uri}, {"byteLength", shared.size()}});
  return shared;
}

}  // namespace whittle::gltf
