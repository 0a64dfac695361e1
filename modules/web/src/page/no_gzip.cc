#include "../../../io/src/bytes/gzip.hh"

#include <string>

#include "whittle/io/errors.hh"

// Without zlib: the page unpacks files by the browser's own functions before they are read, and packs none.

struct z_stream_s {};

namespace whittle::io {

std::vector<char> gunzip(std::string_view /*packed*/, std::string_view name) {
  throw ReadError(std::string(name), "is packed with gzip once more: unpack it first");
}

GzipBuffer::GzipBuffer(std::ostream& out) : out_(out), block_() { out_.setstate(std::ios::failbit); }
GzipBuffer::~GzipBuffer() = default;
void GzipBuffer::finish() {}
GzipBuffer::int_type GzipBuffer::overflow(int_type /*c*/) { return traits_type::eof(); }
std::streamsize GzipBuffer::xsputn(const char* /*bytes*/, std::streamsize /*count*/) { return 0; }

}  // namespace whittle::io
