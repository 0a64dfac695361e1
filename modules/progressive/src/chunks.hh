#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

// The frame of a recording: a signature, and chunks. Each has a type of four letters, and a check of its bytes. Readers
// may skip an unknown chunk whose type begins with a small letter.

namespace whittle::progressive {

struct Chunk {
  std::string type;
  std::string payload;
};

/// Writes the first bytes of the file. They reveal whether the bytes were converted as text.
void write_signature(std::ostream& out);
/// \throw RecordingError
void read_signature(std::istream& in);

/// A chunk's bytes in the file. \pre a payload of at most `most_chunk_bytes`
std::string framed(std::string_view type, std::string_view payload, bool compress);
inline constexpr std::size_t most_chunk_bytes = std::size_t{1} << 24;

/// \throw RecordingError at the end of the file, too
Chunk read_chunk(std::istream& in);

}  // namespace whittle::progressive
