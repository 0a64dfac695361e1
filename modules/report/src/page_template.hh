#pragma once

#include <string>

namespace whittle::report {

/// The page without its content: the viewer, as viewer/build.mjs puts it together. Where the content goes there are
/// words in doubled braces, such as {{title}}.
std::string page_template();

}  // namespace whittle::report
