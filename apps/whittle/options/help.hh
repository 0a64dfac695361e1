#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace whittle::app {

/// Help in lines of at most 100 columns. An option is two columns: "  -r, --ratio R", and from column 30 on (or on the
/// next line) what it does, with "(default: …)" or "(required)" at the end.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace whittle::app
