#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <ostream>
#include <streambuf>
#include <string_view>
#include <vector>

struct z_stream_s;

namespace whittle::io {

/// Whether bytes begin as gzip data do (RFC 1952).
inline bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1F\x8B"); }

/// Size up to which gzip data may always unpack; beyond it only to at most `most_gzip_ratio` times their size. Meshes
/// pack to a half to a twentieth (text STL of a flat grid). Deflate can pack to a thousandth, so that a small file
/// could take all memory.
inline constexpr std::size_t harmless_gzip_bytes = std::size_t{256} << 20;
inline constexpr std::size_t most_gzip_ratio = 100;

/// Unpacks gzip data, all members one after another. Their checksums and lengths are compared.
/// \param name of the file, for messages. \throw ReadError if the data are damaged or truncated, if they don't end with
/// the file, or if they unpack to more than allowed.
std::vector<char> gunzip(std::string_view packed, std::string_view name);

/// Compresses its input to another stream. Equal input gives equal output.
class GzipBuffer : public std::streambuf {
 public:
  explicit GzipBuffer(std::ostream& out);
  ~GzipBuffer() override;
  GzipBuffer(const GzipBuffer&) = delete;
  GzipBuffer& operator=(const GzipBuffer&) = delete;

  /// Writes the rest and the checksum. Errors show in the state of the other stream.
  void finish();

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* bytes, std::streamsize count) override;

 private:
  /// Gives zlib `count` bytes. \param flush as zlib's `deflate` has it
  void pack(const char* bytes, std::size_t count, int flush);

  std::ostream& out_;
  std::unique_ptr<z_stream_s> stream_;
  std::array<char, std::size_t{1} << 16> block_;
};

}  // namespace whittle::io
