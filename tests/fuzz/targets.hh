#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "whittle/io/format.hh"

namespace whittle::test {

/// A fuzz target: takes any bytes. \throw BrokenPromise that names the promise and shows the case.
using FuzzTarget = std::function<void(std::string_view bytes)>;

/// The reader of a format. \param bytes the lowest bit of the first says whether to weld; the file follows
void fuzz_reader(std::string_view bytes, io::Format format);

/// `decimate` of any triangles with any options (decode/decimate_bytes.hh).
void fuzz_decimate(std::string_view bytes);
/// `polish` of decimated meshes, and of any mesh to any other.
void fuzz_polish(std::string_view bytes);
/// All of `whittle::metrics`, on any two meshes.
void fuzz_metrics(std::string_view bytes);
/// Levels, geomorphs and recordings, of the steps of a run or of any other steps.
void fuzz_steps(std::string_view bytes);

/// The command line of the program.
void fuzz_command_line(std::string_view bytes);

struct NamedTarget {
  std::string_view name;  ///< of its corpus, too
  FuzzTarget run;
};

/// Those that need no program: the reader of each format, under the format's name, and the others.
std::vector<NamedTarget> library_targets();
/// \throw std::out_of_range if none has that name
FuzzTarget library_target(std::string_view name);

}  // namespace whittle::test
