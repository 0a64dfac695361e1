#pragma once

#include <map>
#include <string>
#include <string_view>

namespace whittle::app {

/// Names and values of the page's controls.
/// \param text "layout=over,colour=error,plain" \return {"layout": "over", "colour": "error", "plain": ""}
/// \throw std::invalid_argument for an unknown name or value; the message lists the known ones
std::map<std::string, std::string> parse_page_settings(std::string_view text);

}  // namespace whittle::app
