#include "whittle/core/bytes/glb.hh"

#include <stdexcept>

#include "whittle/core/bytes/little_endian.hh"

namespace whittle {
namespace {

std::size_t padded(std::size_t n) { return (n + 3) / 4 * 4; }

void append_chunk(std::string& glb, std::uint32_t type, std::string_view bytes, char padding) {
  append_little_endian(glb, static_cast<std::uint32_t>(padded(bytes.size())));
  append_little_endian(glb, type);
  glb += bytes;
  glb.append(padded(bytes.size()) - bytes.size(), padding);
}

}  // namespace

std::string join_glb(std::string_view json, std::string_view buffer) {
  const std::size_t size = glb_header_size + glb_chunk_header_size + padded(json.size()) +
                           (buffer.empty() ? 0 : glb_chunk_header_size + padded(buffer.size()));
  if (size > ~std::uint32_t{0}) throw std::length_error("a GLB can't have more than 4 GiB");
  std::string glb;
  glb.reserve(size);
  glb += glb_magic;
  append_little_endian(glb, glb_version);
  append_little_endian(glb, static_cast<std::uint32_t>(size));
  append_chunk(glb, glb_json_chunk, json, ' ');
  if (!buffer.empty()) append_chunk(glb, glb_buffer_chunk, buffer, '\0');
  return glb;
}

}  // namespace whittle
