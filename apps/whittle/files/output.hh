#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "terminal/interruption.hh"
#include "whittle/io/output_files.hh"

namespace whittle::app {

inline constexpr char standard_output_name[] = "standard output";

/// A file to be written, and the option that names it.
struct Output {
  std::string option;  ///< "--output"
  std::string path;
};

/// A path with each `word` in it, such as "{faces}", replaced.
std::string replaced(std::string path, const std::string& word, const std::string& text);

/// \param output may have "{i}" in it, which stands for a number \param is_given whether `option`, which makes several
/// files, is \throw UsageError if only one of both is so
void check_number(const std::string& output, const std::string& option, bool is_given);
/// The path of file i of n. Numbers have as many digits as the last one.
std::string numbered(const std::string& path, std::size_t i, std::size_t n);

/// Checks the outputs of a run before its work starts.
/// \throw UsageError if two outputs are the same file or both standard output, or if an output is one of the `inputs`
///        and `force` isn't set.
/// \throw io::WriteError if the folder of an output doesn't exist or can't be written to, or if an output is there,
///        write-protected, and `force` isn't set.
void check_outputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs, bool force);

/// The files that a run writes. All appear once everything is written, or none does. From the first file on, signals
/// stay pending (`SignalsWait`).
class OutputFiles : public io::OutputFiles {
 public:
  /// \param force whether files that are write-protected, or that inputs need, may be replaced
  explicit OutputFiles(bool force) : force_(force) {}
  ~OutputFiles() override { discard(); }  // before signals act again

  void protect(const std::vector<std::filesystem::path>& files) override;

  /// Calls `fill` with a stream for the file. For "-" it is standard output, where everything is written at once and
  /// can't be undone.
  /// \throw io::WriteError that names the file, also if it is write-protected. UsageError if an input needs it.
  ///        io::OutputConflict if it is among the files already.
  void write(const std::string& path, const std::function<void(std::ostream&)>& fill) override;

  /// Renames all files to their final names. \throw io::WriteError; Interrupted if a signal is pending.
  void commit() override;

 private:
  std::optional<SignalsWait> signals_wait_;
  bool force_;
};

/// Writes text to standard output. \throw io::WriteError when it fails, as on a full disk or a closed pipe.
void print(const std::string& text);

}  // namespace whittle::app
