#pragma once

#include <string>

namespace whittle::app {

/// Opens a file with the program that the desktop has for it, which prints nothing. \return whether there is such a
/// program
bool open_on_desktop(const std::string& path);

}  // namespace whittle::app
