#include "gl/scene_buffers.hh"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "gl/vertex_format.hh"

namespace whittle::render {

namespace {

GLint gl_wrap(Wrap wrap) {
  switch (wrap) {
    case Wrap::mirrored_repeat:
      return GL_MIRRORED_REPEAT;
    case Wrap::clamp_to_edge:
      return GL_CLAMP_TO_EDGE;
    case Wrap::repeat:
      break;
  }
  return GL_REPEAT;
}

Pixels white_pixel() { return {1, 1, {255, 255, 255, 255}}; }

}  // namespace

SceneBuffers::SceneBuffers(const GlFunctions& gl, SceneArrays arrays) : gl_(gl), arrays_(std::move(arrays)) {
  white_ = upload(white_pixel(), {});
  texture_of_batch_.reserve(arrays_.batches.size());
  for (const Batch& batch : arrays_.batches) texture_of_batch_.push_back(texture_of(batch));
  upload_arrays();
}

void SceneBuffers::upload_arrays() {
  GLuint vertex_arrays[2] = {};
  gl_.gen_vertex_arrays(2, vertex_arrays);
  solid_vertex_array_ = vertex_arrays[0];
  blend_vertex_array_ = vertex_arrays[1];
  gl_.bind_vertex_array(solid_vertex_array_);
  const unsigned vertices = make_buffer(gl_, GL_ARRAY_BUFFER);
  fill_buffer(gl_, GL_ARRAY_BUFFER, arrays_.vertices, GL_STATIC_DRAW);
  set_vertex_format(gl_);
  make_buffer(gl_, GL_ELEMENT_ARRAY_BUFFER);
  fill_buffer(gl_, GL_ELEMENT_ARRAY_BUFFER, arrays_.indices, GL_STATIC_DRAW);

  gl_.bind_vertex_array(blend_vertex_array_);
  gl_.bind_buffer(GL_ARRAY_BUFFER, vertices);
  set_vertex_format(gl_);
  blend_indices_ = make_buffer(gl_, GL_ELEMENT_ARRAY_BUFFER);

  arrays_.indices = {};
  if (arrays_.blend_faces.empty()) arrays_.vertices = {};
}

unsigned SceneBuffers::texture_of(const Batch& batch) {
  if (batch.pixels == nullptr) return white_;
  const std::array<Wrap, 2>& wrap = batch.material.base_color_texture->wrap;
  unsigned& name = textures_[{batch.pixels, wrap}];
  if (name == 0) name = upload(*batch.pixels, wrap);
  return name;
}

unsigned SceneBuffers::upload(const Pixels& pixels, const std::array<Wrap, 2>& wrap) {
  if (pixels.width == 0 || pixels.height == 0 || pixels.width > max_image_size || pixels.height > max_image_size ||
      pixels.rgba.size() != 4 * pixels.width * pixels.height) {
    throw std::invalid_argument("a texture to draw has no pixels, too many, or fewer than its size says");
  }
  GLuint name = 0;
  gl_.gen_textures(1, &name);
  gl_.bind_texture(GL_TEXTURE_2D, name);
  // OpenGL decodes sRGB before it filters, also for the smaller levels.
  gl_.tex_image_2d(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, static_cast<GLsizei>(pixels.width),
                   static_cast<GLsizei>(pixels.height), 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.rgba.data());
  gl_.generate_mipmap(GL_TEXTURE_2D);
  gl_.tex_parameter_i(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl_.tex_parameter_i(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.tex_parameter_i(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, gl_wrap(wrap[0]));
  gl_.tex_parameter_i(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, gl_wrap(wrap[1]));
  return name;
}

void SceneBuffers::draw(unsigned program, const Eigen::Vector3f& to_eye) {
  draw_solid_faces(program);
  draw_blend_faces(program, to_eye);
}

void SceneBuffers::use(unsigned program, std::size_t batch) {
  const Material& material = arrays_.batches[batch].material;
  (material.double_sided ? gl_.disable : gl_.enable)(GL_CULL_FACE);
  gl_.bind_texture(GL_TEXTURE_2D, texture_of_batch_[batch]);
  const std::array<double, 4> color = base_color_factor(material);
  gl_.uniform_4f(gl_.get_uniform_location(program, "base_color"), static_cast<float>(color[0]),
                 static_cast<float>(color[1]), static_cast<float>(color[2]), static_cast<float>(color[3]));
  gl_.uniform_1i(gl_.get_uniform_location(program, "alpha_mode"), static_cast<GLint>(material.alpha_mode));
  gl_.uniform_1f(gl_.get_uniform_location(program, "alpha_cutoff"), static_cast<float>(material.alpha_cutoff));
}

void SceneBuffers::draw_solid_faces(unsigned program) {
  gl_.bind_vertex_array(solid_vertex_array_);
  gl_.disable(GL_BLEND);
  gl_.depth_mask(GL_TRUE);
  for (std::size_t i = 0; i < arrays_.batches.size(); ++i) {
    const Batch& batch = arrays_.batches[i];
    if (batch.n_indices == 0) continue;
    use(program, i);
    gl_.draw_elements(GL_TRIANGLES, static_cast<GLsizei>(batch.n_indices), GL_UNSIGNED_INT,
                      buffer_offset(batch.first_index * sizeof(std::uint32_t)));
  }
}

std::vector<BlendFace> SceneBuffers::from_back_to_front(const Eigen::Vector3f& to_eye) const {
  const std::vector<BlendFace>& faces = arrays_.blend_faces;
  std::vector<float> nearness(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const std::uint32_t v : faces[i].vertices) {
      nearness[i] += to_eye.dot(Eigen::Vector3f::Map(arrays_.vertices[v].position.data()));
    }
  }
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return nearness[a] < nearness[b]; });
  std::vector<BlendFace> sorted;
  sorted.reserve(faces.size());
  for (const std::size_t i : order) sorted.push_back(faces[i]);
  return sorted;
}

void SceneBuffers::draw_blend_faces(unsigned program, const Eigen::Vector3f& to_eye) {
  if (arrays_.blend_faces.empty()) return;
  const std::vector<BlendFace> faces = from_back_to_front(to_eye);
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * faces.size());
  for (const BlendFace& face : faces) indices.insert(indices.end(), face.vertices.begin(), face.vertices.end());
  gl_.bind_vertex_array(blend_vertex_array_);
  gl_.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, blend_indices_);
  fill_buffer(gl_, GL_ELEMENT_ARRAY_BUFFER, indices, GL_STREAM_DRAW);
  gl_.enable(GL_BLEND);
  gl_.blend_func_separate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.depth_mask(GL_FALSE);
  for (std::size_t begin = 0; begin < faces.size();) {
    std::size_t end = begin;
    while (end < faces.size() && faces[end].batch == faces[begin].batch) ++end;
    use(program, faces[begin].batch);
    gl_.draw_elements(GL_TRIANGLES, static_cast<GLsizei>(3 * (end - begin)), GL_UNSIGNED_INT,
                      buffer_offset(3 * begin * sizeof(std::uint32_t)));
    begin = end;
  }
  gl_.depth_mask(GL_TRUE);
}

}  // namespace whittle::render
