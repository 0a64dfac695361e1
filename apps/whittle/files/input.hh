#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "options/command_line.hh"
#include "terminal/talk.hh"
#include "whittle/io/read.hh"

namespace whittle::app {

/// How the standard streams are named on the command line.
inline constexpr std::string_view standard_stream = "-";
inline constexpr char standard_input_name[] = "standard input";

/// The format a file name tells, if it does.
std::optional<io::Format> format_by_name(const std::string& path);

/// The format to write a file in: that of its name, else the one given.
/// \throw UsageError if neither tells it.
io::Format format_for_output(const std::string& path, std::optional<io::Format> given);

/// \throw UsageError if two inputs are standard input, if one is and --format is missing, or if --format is given
///        although every name tells its format.
void check_inputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                  std::optional<io::Format> given);

/// A mesh file that may be read more than once; of standard input, which can't, the content is kept.
class MeshFile {
 public:
  /// \param given the format, where the name doesn't tell it.
  MeshFile(std::string path, std::optional<io::Format> given);
  io::ReadResult read(bool weld) const;
  /// As shown: the path, or "standard input".
  std::string name() const { return path_ == standard_stream ? standard_input_name : path_; }

 private:
  std::string path_;
  std::optional<io::Format> format_;
  std::vector<char> standard_input_;
};

/// A mesh as it was read.
struct Input {
  std::string path;  ///< as given
  std::string name;  ///< as shown: the path, or "standard input"
  io::ReadResult read;
  std::vector<std::string> warnings;  ///< those of `read`, with the name in front
  double seconds = 0;                 ///< it took to read
};

/// "NAME: TEXT", how a line that is about a file begins.
std::string about(const std::string& name, const std::string& text);

/// Reads a mesh, and says what was repaired and what is not carried.
/// \throw io::ReadError as `io::read_mesh`.
Input read_input(const std::string& path, const InputOptions& options, const Talk& talk);

}  // namespace whittle::app
