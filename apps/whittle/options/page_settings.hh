#pragma once

#include <string>
#include <string_view>

namespace whittle::app {

/// Settings of a page, as they stand in its address.
/// \param text "layout=over,colour=error" \return "layout=over&colour=error"
/// \throw std::invalid_argument for a name or a value that the page doesn't have; it lists those that it has
std::string parse_page_settings(std::string_view text);

}  // namespace whittle::app
