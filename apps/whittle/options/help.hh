#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace whittle::app {

/// Help in lines of at most 100 columns. The name of an option is on the left: "  -r, --ratio R". The description
/// starts at column 30, on the next line if the name is too long. It ends with "(default: …)" or "(required)".
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace whittle::app
