#pragma once

#include <string_view>

#include "terminal/color.hh"

namespace whittle::app {

/// Amount of messages on stderr.
enum class Volume {
  quiet,   ///< errors only
  normal,  ///< also warnings, repairs, a summary; a progress bar on a terminal
  verbose  ///< also how each step went
};

/// Prints lines on stderr. Each begins with "whittle: ". In colour, that is red before an error, and the word
/// "warning:" is yellow.
class Talk {
 public:
  explicit Talk(Volume volume, ColorMode color = ColorMode::automatic)
      : volume_(volume), colored_(app::is_colored(color)) {}

  void error(std::string_view line) const;
  void warning(std::string_view line) const;
  void say(std::string_view line) const;
  void detail(std::string_view line) const;

  bool is_verbose() const { return volume_ == Volume::verbose; }
  bool is_colored() const { return colored_; }
  /// True if stderr is a terminal that isn't dumb (`TERM`), unless quiet.
  bool shows_progress() const;

 private:
  Volume volume_;
  bool colored_;
};

}  // namespace whittle::app
