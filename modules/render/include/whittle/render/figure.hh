#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "whittle/render/picture.hh"
#include "whittle/render/scene.hh"

// Pictures for people: surfaces in perspective, with lines and dots on them. `draw.hh` has pictures to measure.

namespace whittle::render {

/// An eye with perspective.
struct Camera {
  Vec3 eye = Vec3::UnitZ();
  Vec3 target = Vec3::Zero();    ///< Is seen in the middle; not the eye.
  Vec3 up = Vec3::UnitY();       ///< Not along the direction to the target.
  double height_angle_deg = 35;  ///< Between the upper and the lower edge of the picture, degrees, (0, 180).
};

/// What light does to the colour of a surface. It comes from the eye, and a little from above.
enum class Shade : std::uint8_t {
  full,    ///< Shadow shows the shape.
  soft,    ///< Less shadow leaves colours apart.
  normals  ///< No light, and no colour: x, y and z of the normal, from −1 to 1, are red, green and blue.
};

/// Faces of one kind.
struct Layer {
  Part part;
  Shade shade = Shade::full;
  std::optional<Rgb> back;  ///< The colour of faces that are seen from behind, sRGB. Without: as in front.
};

/// Lines as narrow as a sample. Faces hide them, if they are told to.
struct Lines {
  std::vector<Vec3> ends;  ///< Two a line.
  Rgb color{};             ///< sRGB
  double opacity = 1;
  bool are_hidden = true;
};

/// Squares.
struct Dots {
  std::vector<Vec3> places;
  std::vector<Rgb> colors;  ///< sRGB; one each, or one for all.
  double size = 1;          ///< pixels
};

/// What a picture shows. Faces that blend are drawn last, in the order of the layers.
struct Figure {
  std::vector<Layer> layers;
  std::vector<Lines> lines;
  std::vector<Dots> dots;
  std::map<std::shared_ptr<const Image>, Pixels> images{};  ///< As `Scene::images`.
};

struct Canvas {
  std::size_t width = 1280;  ///< pixels, [1, 16384]
  std::size_t height = 720;  ///< pixels, [1, 16384]
  Rgb background{1, 1, 1};   ///< sRGB
};

/// A material of one colour. \param color sRGB
Material plain_material(const Rgb& color, double opacity = 1);

/// Draws a figure, with four samples a pixel. Colours are blended as they are encoded.
/// \throw std::invalid_argument if the canvas has no size or too great a one, or as `Renderer`
/// \throw std::runtime_error as `Renderer`
Picture draw_figure(const Figure& figure, const Camera& camera, const Canvas& canvas);

}  // namespace whittle::render
