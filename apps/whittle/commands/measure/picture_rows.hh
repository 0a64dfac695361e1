#pragma once

#include <string>

#include "files/report.hh"
#include "pictures/compare_pictures.hh"

namespace whittle::app {

/// {"views", "psnr", "flip", "warnings"}
Json pictures_json(const PictureErrors& errors);

/// The same for people.
std::string pictures_table(const PictureErrors& errors);

}  // namespace whittle::app
