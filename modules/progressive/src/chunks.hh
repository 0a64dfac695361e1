#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

// The frame of a recording: a signature, and chunks. Each has a type of four letters, and a check of its bytes. A chunk
// of a type that begins with a small letter may be left out by those who don't know it.

namespace whittle::progressive {

struct Chunk {
  std::string type;
  std::string payload;
};

/// At the beginning of the file. It shows whether the bytes were taken for text somewhere.
void write_signature(std::ostream& out);
/// \throw RecordingError
void read_signature(std::istream& in);

/// A chunk's bytes in the file. \pre a payload of at most `most_chunk_bytes`
std::string framed(std::string_view type, std::string_view payload, bool compress);
inline constexpr std::size_t most_chunk_bytes = std::size_t{1} << 24;

/// \throw RecordingError at the end of the file, too
Chunk read_chunk(std::istream& in);

}  // namespace whittle::progressive
