#include "gl/mark_buffers.hh"

#include "gl/vertex_format.hh"
#include "whittle/render/srgb.hh"

namespace whittle::render {

namespace {

SceneVertex vertex_at_place(const Vec3& place, const Sphere& frame, const Rgb& color, double opacity) {
  const Eigen::Vector3f position = ((place - frame.center) / frame.radius).cast<float>();
  return {{position[0], position[1], position[2]},
          {0, 0, 0},
          {0, 0},
          {linear_of_srgb(color[0]), linear_of_srgb(color[1]), linear_of_srgb(color[2]), static_cast<float>(opacity)}};
}

}  // namespace

MarkBuffers::MarkBuffers(const GlFunctions& gl, GLenum mode, const std::vector<SceneVertex>& vertices)
    : gl_(gl), mode_(mode), n_vertices_(static_cast<GLsizei>(vertices.size())) {
  gl_.gen_vertex_arrays(1, &vertex_array_);
  gl_.bind_vertex_array(vertex_array_);
  make_buffer(gl_, GL_ARRAY_BUFFER);
  fill_buffer(gl_, GL_ARRAY_BUFFER, vertices, GL_STATIC_DRAW);
  set_vertex_format(gl_);
}

void MarkBuffers::draw() const {
  gl_.bind_vertex_array(vertex_array_);
  gl_.draw_arrays(mode_, 0, n_vertices_);
}

std::vector<SceneVertex> vertices_of(const Lines& lines, const Sphere& frame) {
  std::vector<SceneVertex> vertices;
  vertices.reserve(lines.ends.size());
  for (const Vec3& end : lines.ends) vertices.push_back(vertex_at_place(end, frame, lines.color, lines.opacity));
  return vertices;
}

std::vector<SceneVertex> vertices_of(const Dots& dots, const Sphere& frame) {
  std::vector<SceneVertex> vertices;
  vertices.reserve(dots.places.size());
  for (std::size_t i = 0; i < dots.places.size(); ++i) {
    vertices.push_back(vertex_at_place(dots.places[i], frame, dots.colors[dots.colors.size() == 1 ? 0 : i], 1));
  }
  return vertices;
}

}  // namespace whittle::render
