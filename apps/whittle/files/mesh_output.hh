#pragma once

#include <string>
#include <vector>

#include "files/gltf_file.hh"
#include "files/input.hh"
#include "files/output.hh"

namespace whittle::app {

/// What is written, and how.
struct MeshOutput {
  std::string path;
  FileOptions options;
  bool compresses_gltf = false;
};

/// Whether it is written as glTF.
bool is_gltf_output(const std::string& path, const FileOptions& options);

/// "ply", "gltf"
std::string output_format_name(const std::string& path, const FileOptions& options);

/// Writes what has become of an input, with all that a file of the output's format can say of it, and the files that it
/// needs beside it. A glTF input stays what it is in all but its meshes.
/// \param mesh that of the input, simplified or as it is \param warnings gets a line for each thing that is lost
void write_result(OutputFiles& files, const MeshOutput& output, Input& input, const IndexedMesh& mesh, const Talk& talk,
                  std::vector<std::string>& warnings);

/// Writes an input with coarser levels of detail beside it, as the extension MSFT_lod has them.
/// \param levels of the input, the finer ones first \pre the output is glTF, and is written once
void write_levels(OutputFiles& files, const MeshOutput& output, Input& input, CoarserLevels levels, const Talk& talk,
                  std::vector<std::string>& warnings);

/// The mesh as it is read again from what `write_result` writes without compression.
/// A vertex that the file has several times has one place in it.
IndexedMesh as_written(const MeshOutput& output, const Input& input, const IndexedMesh& mesh, unsigned threads);
/// How far the places of such a vertex lie apart at most.
double widest_gap_as_written(const MeshOutput& output, const Input& input, const IndexedMesh& mesh);

}  // namespace whittle::app
