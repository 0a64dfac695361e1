#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "program/failure.hh"
#include "program/program.hh"
#include "support/temporary_folder.hh"

namespace whittle::test {

/// Whether the program was built with the page of `report`.
inline bool has_page(const TemporaryFolder& folder) {
  const Outcome outcome = whittle({"report", data_file("cubes.obj"), "-o", folder / "try.html", "--quiet"});
  return outcome.exit_code == 0 || outcome.err.find("built without the page") == std::string::npos;
}

/// Whether the program can draw on this machine.
inline bool has_pictures(const TemporaryFolder& folder) {
  const Outcome outcome = whittle({"measure", data_file("cubes.obj"), data_file("cubes.obj"), "--samples", "1000",
                                   "--render", "1", "--json", folder / "try.json", "--quiet"});
  return outcome.exit_code == 0;
}

/// As long as this is there, no programs are found but one that opens files: it writes down which.
class StandInPrograms {
 public:
  explicit StandInPrograms(const TemporaryFolder& folder) : path_(std::getenv("PATH")) {
    std::filesystem::create_directory(folder / "bin");
    write_program(folder / "bin/xdg-open",
                  "#!/bin/sh\nprintf '%s' \"$1\" >'" + std::string(folder / "opened.txt") + "'\n");
    ::setenv("PATH", std::string(folder / "bin").c_str(), 1);
  }
  ~StandInPrograms() { ::setenv("PATH", path_.c_str(), 1); }
  StandInPrograms(const StandInPrograms&) = delete;
  StandInPrograms& operator=(const StandInPrograms&) = delete;

 private:
  static void write_program(const std::string& path, const std::string& text) {
    write_text(path, text);
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  }

  std::string path_;
};

}  // namespace whittle::test
