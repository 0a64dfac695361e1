#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "terminal/interruption.hh"
#include "whittle/io/output_file.hh"

namespace whittle::app {

inline constexpr char standard_output_name[] = "standard output";

/// A file to be written, and the option that names it.
struct Output {
  std::string option;  ///< "--output"
  std::string path;
};

/// \throw UsageError if two outputs are the same file or both standard output, or if an output is one of the `inputs`
///        and `force` isn't set.
/// \throw io::WriteError if the folder of an output isn't there or can't be written to: before the work, not after.
void check_outputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs, bool force);

/// The files a run writes: all appear once everything is written, or none does. Signals wait from the first file on.
class OutputFiles {
 public:
  /// Hands `fill` a stream for the file, or standard output for "-", where what is written is on its way at once.
  /// \throw io::WriteError that names the file.
  void write(const std::string& path, const std::function<void(std::ostream&)>& fill);

  /// Puts all files in their places. \throw io::WriteError; Interrupted if a signal is waiting.
  void commit();

 private:
  // The files go before signals act again.
  std::optional<SignalsWait> signals_wait_;
  std::vector<std::unique_ptr<io::OutputFile>> files_;
};

/// Writes text to standard output. \throw io::WriteError when it fails, as on a full disk or a closed pipe.
void print(const std::string& text);

}  // namespace whittle::app
