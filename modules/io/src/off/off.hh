#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bytes/byte_sink.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::io {

// See `FormatRow`.
ReadResult read_off(std::string_view bytes, std::string_view name, const ReadOptions& options);
void write_off(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options,
               std::vector<std::string>& warnings);

}  // namespace whittle::io
