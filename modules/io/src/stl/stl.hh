#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bytes/byte_sink.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::io {

/// Bytes of any text at the beginning of a binary file; the number of facets follows.
constexpr std::size_t stl_header_bytes = 80;

// See `FormatRow`.
ReadResult read_stl(std::string_view bytes, std::string_view name, const ReadOptions& options);
void write_stl(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options,
               std::vector<std::string>& warnings);

/// The file is exactly as long as binary STL with the number of facets in its header.
bool is_binary_stl_by_size(std::string_view bytes);

}  // namespace whittle::io
