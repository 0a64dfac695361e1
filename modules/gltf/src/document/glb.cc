#include "document/glb.hh"

#include <cstddef>
#include <cstdint>

#include "whittle/core/bytes/little_endian.hh"
#include "whittle/io/errors.hh"

namespace whittle::gltf {
namespace {

struct Chunk {
  std::uint32_t type;
  std::string_view bytes;
};

/// Takes the first chunk off `left`.
Chunk next_chunk(std::string_view& left, std::size_t offset, const std::string& file) {
  const auto fail = [&] { throw io::ReadError(file, {.byte = offset}, "a chunk is cut off; the file is truncated"); };
  if (left.size() < glb_chunk_header_size) fail();
  const std::size_t size = load_little_endian<std::uint32_t>(left.data());
  const Chunk chunk{load_little_endian<std::uint32_t>(left.data() + 4), left.substr(glb_chunk_header_size, size)};
  if (chunk.bytes.size() < size) fail();
  left.remove_prefix(glb_chunk_header_size + size);
  return chunk;
}

}  // namespace

GlbParts split_glb(std::string_view bytes, const std::string& file) {
  if (bytes.size() < glb_header_size)
    throw io::ReadError(file, "the header of the GLB is cut off; the file is truncated");
  const auto version = load_little_endian<std::uint32_t>(bytes.data() + 4);
  if (version != glb_version)
    throw io::ReadError(file, "GLB version " + std::to_string(version) + "; only 2 is supported");
  const std::size_t size = load_little_endian<std::uint32_t>(bytes.data() + 8);
  if (size > bytes.size() || size < glb_header_size) {
    throw io::ReadError(file, "the header says " + std::to_string(size) + " bytes, the file has " +
                                  std::to_string(bytes.size()) + "; it is truncated");
  }
  std::string_view left = bytes.substr(glb_header_size, size - glb_header_size);
  const auto offset = [&] { return size - left.size(); };
  const Chunk json = next_chunk(left, offset(), file);
  if (json.type != glb_json_chunk) throw io::ReadError(file, {.byte = glb_header_size}, "the first chunk is not JSON");
  GlbParts parts{json.bytes, {}};
  while (!parts.json.empty() && parts.json.back() == '\0') parts.json.remove_suffix(1);  // some pad with zeros
  if (!left.empty()) {
    if (const Chunk chunk = next_chunk(left, offset(), file); chunk.type == glb_buffer_chunk)
      parts.buffer = chunk.bytes;
  }
  return parts;
}

}  // namespace whittle::gltf
