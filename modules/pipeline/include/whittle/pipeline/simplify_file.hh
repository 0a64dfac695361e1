#pragma once

#include <string>
#include <vector>

#include "whittle/io/output_files.hh"
#include "whittle/pipeline/run.hh"
#include "whittle/scene/format.hh"

namespace whittle {

/// What to read of a document: all meshes, each once, if they are written as a document again with their attributes;
/// otherwise what its scene shows.
SceneScope scope_for(const SceneFormat* output, bool keeps_attributes = true);

struct FileRun {
  Plan plan;
  Outcome outcome;
  SceneMessages messages;  ///< of writing

  /// All warnings, in the order in which they came up: a line each.
  std::vector<std::string> warnings() const;
};

/// Does what `whittle simplify INPUT -o OUTPUT` does, to the byte: reads a file, plans, runs, and writes the result
/// with the files that it needs beside it. All of them appear, or none. \param output a file that exists is replaced
/// \param request Path, format and scope of reading are set by the names of the files.
/// \throw std::invalid_argument if the output's name tells no format
/// \throw io::WriteError if a file can't be written, or if the input needs it
/// \throw what `read_scene`, `plan`, `run` and `write_scene` throw
FileRun simplify_file(const std::string& input, const std::string& output, Request request,
                      const RunObserver& observer = {});

}  // namespace whittle
