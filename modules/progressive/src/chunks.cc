#include "chunks.hh"

#include <xxhash.h>
#ifdef WHITTLE_ZSTD
#include <zstd.h>
#endif

#include <array>
#include <istream>
#include <ostream>

#include "bytes.hh"

namespace whittle::progressive {
namespace {

constexpr std::uint32_t version = 1;
constexpr std::uint32_t is_compressed = 1;  // a flag
constexpr std::size_t header_bytes = 16;
constexpr std::size_t check_bytes = 8;

#ifdef WHITTLE_ZSTD
std::string compressed(std::string_view bytes) {
  constexpr int fast = 1;
  std::string result(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t n = ZSTD_compress(result.data(), result.size(), bytes.data(), bytes.size(), fast);
  if (ZSTD_isError(n) != 0) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(n));
  result.resize(n);
  return result;
}

std::string decompressed(std::string_view bytes, std::size_t size) {
  std::string result(size, '\0');
  const std::size_t n = ZSTD_decompress(result.data(), result.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(n) != 0 || n != size) throw RecordingError("a part of it can't be decompressed");
  return result;
}
#else
std::string compressed(std::string_view) { throw std::runtime_error("this program was built without zstd"); }

std::string decompressed(std::string_view, std::size_t) {
  throw RecordingError("it is compressed, and this program was built without zstd");
}
#endif

std::string read_bytes(std::istream& in, std::size_t n) {
  std::string bytes(n, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(n));
  if (static_cast<std::size_t>(in.gcount()) != n) throw RecordingError("it ends too soon; the file is not complete");
  return bytes;
}

}  // namespace

void write_signature(std::ostream& out) {
  ByteWriter writer;
  writer.text(recording_signature);
  writer.number(version);
  writer.number(std::uint32_t{0});
  out << writer.bytes();
}

void read_signature(std::istream& in) {
  std::string bytes(header_bytes, '\0');
  in.read(bytes.data(), header_bytes);
  const auto n = static_cast<std::size_t>(in.gcount());
  if (n < recording_signature.size() || !bytes.starts_with(recording_signature))
    throw RecordingError("it is no recording of whittle");
  if (n < header_bytes) throw RecordingError("it ends too soon; the file is not complete");
  ByteReader reader(std::string_view(bytes).substr(recording_signature.size()));
  const auto found = reader.number<std::uint32_t>();
  if (found != version) {
    throw RecordingError("it is of version " + std::to_string(found) + ", and only version 1 can be read");
  }
}

std::string framed(std::string_view type, std::string_view payload, bool compress) {
  std::string packed;
  if (compress) packed = compressed(payload);
  const std::string_view stored = compress ? std::string_view(packed) : payload;
  ByteWriter writer;
  writer.bytes().reserve(header_bytes + stored.size() + check_bytes);
  writer.text(type);
  writer.number(compress ? is_compressed : 0);
  writer.number(static_cast<std::uint32_t>(stored.size()));
  writer.number(static_cast<std::uint32_t>(payload.size()));
  writer.text(stored);
  writer.number(static_cast<std::uint64_t>(XXH3_64bits(writer.bytes().data(), writer.bytes().size())));
  return std::move(writer.bytes());
}

Chunk read_chunk(std::istream& in) {
  std::string bytes = read_bytes(in, header_bytes);
  ByteReader header(bytes);
  Chunk chunk;
  chunk.type = header.text(4);
  const auto flags = header.number<std::uint32_t>();
  const auto stored_size = header.number<std::uint32_t>();
  const auto size = header.number<std::uint32_t>();
  if (size > most_chunk_bytes || stored_size > most_chunk_bytes + most_chunk_bytes / 64) {
    throw RecordingError("it is damaged: a part is too large");
  }
  bytes += read_bytes(in, stored_size + check_bytes);
  const std::string_view checked = std::string_view(bytes).substr(0, header_bytes + stored_size);
  ByteReader check(std::string_view(bytes).substr(checked.size()));
  if (check.number<std::uint64_t>() != XXH3_64bits(checked.data(), checked.size())) {
    throw RecordingError("it is damaged: its bytes don't match their check");
  }
  const std::string_view stored = checked.substr(header_bytes);
  if (flags > is_compressed || (flags == 0 && stored_size != size)) {
    throw RecordingError("it is damaged: a part has unknown flags or sizes");
  }
  chunk.payload = flags == is_compressed ? decompressed(stored, size) : std::string(stored);
  return chunk;
}

}  // namespace whittle::progressive
