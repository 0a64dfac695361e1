// In place of compare_pictures.cc, in a program that is built without whittle::render.
#include <stdexcept>

#include "pictures/compare_pictures.hh"

namespace whittle::app {

void require_pictures() {
  throw std::runtime_error("this whittle was built without pictures: that takes libpng, libjpeg, and headers of EGL");
}

PictureErrors compare_pictures(const Scene&, const Scene&, const PictureOptions&) {
  throw std::logic_error("no pictures");
}

}  // namespace whittle::app
