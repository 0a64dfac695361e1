#include <cmath>
#include <stdexcept>
#include <vector>

#include "gl/context.hh"
#include "gl/program.hh"
#include "gl/scene_buffers.hh"
#include "gl/shaders.hh"
#include "image/resolve.hh"
#include "whittle/render/draw.hh"

namespace whittle::render {

namespace {

/// Samples along a side of a pixel.
int sample_grid_of(const DrawOptions& options) {
  const int grid = static_cast<int>(std::lround(std::sqrt(std::max(options.samples, 0))));
  if (options.size < 1 || options.size > 4096) throw std::invalid_argument("a picture's size must be in [1, 4096]");
  if (options.samples < 1 || options.samples > 64 || grid * grid != options.samples) {
    throw std::invalid_argument("samples a pixel must be a square number in [1, 64]");
  }
  if (options.size * grid > 8192) throw std::invalid_argument("a picture has too many samples: size · √samples > 8192");
  return grid;
}

/// The matrix from the frame's unit to OpenGL's cube. Depths up to twice the sphere's radius are seen.
Eigen::Matrix4f clip_matrix(const View& view, const Sphere& frame) {
  Eigen::Matrix3d axes;
  axes << view.up.cross(view.to_eye).transpose() * view_fill, view.up.transpose() * view_fill,
      view.to_eye.transpose() * -0.5;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = axes * (frame.radius / view.sphere.radius);
  matrix.topRightCorner<3, 1>() = axes * ((frame.center - view.sphere.center) / view.sphere.radius);
  return matrix.cast<float>();
}

}  // namespace

class Renderer::State {
 public:
  State(const Scene& scene, const Sphere& frame, const DrawOptions& options)
      : frame_(frame), grid_(sample_grid_of(options)), size_(options.size) {
    const GlContext::Use use(context_);
    program_ = make_program(gl(), vertex_shader, fragment_shader);
    make_framebuffer(gl(), size_ * grid_, size_ * grid_);
    buffers_ = std::make_unique<SceneBuffers>(gl(), scene_arrays(scene, frame));
    check_errors(gl());
  }

  Picture draw(const View& view) {
    const GlContext::Use use(context_);
    begin_picture(view);
    buffers_->draw(program_, view.to_eye.cast<float>());
    const int n_samples = size_ * grid_;
    std::vector<float> samples(4 * static_cast<std::size_t>(n_samples) * static_cast<std::size_t>(n_samples));
    gl().read_pixels(0, 0, n_samples, n_samples, GL_RGBA, GL_FLOAT, samples.data());
    check_errors(gl());
    const auto size = static_cast<std::size_t>(size_);
    return resolve(samples, {size, size, static_cast<std::size_t>(grid_)}, SampleColors::linear);
  }

 private:
  const GlFunctions& gl() const { return context_.gl(); }

  void begin_picture(const View& view) const {
    gl().use_program(program_);
    gl().enable(GL_DEPTH_TEST);
    gl().depth_mask(GL_TRUE);
    gl().clear_color(background_light(), background_light(), background_light(), 0);
    gl().clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const Eigen::Matrix4f matrix = clip_matrix(view, frame_);
    gl().uniform_matrix_4fv(gl().get_uniform_location(program_, "to_clip"), 1, GL_FALSE, matrix.data());
    set_direction("to_eye", view.to_eye);
    set_direction("up", view.up);
  }

  void set_direction(const char* name, const Vec3& direction) const {
    const Eigen::Vector3f d = direction.cast<float>();
    gl().uniform_3f(gl().get_uniform_location(program_, name), d[0], d[1], d[2]);
  }

  GlContext context_;
  Sphere frame_;
  int grid_;  ///< samples along a side of a pixel
  int size_;
  unsigned program_ = 0;
  std::unique_ptr<SceneBuffers> buffers_;
};

Renderer::Renderer(const Scene& scene, const Sphere& frame, const DrawOptions& options)
    : state_(std::make_unique<State>(scene, frame, options)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Picture Renderer::draw(const View& view) { return state_->draw(view); }

Picture draw(const Scene& scene, const View& view, const DrawOptions& options) {
  return Renderer(scene, view.sphere, options).draw(view);
}

std::optional<std::string> why_nothing_can_be_drawn() {
  try {
    const GlContext context;
    return std::nullopt;
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

}  // namespace whittle::render
