#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bytes/byte_sink.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::io {

// See `FormatRow`.
ReadResult read_obj(std::string_view bytes, std::string_view name, const ReadOptions& options);
/// \param text without a byte order mark \param bytes_per_chunk more than 0, up to the end of a line; the result
/// doesn't depend on it
ReadResult read_obj_in_chunks(std::string_view text, std::string_view name, std::size_t bytes_per_chunk,
                              const ReadOptions& options);
void write_obj(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options,
               std::vector<std::string>& warnings);

}  // namespace whittle::io
