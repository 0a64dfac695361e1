#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/render/picture.hh"

namespace whittle::render {

/// The pixels that count.
enum class PixelSet : std::uint8_t {
  model,  ///< Pixels where at least one of both pictures shows the model.
  all     ///< The whole picture.
};

/// The sum of squared differences of two pictures, and the number of terms.
struct SquaredError {
  double sum = 0;        ///< Over sRGB values in [0, 255].
  std::size_t size = 0;  ///< Three per pixel that counts.

  SquaredError& operator+=(const SquaredError& other);
  /// 10 log₁₀(255² · size/sum), dB; infinity if sum is 0.
  double psnr() const;
};

/// \throw std::invalid_argument if the sizes of the pictures differ
SquaredError squared_error(const Picture& a, const Picture& b, PixelSet pixels = PixelSet::model);

/// Peak signal-to-noise ratio, dB, of the sRGB values on the scale of 8 bits, all three channels together. Infinity for
/// equal pictures. Symmetric. Over the model it doesn't depend on the amount of background. Over the whole picture it
/// equals the PSNR of image programs. \throw std::invalid_argument if the sizes of the pictures differ
double psnr(const Picture& a, const Picture& b, PixelSet pixels = PixelSet::model);

/// An observer 0.7 m away from a monitor 0.7 m wide with 3840 pixels.
inline constexpr double default_pixels_per_degree = 67;

/// The error of each pixel.
struct ErrorMap {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<float> values;  ///< width · height, rows from the top; each in [0, 1].

  double mean() const;
};

/// ꟻLIP: the difference per pixel that a person sees who alternates between both pictures. Ignores coverage. Symmetric,
/// and 0 for equal pictures. \cite andersson_2020_flip, the variant for pictures of low dynamic range.
/// \param pixels_per_degree of the observer's visual angle, [1, 1000]
/// \throw std::invalid_argument if the sizes of the pictures differ or are 0, or `pixels_per_degree` is out of range
ErrorMap flip_map(const Picture& a, const Picture& b, double pixels_per_degree = default_pixels_per_degree);

/// The mean of `flip_map` over the whole picture, as in the paper: [0, 1].
double flip(const Picture& a, const Picture& b, double pixels_per_degree = default_pixels_per_degree);

/// Colours an error map: from 0, black, by violet, red and orange to 1, pale yellow.
Picture picture_of(const ErrorMap& map);

}  // namespace whittle::render
