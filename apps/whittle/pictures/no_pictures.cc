// In place of bake_scene.cc, compare_pictures.cc and draw_meshes.cc, in a program that is built without
// whittle::render.
#include <stdexcept>

#include "pictures/bake_scene.hh"
#include "pictures/compare_pictures.hh"
#include "pictures/draw_meshes.hh"

namespace whittle::app {

void require_pictures() {
  throw std::runtime_error("this whittle was built without pictures: that takes libpng, libjpeg, and headers of EGL");
}

PictureErrors compare_pictures(const Scene&, const Scene&, const PictureOptions&) {
  throw std::logic_error("no pictures");
}

BakedScene bake_scene(const Scene&, const Scene&, const BakeSettings&) { throw std::logic_error("no pictures"); }

RgbPicture draw_meshes(ShownMeshes&, const PictureView&, const PictureSize&, unsigned, std::vector<std::string>&) {
  throw std::logic_error("no pictures");
}

std::string png_file(const RgbPicture&) { throw std::logic_error("no pictures"); }

}  // namespace whittle::app
