#pragma once

#include <string>

#include "commands/page/report_options.hh"

namespace whittle::app {

/// Draws a page with an installed Chromium, without a window.
/// \param view how the page is set up, as --view has it
/// \return the bytes of a PNG file
/// \throw std::runtime_error if there is no Chromium, or if it doesn't draw the page
std::string picture_of(const std::string& page, const std::string& view, const PictureSize& size);

/// Opens a file with the program that the desktop has for it. \return whether there is such a program
bool open_on_desktop(const std::string& path);

}  // namespace whittle::app
