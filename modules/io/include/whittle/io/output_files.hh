#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "whittle/io/output_file.hh"

namespace whittle::io {

/// Files that appear together: all of them once everything is written (`commit`), or none.
class OutputFiles {
 public:
  OutputFiles() = default;
  virtual ~OutputFiles() { discard(); }
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Names files that are not to be replaced: those that inputs need, such as buffers and textures.
  virtual void protect(const std::vector<std::filesystem::path>& files);

  /// Calls `fill` with a stream for the file, in binary mode.
  /// \throw WriteError that names the file, also if it is protected; OutputConflict if it is among the files already
  virtual void write(const std::string& path, const std::function<void(std::ostream&)>& fill);
  /// Renames all files to their final names. \throw WriteError
  virtual void commit();

  /// Writes a file that several outputs may need, and its folders. The second time, the same bytes are not written
  /// again. \return whether the file is new \throw as `write`
  bool write_with_folders(const std::string& path, const std::string& bytes);

 protected:
  bool is_protected(const std::string& path) const;
  /// Forgets the files that are not committed, and removes the folders that were made for them.
  void discard();

 private:
  void make_folders(const std::filesystem::path& folder);

  std::vector<std::unique_ptr<OutputFile>> files_;
  std::vector<std::filesystem::path> new_folders_;  ///< inner ones first
  std::set<std::string> written_;                   ///< identities
  std::map<std::string, std::size_t> shared_;       ///< hashes of what `write_with_folders` has written, by identity
  std::set<std::string> protected_;                 ///< identities
};

/// A key that is equal for two names of one file. Files that don't exist yet have their names.
std::string file_identity(const std::string& path);

/// Calls `fill` with a stream, and flushes it.
/// \param name of the file, for messages
/// \throw WriteError with the name of the file if either fails
void fill_checked(std::ostream& stream, const std::string& name, const std::function<void(std::ostream&)>& fill);

}  // namespace whittle::io
