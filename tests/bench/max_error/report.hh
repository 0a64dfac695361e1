#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bench/max_error/row.hh"

namespace whittle::bench {

/// Rows of one mesh as a table to read; columns without a number are left out.
/// \param contenders names, in the order of `Row::contenders`
std::string to_text(const std::vector<Row>& rows, const std::vector<std::string>& contenders);

/// A comma-separated file with a header line. Rows are in the file as soon as they are added.
class RowsCsv {
 public:
  /// \throw std::runtime_error if it can't be written
  RowsCsv(std::filesystem::path path, std::vector<std::string> contenders, std::string commit);
  void add(const Row& row);

 private:
  void write(const std::vector<std::string>& cells);

  std::filesystem::path path_;
  std::vector<std::string> contenders_;
  std::string commit_;
  std::ofstream file_;
};

/// A mark, and what was measured.
struct Mark {
  std::string what;
  std::string measured;
  std::string wanted;
  bool is_met = false;
};
/// Those that the rows say something about.
std::vector<Mark> marks_of(const std::vector<Row>& rows, const std::vector<std::string>& contenders);
std::string to_text(const std::vector<Mark>& marks);

}  // namespace whittle::bench
