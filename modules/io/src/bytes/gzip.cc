#include "bytes/gzip.hh"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <new>
#include <string>

#include "bytes/byte_cursor.hh"
#include "whittle/io/errors.hh"

namespace whittle::io {

namespace {

constexpr int gzip_window_bits = 15 + 16;  // the largest window, with a gzip header

// zlib counts in 32 bits.
uInt at_once(std::size_t count) {
  return static_cast<uInt>(std::min<std::size_t>(count, std::numeric_limits<uInt>::max()));
}

// zlib doesn't change its input, but declares it as if it might.
Bytef* as_input(const char* bytes) { return reinterpret_cast<Bytef*>(const_cast<char*>(bytes)); }

class Unpacker {
 public:
  Unpacker(std::string_view packed, std::string_view name) : packed_(packed), name_(name) {
    if (inflateInit2(&stream_, gzip_window_bits) != Z_OK) throw std::bad_alloc();
  }
  ~Unpacker() { inflateEnd(&stream_); }
  Unpacker(const Unpacker&) = delete;
  Unpacker& operator=(const Unpacker&) = delete;

  std::vector<char> unpack() {
    const std::size_t most = std::max(harmless_gzip_bytes, most_gzip_ratio * packed_.size());
    std::vector<char> unpacked(std::min(likely_size(), most) + 1);
    std::size_t done = fill(unpacked, 0);
    while (!at_end_) {
      if (done > most) fail_too_large(most);
      unpacked.resize(std::min(2 * unpacked.size(), most + 1));
      done = fill(unpacked, done);
    }
    unpacked.resize(done);
    return unpacked;
  }

 private:
  // The last four bytes are the length of the last member, modulo 2³². They may be wrong.
  std::size_t likely_size() const {
    if (packed_.size() < 4) return 0;
    const auto length = load<std::uint32_t>(packed_.data() + packed_.size() - 4, std::endian::little);
    constexpr std::size_t likely_ratio = 32;
    return std::min<std::size_t>(length, likely_ratio * packed_.size());
  }

  // Unpacks until `unpacked` is full or the data end. \param done bytes unpacked before. Returns the new number.
  std::size_t fill(std::vector<char>& unpacked, std::size_t done) {
    while (done < unpacked.size() && !at_end_) {
      stream_.next_in = as_input(packed_.data() + used_);
      stream_.avail_in = at_once(packed_.size() - used_);
      stream_.next_out = reinterpret_cast<Bytef*>(unpacked.data() + done);
      stream_.avail_out = at_once(unpacked.size() - done);
      const uInt input = stream_.avail_in;
      const uInt room = stream_.avail_out;
      const int status = inflate(&stream_, Z_NO_FLUSH);
      used_ += input - stream_.avail_in;
      done += room - stream_.avail_out;
      look_at(status);
    }
    return done;
  }

  void look_at(int status) {
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    if (status == Z_STREAM_END) return end_member();
    if (status == Z_OK) return;
    if (status == Z_BUF_ERROR) fail("the gzip data end too early; the file is truncated");
    fail("the gzip data are damaged" + (stream_.msg != nullptr ? " (" + std::string(stream_.msg) + ")" : ""));
  }

  void end_member() {
    at_end_ = used_ == packed_.size();
    if (at_end_) return;
    if (!is_gzip(packed_.substr(used_))) fail("the file goes on after the end of its gzip data");
    inflateReset(&stream_);
  }

  [[noreturn]] void fail_too_large(std::size_t most) const {
    fail("the gzip data unpack to more than " + std::to_string(most >> 20) + " MiB, " +
         std::to_string(most / std::max<std::size_t>(packed_.size(), 1)) +
         " times their size, as no mesh does; if it is one, unpack it first (gunzip)");
  }

  [[noreturn]] void fail(const std::string& problem) const { throw ReadError(std::string(name_), problem); }

  std::string_view packed_;
  std::string_view name_;
  z_stream stream_{};
  std::size_t used_ = 0;
  bool at_end_ = false;
};

}  // namespace

std::vector<char> gunzip(std::string_view packed, std::string_view name) { return Unpacker(packed, name).unpack(); }

GzipBuffer::GzipBuffer(std::ostream& out) : out_(out), stream_(std::make_unique<z_stream>()) {
  constexpr int memory_level = 8;  // zlib's default
  if (deflateInit2(stream_.get(), Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window_bits, memory_level,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::bad_alloc();
  }
}

GzipBuffer::~GzipBuffer() { deflateEnd(stream_.get()); }

void GzipBuffer::finish() {
  pack(nullptr, 0, Z_FINISH);
  out_.flush();
}

GzipBuffer::int_type GzipBuffer::overflow(int_type c) {
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  const char byte = traits_type::to_char_type(c);
  return xsputn(&byte, 1) == 1 ? c : traits_type::eof();
}

std::streamsize GzipBuffer::xsputn(const char* bytes, std::streamsize count) {
  for (auto left = static_cast<std::size_t>(count); left > 0;) {
    const std::size_t part = at_once(left);
    pack(bytes, part, Z_NO_FLUSH);
    bytes += part;
    left -= part;
  }
  return out_ ? count : 0;
}

void GzipBuffer::pack(const char* bytes, std::size_t count, int flush) {
  stream_->next_in = as_input(bytes);
  stream_->avail_in = static_cast<uInt>(count);
  do {
    stream_->next_out = reinterpret_cast<Bytef*>(block_.data());
    stream_->avail_out = static_cast<uInt>(block_.size());
    deflate(stream_.get(), flush);
    out_.write(block_.data(), static_cast<std::streamsize>(block_.size() - stream_->avail_out));
  } while (stream_->avail_out == 0);
}

}  // namespace whittle::io
