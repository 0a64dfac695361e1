#pragma once

#include <cmath>

#include "byte_sink.hh"
#include "whittle/io/write.hh"

namespace whittle::io {

// One writer a format. `warnings` gets what the file can't hold.
void write_obj(ByteSink& sink, const IndexedMesh& mesh, std::vector<std::string>& warnings);
void write_off(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options);
void write_ply(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options);
/// \throw std::range_error if a coordinate is beyond 32 bits and the file is binary.
void write_stl(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options,
               std::vector<std::string>& warnings);

/// The nearest of 0…255 for an intensity of 0…1.
inline unsigned to_byte(float intensity) {
  return intensity > 0 ? static_cast<unsigned>(std::lround(std::min(intensity, 1.0F) * 255.0F)) : 0U;
}

/// Some colour is not opaque.
inline bool has_opacity(const IndexedMesh& mesh) {
  return std::any_of(mesh.colors.begin(), mesh.colors.end(), [](const Color& c) { return c[3] != 1; });
}

}  // namespace whittle::io
