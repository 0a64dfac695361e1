#include "pictures/draw_meshes.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pictures/meshes/figure_maker.hh"
#include "pictures/meshes/page_camera.hh"
#include "pictures/meshes/panels.hh"
#include "pictures/meshes/run_level.hh"
#include "terminal/table.hh"
#include "whittle/core/text/text.hh"

namespace whittle::app {
namespace {

constexpr render::Rgb color_of_ground = rgb_of(0xF4F4F1);
constexpr render::Rgb color_of_original = rgb_of(0x9DB4C8);
constexpr render::Rgb color_of_results = rgb_of(0xD9B382);

/// The box around all faces.
Box box_around(const IndexedMesh& mesh) {
  Box box;
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) box.extend(mesh.positions[v]);
  }
  return box;
}

/// "51,200 faces"
std::string faces_with_commas(std::size_t n) { return grouped(n) + (n == 1 ? " face" : " faces"); }

/// Where a pane is in a picture, in pixels from the left and the top. `begin` and `end` bound what is seen of it.
struct PaneBox {
  std::size_t left, top, width, height, begin, end;
};

/// As the boxes of panes in view.js.
std::vector<PaneBox> pane_boxes(const PictureView& view, const std::string& layout, const PictureSize& size) {
  const std::size_t width = size.width;
  const std::size_t height = size.height;
  if (layout == "split") {
    const auto at = static_cast<std::size_t>(std::lround(view.split * static_cast<double>(width)));
    return {{0, 0, width, height, 0, at}, {0, 0, width, height, at, width}};
  }
  if (layout != "beside") return {{0, 0, width, height, 0, width}};
  if (height > width) {
    const std::size_t lower = height / 2;
    return {{0, 0, width, height - lower, 0, width}, {0, height - lower, width, lower, 0, width}};
  }
  const std::size_t half = (width + 1) / 2;
  return {{0, 0, half, height, 0, half}, {half, 0, width - half, height, half, width}};
}

void put_pane(RgbPicture& picture, const render::Picture& pane, const PaneBox& box) {
  for (std::size_t y = 0; y < pane.height; ++y) {
    for (std::size_t x = box.begin - box.left; x < box.end - box.left; ++x) {
      for (std::size_t k = 0; k < 3; ++k) {
        picture.bytes[3 * ((box.top + y) * picture.width + box.left + x) + k] =
            static_cast<std::uint8_t>(std::lround(pane.pixels[y * pane.width + x][k] * 255));
      }
    }
  }
}

/// A picture in the making.
class MeshPicture {
 public:
  MeshPicture(ShownMeshes& meshes, const PictureView& view, const PictureSize& size, unsigned threads,
              std::vector<std::string>& warnings)
      : view_(view), size_(size), threads_(threads), warnings_(warnings) {
    original_ = {&meshes.original, color_of_original};
    if (meshes.run) {
      level_ = level_of_run(*meshes.run, view);
      results_.push_back({&*level_, color_of_results, nullptr, true});
    }
    for (const ShownSurface& result : meshes.results) results_.push_back({&result, color_of_results});
    choose_result();
    choose_colour();
    if (view_.shading.empty()) view_.shading = has_normals() ? "file" : "flat";
    for (ShownModel& result : results_) result.other = whole(original_);
    if (compared_ != nullptr) original_.other = whole(*compared_);
    layout_ = result_ == nullptr ? "original" : view.layout;
  }

  RgbPicture draw() {
    RgbPicture picture{size_.width, size_.height, std::vector<std::uint8_t>(3 * size_.width * size_.height)};
    const std::vector<ShownModel> panes = models_of_panes();
    const std::vector<PaneBox> boxes = pane_boxes(view_, layout_, size_);
    for (std::size_t i = 0; i < panes.size(); ++i) {
      const PaneBox& box = boxes[i];
      if (box.begin == box.end) continue;
      put_pane(picture, draw_pane(panes[i], {box.width, box.height, color_of_ground}), box);
    }
    if (layout_ == "split") draw_divider(picture, boxes[1].begin);
    for (std::size_t i = 0; !view_.is_plain && i < panes.size(); ++i) {
      const std::size_t room = layout_ == "split" ? picture.width / 2 : boxes[i].end - boxes[i].begin;
      draw_label(picture, label_of(panes[i], i), {boxes[i].begin, boxes[i].top}, room);
    }
    draw_legend(picture, legend());
    return picture;
  }

 private:
  static const IndexedMesh* whole(const ShownModel& model) {
    return model.surface->note.empty() ? &model.surface->mesh : nullptr;
  }

  void choose_result() {
    const auto first = [this](const auto& is_it) -> const ShownModel* {
      const auto found = std::find_if(results_.begin(), results_.end(), is_it);
      return found == results_.end() ? nullptr : &*found;
    };
    result_ = first([](const ShownModel& model) { return model.has_look(); });
    if (result_ == nullptr && !results_.empty()) result_ = results_.data();
    if (view_.has_level && level_) result_ = results_.data();
    if (view_.result >= 0 && static_cast<std::size_t>(view_.result) < results_.size()) {
      result_ = &results_[static_cast<std::size_t>(view_.result)];
    }
    compared_ = first([](const ShownModel& model) { return model.surface->distances.has_value(); });
    if (compared_ == nullptr) compared_ = result_;
  }

