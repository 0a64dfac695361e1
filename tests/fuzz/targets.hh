#pragma once

#include <array>
#include <string_view>

namespace whittle::test {

/// A fuzz target: takes any bytes. \throw BrokenPromise that names the promise and shows the case.
using FuzzTarget = void (*)(std::string_view bytes);

/// Files, after a byte whose lowest bit says whether to weld.
void fuzz_obj(std::string_view bytes);
void fuzz_off(std::string_view bytes);
void fuzz_ply(std::string_view bytes);
void fuzz_stl(std::string_view bytes);

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

/// Those that need no program.
inline constexpr std::array<NamedTarget, 8> library_targets{{{"obj", fuzz_obj},
                                                             {"off", fuzz_off},
                                                             {"ply", fuzz_ply},
                                                             {"stl", fuzz_stl},
                                                             {"decimate", fuzz_decimate},
                                                             {"polish", fuzz_polish},
                                                             {"metrics", fuzz_metrics},
                                                             {"steps", fuzz_steps}}};

}  // namespace whittle::test
