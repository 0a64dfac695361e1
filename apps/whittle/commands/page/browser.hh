#pragma once

#include <memory>
#include <string>

#include "commands/page/report_options.hh"

namespace whittle::app {

/// A page in an installed Chromium that has no window.
class PageView {
 public:
  /// \param settings of the page, as --view has them
  /// \throw std::runtime_error if there is no Chromium, or if it doesn't show the page
  PageView(const std::string& page, const std::string& settings, const PictureSize& size);
  ~PageView();
  PageView(const PageView&) = delete;
  PageView& operator=(const PageView&) = delete;

  /// Goes to a place in the page's recording. \param place share of the contractions, [0, 1]
  void go_to(double place);
  /// What is shown, as the bytes of a file. \param format "png" or "webp"
  std::string picture(const std::string& format);

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

/// Opens a file with the program that the desktop has for it. \return whether there is such a program
bool open_on_desktop(const std::string& path);

}  // namespace whittle::app
