#include "whittle/render/figure.hh"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "gl/context.hh"
#include "gl/figure_shaders.hh"
#include "gl/mark_buffers.hh"
#include "gl/program.hh"
#include "gl/scene_buffers.hh"
#include "gl/shaders.hh"
#include "image/resolve.hh"
#include "whittle/render/srgb.hh"

namespace whittle::render {

namespace {

constexpr std::size_t samples_aside = 2;  ///< of a pixel
constexpr std::size_t tile_size = 1024;   ///< pixels: the samples of a tile take 64 MB

Sphere sphere_around(const Figure& figure) {
  Scene scene;
  for (const Layer& layer : figure.layers) scene.parts.push_back(layer.part);
  return bounding_sphere(scene);
}

/// A camera in the frame's unit.
class CameraInFrame {
 public:
  CameraInFrame(const Camera& camera, const Sphere& frame, const Canvas& canvas)
      : eye_((camera.eye - frame.center) / frame.radius),
        to_eye_((camera.eye - camera.target).normalized()),
        right_(camera.up.cross(to_eye_).normalized()),
        up_(to_eye_.cross(right_)),
        height_(1 / std::tan(camera.height_angle_deg * std::numbers::pi / 360)),
        width_(height_ * static_cast<double>(canvas.height) / static_cast<double>(canvas.width)) {}

  const Vec3& eye() const { return eye_; }
  const Vec3& to_eye() const { return to_eye_; }
  const Vec3& right() const { return right_; }
  const Vec3& up() const { return up_; }

  /// To OpenGL's cube.
  Eigen::Matrix4d clip_matrix() const {
    const double margin = 1.001;
    const double farthest = eye_.norm() + margin;
    const double nearest = std::max(eye_.norm() - margin, farthest / 10'000);
    Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
    turn.topLeftCorner<3, 3>() << right_.transpose(), up_.transpose(), to_eye_.transpose();
    turn.topRightCorner<3, 1>() = turn.topLeftCorner<3, 3>() * -eye_;
    Eigen::Matrix4d project = Eigen::Matrix4d::Zero();
    project(0, 0) = width_;
    project(1, 1) = height_;
    project(2, 2) = (nearest + farthest) / (nearest - farthest);
    project(2, 3) = 2 * nearest * farthest / (nearest - farthest);
    project(3, 2) = -1;
    return project * turn;
  }

 private:
  Vec3 eye_;
  Vec3 to_eye_;
  Vec3 right_;
  Vec3 up_;
  double height_;  ///< cotangent of half the angle
  double width_;
};

/// A part of a picture, in pixels from its upper left corner.
struct Tile {
  std::size_t left, top, width, height;
};

/// From the cube of the picture to that of the tile.
Eigen::Matrix4d tile_matrix(const Tile& tile, const Canvas& canvas) {
  const auto width = static_cast<double>(canvas.width);
  const auto height = static_cast<double>(canvas.height);
  const auto tile_width = static_cast<double>(tile.width);
  const auto tile_height = static_cast<double>(tile.height);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix(0, 0) = width / tile_width;
  matrix(0, 3) = (width - 2 * static_cast<double>(tile.left)) / tile_width - 1;
  matrix(1, 1) = height / tile_height;
  matrix(1, 3) = 1 - (height - 2 * static_cast<double>(tile.top)) / tile_height;
  return matrix;
}

void check(const Figure& figure, const Canvas& canvas) {
  constexpr std::size_t most = 16384;
  if (canvas.width < 1 || canvas.height < 1 || canvas.width > most || canvas.height > most) {
    throw std::invalid_argument("a picture's sides must be in [1, 16384]");
  }
  for (const Lines& lines : figure.lines) {
    if (lines.ends.size() % 2 != 0) throw std::invalid_argument("a line to draw has one end");
  }
  for (const Dots& dots : figure.dots) {
    if (dots.colors.size() != 1 && dots.colors.size() != dots.places.size()) {
      throw std::invalid_argument("dots to draw have too few colours, or too many");
    }
  }
}

/// A figure in OpenGL's memory.
class FigureDrawing {
 public:
  FigureDrawing(const Figure& figure, const Camera& camera, const Canvas& canvas)
      : use_(context_),
        figure_(figure),
        canvas_(canvas),
        frame_(sphere_around(figure)),
        camera_(camera, frame_, canvas),
        program_(make_program(gl(), vertex_shader, figure_fragment_shader)) {
    const auto samples_of = [](std::size_t pixels) {
      return static_cast<int>(std::min(pixels, tile_size) * samples_aside);
    };
    make_framebuffer(gl(), samples_of(canvas.width), samples_of(canvas.height));
    for (const Layer& layer : figure.layers) {
      layers_.push_back(std::make_unique<SceneBuffers>(gl(), scene_arrays({{layer.part}, figure.images}, frame_)));
    }
    for (const Lines& lines : figure.lines) lines_.emplace_back(gl(), GL_LINES, vertices_of(lines, frame_));
    for (const Dots& dots : figure.dots) dots_.emplace_back(gl(), GL_POINTS, vertices_of(dots, frame_));
    check_errors(gl());
  }

