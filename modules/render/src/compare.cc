#include "whittle/render/compare.hh"

#include <algorithm>
#include <stdexcept>

#include "whittle/core/detail/parallel.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::render {

namespace {

/// The pictures of one view, and how they differ.
struct PicturePair {
  Picture original;
  Picture simplified;
  ErrorMap flip;
  SquaredError model_error;
};

void measure(PicturePair& pair, double pixels_per_degree) {
  pair.model_error = squared_error(pair.original, pair.simplified, PixelSet::model);
  pair.flip = flip_map(pair.original, pair.simplified, pixels_per_degree);
}

/// Takes the pairs in the order of the views, and keeps the worst one.
class Summary {
 public:
  void add(const View& view, PicturePair pair) {
    const ViewComparison result{view, pair.model_error.psnr(), pair.flip.mean()};
    comparison_.views.push_back(result);
    all_ += pair.model_error;
    if (comparison_.views.size() > 1 && result.psnr >= comparison_.worst_psnr) return;
    comparison_.worst_psnr = result.psnr;
    worst_ = std::move(pair);
  }

  Comparison finish() {
    for (const ViewComparison& view : comparison_.views) {
      comparison_.mean_psnr += view.psnr;
      comparison_.mean_flip += view.flip;
      comparison_.worst_flip = std::max(comparison_.worst_flip, view.flip);
    }
    const auto n = static_cast<double>(comparison_.views.size());
    comparison_.mean_psnr /= n;
    comparison_.mean_flip /= n;
    comparison_.pooled_psnr = all_.psnr();
    comparison_.worst_png = write_png(side_by_side({worst_.original, worst_.simplified, picture_of(worst_.flip)}));
    return std::move(comparison_);
  }

 private:
  Comparison comparison_;
  SquaredError all_;  ///< of the model's pixels of all views
  PicturePair worst_;
};

}  // namespace

Comparison compare(const Scene& original, const Scene& simplified, const CompareOptions& options) {
  if (options.n_views < 1 || options.n_views > 10'000) throw std::invalid_argument("views must be in [1, 10000]");
  detail::ProgressMeter meter(options.progress);
  meter.start("drawing", 1);
  const Sphere sphere = bounding_sphere(original);
  Renderer draw_original(original, sphere, options.draw);
  Renderer draw_simplified(simplified, sphere, options.draw);
  const std::vector<View> views = views_around(sphere, options.n_views);
  const std::size_t n_at_once = n_threads(options.threads);
  Summary summary;
  for (std::size_t begin = 0; begin < views.size(); begin += n_at_once) {
    std::vector<PicturePair> pairs(std::min(n_at_once, views.size() - begin));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      pairs[i].original = draw_original.draw(views[begin + i]);
      pairs[i].simplified = draw_simplified.draw(views[begin + i]);
      meter.update(static_cast<double>(begin + i) / static_cast<double>(views.size()));
    }
    for_each_block(pairs.size(), options.threads, [&](std::size_t i) { measure(pairs[i], options.pixels_per_degree); });
    for (std::size_t i = 0; i < pairs.size(); ++i) summary.add(views[begin + i], std::move(pairs[i]));
  }
  meter.finish();
  return summary.finish();
}

}  // namespace whittle::render