  /// What the meshes look like, if the view doesn't say.
  void choose_colour() {
    colour_ = view_.colour;
    if (!colour_.empty()) return;
    const auto any_has = [this](const char* colour) {
      return original_.has(colour) ||
             std::any_of(results_.begin(), results_.end(), [&](const ShownModel& model) { return model.has(colour); });
    };
    colour_ = any_has("material") ? "material" : any_has("colours") ? "colours" : "none";
  }

  bool has_normals() const {
    return original_.has("normals") ||
           std::any_of(results_.begin(), results_.end(), [](const ShownModel& model) { return model.has("normals"); });
  }

  /// Without what is laid over them.
  std::vector<ShownModel> models_of_panes() const {
    if (layout_ == "beside" || layout_ == "split") return {original_, *result_};
    return {layout_ == "original" ? original_ : *result_};
  }

  std::vector<ShownModel> shown_models() const {
    return layout_ == "over" ? std::vector<ShownModel>{original_, *result_} : models_of_panes();
  }

  render::Picture draw_pane(const ShownModel& model, const render::Canvas& canvas) {
    const auto width = static_cast<double>(canvas.width);
    const auto height = static_cast<double>(canvas.height);
    const render::Camera camera = page_camera(box_around(original_.surface->mesh), view_, width / height);
    const Projection projection(camera, height);
    constexpr double usual_pixels = 3;
    constexpr double usual_area = 2e6;  // of larger pictures, errors are exact at as many places
    const ExactColors exact{[&](const Vec3& a, const Vec3& b) { return projection.seen_length(a, b, width); },
                            usual_pixels * std::max(1.0, std::sqrt(width * height / usual_area)), threads_};
    FigureMaker maker(view_, colour_, top(), exact);
    maker.add(model);
    if (layout_ == "over") maker.add_ghost(original_);
    return render::draw_figure(maker.figure(warnings_), camera, canvas);
  }

  /// Where the scale of errors ends.
  double top() const {
    double max = 0;
    double usual = 0;
    for (const ShownModel* const model : {&original_, result_}) {
      if (model == nullptr) continue;
      const std::optional<ShownModel::Range> range = model->range(colour_);
      if (!range) continue;
      max = std::max(max, range->max);
      usual = std::max(usual, range->usual);
    }
    return view_.top == "usual" ? usual : max * std::stod(view_.top);
  }

  std::string label_of(const ShownModel& model, std::size_t pane) const {
    const auto text = [](const ShownModel& one) {
      const ShownSurface& surface = *one.surface;
      return surface.name + ": " + faces_with_commas(surface.mesh.faces.size()) +
             (surface.note.empty() ? "" : ". " + surface.note);
    };
    const bool is_over = layout_ == "over";
    std::string label = text(is_over ? original_ : model);
    const bool is_original = is_over || (pane == 0 && layout_ != "result");
    if (is_original && original_.range(colour_) && layout_ != "original" && compared_ != result_) {
      label += ", compared with " + compared_->surface->name;
    }
    return is_over ? label + ", over " + text(*result_) : label;
  }

  std::vector<PanelRow> legend() const {
    std::vector<PanelRow> rows;
    const std::vector<ShownModel> shown = shown_models();
    if (std::any_of(shown.begin(), shown.end(), [this](const ShownModel& one) { return one.range(colour_); })) {
      rows.push_back({error_title(), &error_scale(), top()});
    }
    if (colour_ == "normals") rows.push_back({"normals: x, y, z from -1 to 1 as red, green, blue"});
    if (colour_ == "shape") rows.push_back({"radius ratio 2r/R, 1 is equilateral", &shape_scale(), 1});
    if (colour_ == "valence") rows.push_back({"edges at a vertex", &valence_scale()});
    for (const ShownModel& model : shown) {
      if (model.has(colour_) || (model.is_level && view_.colour.empty())) continue;
      rows.push_back({model.surface->name + " has no such colours"});
    }
    return rows;
  }

  std::string error_title() const {
    if (colour_ == "texcoord") return "texture coordinates off by, 1 is the whole texture";
    if (colour_ == "colour") return "length of the difference of red, green, blue and opacity";
    return colour_ == "normal" ? "angle between normals, degrees" : "distance, model units";
  }

  PictureView view_;
  const PictureSize& size_;
  unsigned threads_;
  std::vector<std::string>& warnings_;
  std::optional<ShownSurface> level_;
  ShownModel original_;
  std::vector<ShownModel> results_;
  const ShownModel* result_ = nullptr;    ///< that is shown; null without results
  const ShownModel* compared_ = nullptr;  ///< what errors of the original are differences to
  std::string layout_;
  std::string colour_;
};

}  // namespace

RgbPicture draw_meshes(ShownMeshes& meshes, const PictureView& view, const PictureSize& size, unsigned threads,
                       std::vector<std::string>& warnings) {
  return MeshPicture(meshes, view, size, threads, warnings).draw();
}

std::string png_file(const RgbPicture& picture) {
  render::Picture out{picture.width, picture.height, {}, {}};
  out.pixels.reserve(picture.width * picture.height);
  const auto part = [&picture](std::size_t i) { return static_cast<float>(picture.bytes[i]) / 255; };
  for (std::size_t i = 0; i < picture.bytes.size(); i += 3) out.pixels.push_back({part(i), part(i + 1), part(i + 2)});
  return render::write_png(out);
}

}  // namespace whittle::app