  Picture draw() {
    Picture picture{canvas_.width, canvas_.height, std::vector<Rgb>(canvas_.width * canvas_.height), {}};
    for (std::size_t top = 0; top < canvas_.height; top += tile_size) {
      for (std::size_t left = 0; left < canvas_.width; left += tile_size) {
        const Tile tile{left, top, std::min(tile_size, canvas_.width - left),
                        std::min(tile_size, canvas_.height - top)};
        const Picture part = draw(tile);
        for (std::size_t y = 0; y < tile.height; ++y) {
          std::copy_n(part.pixels.begin() + static_cast<std::ptrdiff_t>(y * tile.width), tile.width,
                      picture.pixels.begin() + static_cast<std::ptrdiff_t>((top + y) * canvas_.width + left));
        }
      }
    }
    return picture;
  }

 private:
  const GlFunctions& gl() const { return context_.gl(); }

  Picture draw(const Tile& tile) {
    begin(tile);
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      shade_as(figure_.layers[i]);
      layers_[i]->draw_solid_faces(program_);
    }
    draw_marks();
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      shade_as(figure_.layers[i]);
      layers_[i]->draw_blend_faces(program_, camera_.to_eye().cast<float>());
    }
    const auto width = static_cast<int>(tile.width * samples_aside);
    const auto height = static_cast<int>(tile.height * samples_aside);
    std::vector<float> samples(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    gl().read_pixels(0, 0, width, height, GL_RGBA, GL_FLOAT, samples.data());
    check_errors(gl());
    return resolve(samples, {tile.width, tile.height, samples_aside}, SampleColors::srgb);
  }

  void begin(const Tile& tile) const {
    gl().viewport(0, 0, static_cast<int>(tile.width * samples_aside), static_cast<int>(tile.height * samples_aside));
    gl().use_program(program_);
    gl().enable(GL_DEPTH_TEST);
    gl().enable(GL_POLYGON_OFFSET_FILL);  // lines lie on faces
    gl().polygon_offset(1, 1);
    gl().enable(GL_PROGRAM_POINT_SIZE);
    gl().depth_mask(GL_TRUE);
    gl().depth_func(GL_LEQUAL);
    const auto& [red, green, blue] = canvas_.background;
    gl().clear_color(red, green, blue, 0);
    gl().clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const Eigen::Matrix4f matrix = (tile_matrix(tile, canvas_) * camera_.clip_matrix()).cast<float>();
    gl().uniform_matrix_4fv(location("to_clip"), 1, GL_FALSE, matrix.data());
    set_vector("eye", camera_.eye());
    set_vector("right", camera_.right());
    set_vector("up", camera_.up());
    set_vector("to_eye", camera_.to_eye());
  }

  void shade_as(const Layer& layer) const {
    gl().uniform_1i(location("shade"), static_cast<GLint>(layer.shade));
    gl().uniform_1i(location("has_back"), layer.back ? 1 : 0);
    if (layer.back) gl().uniform_3f(location("back"), (*layer.back)[0], (*layer.back)[1], (*layer.back)[2]);
  }

  void draw_marks() {
    constexpr GLint no_shade = 3;
    gl().uniform_1i(location("shade"), no_shade);
    gl().uniform_1i(location("has_back"), 0);
    gl().uniform_1i(location("alpha_mode"), static_cast<GLint>(Alpha::blend));
    gl().uniform_4f(location("base_color"), 1, 1, 1, 1);
    gl().bind_texture(GL_TEXTURE_2D, white());
    gl().enable(GL_BLEND);
    gl().blend_func_separate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (std::size_t i = 0; i < dots_.size(); ++i) {
      gl().uniform_1f(location("dot_size"), static_cast<float>(figure_.dots[i].size * samples_aside));
      dots_[i].draw();
    }
    for (const bool are_hidden : {true, false}) {
      (are_hidden ? gl().enable : gl().disable)(GL_DEPTH_TEST);
      for (std::size_t i = 0; i < lines_.size(); ++i) {
        if (figure_.lines[i].are_hidden == are_hidden) lines_[i].draw();
      }
    }
    gl().enable(GL_DEPTH_TEST);
  }

  /// A texture of one white pixel.
  unsigned white() {
    if (white_ == 0) {
      gl().gen_textures(1, &white_);
      gl().bind_texture(GL_TEXTURE_2D, white_);
      const std::array<std::uint8_t, 4> pixel{255, 255, 255, 255};
      gl().tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
      gl().tex_parameter_i(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    }
    return white_;
  }

  GLint location(const char* name) const { return gl().get_uniform_location(program_, name); }
  void set_vector(const char* name, const Vec3& vector) const {
    const Eigen::Vector3f v = vector.cast<float>();
    gl().uniform_3f(location(name), v[0], v[1], v[2]);
  }

  GlContext context_;
  GlContext::Use use_;
  const Figure& figure_;
  const Canvas& canvas_;
  Sphere frame_;
  CameraInFrame camera_;
  unsigned program_;
  std::vector<std::unique_ptr<SceneBuffers>> layers_;
  std::vector<MarkBuffers> lines_;
  std::vector<MarkBuffers> dots_;
  GLuint white_ = 0;
};

}  // namespace

Material plain_material(const Rgb& color, double opacity) {
  Material material;
  for (std::size_t i = 0; i < 3; ++i) material.base_color[i] = linear_of_srgb(static_cast<double>(color[i]));
  material.base_color[3] = opacity;
  material.alpha_mode = opacity < 1 ? Alpha::blend : Alpha::opaque;
  material.double_sided = true;
  return material;
}

Picture draw_figure(const Figure& figure, const Camera& camera, const Canvas& canvas) {
  check(figure, canvas);
  return FigureDrawing(figure, camera, canvas).draw();
}

}  // namespace whittle::render
