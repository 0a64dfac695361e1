#pragma once

#include <string>
#include <string_view>

namespace whittle::app {

/// The settings of a page in the form of its address.
/// \param text "layout=over,colour=error"
/// \return "layout=over&colour=error"
/// \throw std::invalid_argument for an unknown name or value; the message lists the known ones
std::string parse_page_settings(std::string_view text);

}  // namespace whittle::app
