#include "document/glb.hh"

#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "model/scalars.hh"
#include "whittle/io/errors.hh"

namespace whittle::gltf {
namespace {

constexpr std::size_t header_size = 12;
constexpr std::size_t chunk_header_size = 8;
constexpr std::uint32_t json_chunk = 0x4E4F534A;
constexpr std::uint32_t buffer_chunk = 0x004E4942;

struct Chunk {
  std::uint32_t type;
  std::string_view bytes;
};

/// The chunk at the beginning of what is left, which loses it.
Chunk next_chunk(std::string_view& left, std::size_t offset, const std::string& file) {
  const auto fail = [&] { throw io::ReadError(file, {.byte = offset}, "a chunk is cut off; the file is truncated"); };
  if (left.size() < chunk_header_size) fail();
  const std::size_t size = load_scalar<std::uint32_t>(left.data());
  const Chunk chunk{load_scalar<std::uint32_t>(left.data() + 4), left.substr(chunk_header_size, size)};
  if (chunk.bytes.size() < size) fail();
  left.remove_prefix(chunk_header_size + size);
  return chunk;
}

void append_chunk(std::string& glb, std::uint32_t type, std::string_view bytes, char padding) {
  const std::size_t n_padding = (4 - bytes.size() % 4) % 4;
  append_scalar(glb, static_cast<std::uint32_t>(bytes.size() + n_padding));
  append_scalar(glb, type);
  glb += bytes;
  glb.append(n_padding, padding);
}

}  // namespace

GlbParts split_glb(std::string_view bytes, const std::string& file) {
  if (bytes.size() < header_size) throw io::ReadError(file, "the header of the GLB is cut off; the file is truncated");
  const auto version = load_scalar<std::uint32_t>(bytes.data() + 4);
  if (version != 2) throw io::ReadError(file, "GLB version " + std::to_string(version) + "; only 2 is supported");
  const std::size_t size = load_scalar<std::uint32_t>(bytes.data() + 8);
  if (size > bytes.size() || size < header_size) {
    throw io::ReadError(file, "the header says " + std::to_string(size) + " bytes, the file has " +
                                  std::to_string(bytes.size()) + "; it is truncated");
  }
  std::string_view left = bytes.substr(header_size, size - header_size);
  const auto offset = [&] { return size - left.size(); };
  const Chunk json = next_chunk(left, offset(), file);
  if (json.type != json_chunk) throw io::ReadError(file, {.byte = header_size}, "the first chunk is not JSON");
  GlbParts parts{json.bytes, {}};
  while (!parts.json.empty() && parts.json.back() == '\0') parts.json.remove_suffix(1);  // some pad with zeros
  if (!left.empty()) {
    if (const Chunk chunk = next_chunk(left, offset(), file); chunk.type == buffer_chunk) parts.buffer = chunk.bytes;
  }
  return parts;
}

std::string join_glb(std::string_view json, std::string_view buffer) {
  const auto padded = [](std::size_t n) { return (n + 3) / 4 * 4; };
  const std::size_t size = header_size + chunk_header_size + padded(json.size()) +
                           (buffer.empty() ? 0 : chunk_header_size + padded(buffer.size()));
  if (size > ~std::uint32_t{0}) throw std::length_error("a GLB can't have more than 4 GiB");
  std::string glb;
  glb.reserve(size);
  glb += glb_magic;
  append_scalar(glb, std::uint32_t{2});
  append_scalar(glb, static_cast<std::uint32_t>(size));
  append_chunk(glb, json_chunk, json, ' ');
  if (!buffer.empty()) append_chunk(glb, buffer_chunk, buffer, '\0');
  return glb;
}

}  // namespace whittle::gltf
