#include "terminal/progress_bar.hh"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string_view>
#include <utility>

#include "system/system.hh"
#include "terminal/interruption.hh"

namespace whittle::app {
namespace {

constexpr std::size_t bar_width = 30;
constexpr auto redraw_interval = std::chrono::milliseconds(100);

}  // namespace

ProgressBar::ProgressBar(const Talk& talk, std::string what)
    : what_(std::move(what)), shown_(talk.shows_progress()), colored_(talk.is_colored()) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::clear() {
  if (drawn_width_ == 0) return;
  std::cerr << '\r' + std::string(drawn_width_, ' ') + '\r' << std::flush;
  drawn_width_ = 0;
}

void ProgressBar::update(double fraction, const std::string& note) {
  if (!shown_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + redraw_interval;

  fraction = std::clamp(fraction, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(std::floor(fraction * bar_width));
  const std::string before = what_ + " [";
  const std::string percent = std::to_string(static_cast<int>(std::floor(100 * fraction)));
  const std::string after = "] " + std::string(3 - percent.size(), ' ') + percent + " %  " + note;
  const std::size_t width = before.size() + bar_width + after.size();
  clear();
  // A line that wraps can't be erased.
  if (width >= terminal_width()) return;
  const std::string full(filled, '#');
  const std::string empty(bar_width - filled, '.');
  std::cerr << before + (colored_ ? in_color(Color::green, full) : full) + empty + after << std::flush;
  drawn_width_ = width;
}

ProgressCallback part_of(ProgressBar& bar, double from, double to) {
  return [&bar, from, to](const TaskProgress& progress) {
    bar.update(from + progress.fraction * (to - from), std::string(progress.stage));
    return !SignalsWait::pending();
  };
}

}  // namespace whittle::app
