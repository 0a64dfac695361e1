#include "whittle/render/compare.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/render/render_scenes.hh"

namespace whittle::render {
namespace {

using Compare = Drawing;

CompareOptions small_pictures(std::size_t n_views = 6) {
  CompareOptions options;
  options.n_views = n_views;
  options.draw.size = 64;
  return options;
}

TEST_F(Compare, FindsNoDifferenceBetweenEqualScenes) {
  const IndexedMesh box = box_with_seams();
  const Scene scene = scene_of(box, textured(colorful_image()));
  const Comparison found = compare(scene, scene, small_pictures());
  EXPECT_EQ(found.views.size(), 6);
  EXPECT_EQ(found.mean_psnr, infinity);
  EXPECT_EQ(found.pooled_psnr, infinity);
  EXPECT_EQ(found.worst_psnr, infinity);
  EXPECT_EQ(found.mean_flip, 0);
  EXPECT_EQ(found.worst_flip, 0);
  for (const ViewComparison& view : found.views) EXPECT_EQ(view.psnr, infinity);
}

/// A box, and the same one with a part of a side moved inwards.
class ComparedBoxes {
 public:
  ComparedBoxes() : other_(box_) { other_.positions[7] *= 0.8; }
  Comparison operator()(const CompareOptions& options) const {
    const auto image = colorful_image();
    return compare(scene_of(box_, textured(image)), scene_of(other_, textured(image)), options);
  }
  Scene original() const { return scene_of(box_, textured(colorful_image())); }
  Scene other() const { return scene_of(other_, textured(colorful_image())); }

 private:
  IndexedMesh box_ = box_with_seams();
  IndexedMesh other_;
};

TEST_F(Compare, SumsUpTheViews) {
  const ComparedBoxes boxes;
  const Comparison found = boxes(small_pictures(9));
  const Sphere sphere = bounding_sphere(boxes.original());
  double psnr_sum = 0;
  double flip_sum = 0;
  SquaredError all;
  for (std::size_t i = 0; i < 9; ++i) {
    const View view = views_around(sphere, 9)[i];
    const Picture a = draw(boxes.original(), view, {64, 4});
    const Picture b = draw(boxes.other(), view, {64, 4});
    EXPECT_EQ(found.views[i].psnr, psnr(a, b));
    EXPECT_EQ(found.views[i].flip, flip(a, b));
    psnr_sum += psnr(a, b);
    flip_sum += flip(a, b);
    all += squared_error(a, b);
    EXPECT_GE(found.views[i].psnr, found.worst_psnr);
    EXPECT_LE(found.views[i].flip, found.worst_flip);
  }
  EXPECT_EQ(found.mean_psnr, psnr_sum / 9);  // infinite: some views don't show the corner
  EXPECT_EQ(found.mean_flip, flip_sum / 9);
  EXPECT_EQ(found.pooled_psnr, all.psnr());
  EXPECT_LT(found.pooled_psnr, 60);
}

TEST_F(Compare, GivesThePicturesOfTheWorstView) {
  const ComparedBoxes boxes;
  const Comparison found = boxes(small_pictures());
  const auto is_worst = [&](const ViewComparison& view) { return view.psnr == found.worst_psnr; };
  const auto worst = std::find_if(found.views.begin(), found.views.end(), is_worst);
  ASSERT_NE(worst, found.views.end());
  const View& view = worst->view;
  const Picture a = draw(boxes.original(), view, {64, 4});
  const Picture b = draw(boxes.other(), view, {64, 4});
  EXPECT_EQ(found.worst_png, write_png(side_by_side({a, b, picture_of(flip_map(a, b))})));
  const Pixels image = read_image(found.worst_png);
  EXPECT_EQ(image.width, 3 * 64);
  EXPECT_EQ(image.height, 64);
}

TEST_F(Compare, GivesTheSameForAnyNumberOfThreads) {
  const ComparedBoxes boxes;
  CompareOptions options = small_pictures(7);
  options.threads = 1;
  const Comparison one = boxes(options);
  options.threads = 3;
  const Comparison three = boxes(options);
  EXPECT_EQ(one.worst_png, three.worst_png);
  EXPECT_EQ(one.mean_flip, three.mean_flip);
  EXPECT_EQ(one.pooled_psnr, three.pooled_psnr);
}

TEST_F(Compare, TellsItsProgressAndCanBeCancelled) {
  const ComparedBoxes boxes;
  CompareOptions options = small_pictures(20);
  double last = 0;
  options.progress = [&](const TaskProgress& progress) {
    EXPECT_GE(progress.fraction, last);
    last = progress.fraction;
    return true;
  };
  boxes(options);
  EXPECT_EQ(last, 1);
  options.progress = [](const TaskProgress&) { return false; };
  EXPECT_THROW(boxes(options), Cancelled);
}

TEST_F(Compare, RefusesWhatIsOutOfRange) {
  const ComparedBoxes boxes;
  for (const std::size_t n : {std::size_t{0}, std::size_t{10'001}}) {
    EXPECT_THROW(boxes(small_pictures(n)), std::invalid_argument);
  }
  CompareOptions options = small_pictures();
  options.pixels_per_degree = 0;
  EXPECT_THROW(boxes(options), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::render
