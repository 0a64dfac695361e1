#pragma once

#include <string>
#include <vector>

#include "options/command_line.hh"
#include "terminal/talk.hh"
#include "whittle/scene/read_scene.hh"
#include "whittle/scene/scene.hh"

namespace whittle::app {

/// Whether an input is read as a document, such as glTF.
bool reads_document(const std::string& path, const FileOptions& options);

/// \throw io::ReadError if an input is a document, and the command doesn't read it
/// \throw UsageError if an output is a document, and the command doesn't write it; if two inputs are standard input, if
/// one is and nothing tells its format, or if --format is
///        given although names and other options tell every format; as `format_for_output` for each output.
void check_formats(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                   const FileOptions& options);

/// The file of an input. \throw as `SceneFile`
SceneFile scene_file(const std::string& path, const FileOptions& options);
SceneReadOptions read_options(const FileOptions& options, unsigned threads,
                              io::AttributeScope attributes = io::AttributeScope::per_vertex);

/// Content of a file.
struct Input : Scene {
  double seconds = 0;  ///< that reading took
};

/// Reads a mesh. Prints repairs and lost content.
/// \param attributes `all` for callers that support wedges and groups \throw as `SceneFile::read`
Input read_input(const std::string& path, const FileOptions& options, unsigned threads, const Talk& talk,
                 io::AttributeScope attributes = io::AttributeScope::per_vertex);

/// Reads several files as one mesh, as `SceneJoiner` does. Each is read, and repaired, on its own.
/// \param paths not of documents \throw as `read_input` and `SceneJoiner::add`
Input read_joined(const std::vector<std::string>& paths, const FileOptions& options, unsigned threads, const Talk& talk,
                  io::AttributeScope attributes);

/// Calls `whittle::held_borders`, and prints its warnings.
std::vector<std::uint8_t> held_borders(const Input& input, unsigned threads, const Talk& talk,
                                       std::vector<std::string>& warnings);

}  // namespace whittle::app
