#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "bench/answer.hh"
#include "bench/processes/clock.hh"

namespace whittle::bench {

/// One peer on one mesh.
struct Row {
  std::string peer;
  std::string mesh;
  std::size_t n_faces = 0;   ///< of the input
  std::size_t n_wanted = 0;  ///< of the result
  std::optional<Answer> answer;
  std::vector<double> ms;  ///< one number per round; empty unless the answer counts
  std::optional<double> ratio_to_meshoptimizer;
  std::optional<double> ratio_to_whittle;
  std::optional<double> peak_bytes_per_face;  ///< per face of the input
  std::string problem;                        ///< why there are no times
};

/// What all rows of a run share.
struct Setting {
  Clock clock = Clock::wall;
  std::string compiler;
  std::string commit;
};

/// The rows of one mesh, as a table to read.
std::string to_text(const std::vector<Row>& rows);

/// A comma-separated file with a header line. Rows are in the file as soon as they are added.
class CsvFile {
 public:
  /// \throw std::runtime_error if it can't be written
  CsvFile(const std::filesystem::path& path, Setting setting);
  void add(const Row& row);

 private:
  std::filesystem::path path_;
  Setting setting_;
  std::ofstream file_;
};

}  // namespace whittle::bench
