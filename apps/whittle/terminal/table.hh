#pragma once

#include <string>
#include <vector>

namespace whittle::app {

/// Rows of cells in columns with two spaces between them. The first column is left-aligned, the others are
/// right-aligned. An empty row is an empty line.
class Table {
 public:
  void add(std::vector<std::string> row);
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// Four significant digits: "0.01234", "1.234e-05".
std::string significant(double x);
/// A share in [0, 1] with four significant digits: "1.234 %".
std::string percent(double share);
/// "0.034 s"
std::string seconds_text(double seconds);
std::string yes_no(bool value);

}  // namespace whittle::app
