#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

/// Rounds to a multiple of 2⁻²⁰. So the torus is the same even if the compiler reorders its formula (-ffast-math).
inline double on_grid(double x) { return std::floor(x * 1048576 + 0.5) / 1048576; }

/// A closed surface to decimate, without any library: 2 · n_around · n_tube faces, genus 1.
struct Torus {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<unsigned, 3>> faces;

  Torus(unsigned n_around, unsigned n_tube) {
    for (unsigned i = 0; i < n_around; ++i)
      for (unsigned j = 0; j < n_tube; ++j) {
        const double u = 2 * std::numbers::pi * i / n_around;
        const double v = 2 * std::numbers::pi * j / n_tube;
        const double ring = 1 + 0.4 * std::cos(v);
        points.push_back({on_grid(ring * std::cos(u)), on_grid(ring * std::sin(u)), on_grid(0.4 * std::sin(v))});
        const unsigned next_i = (i + 1) % n_around;
        const unsigned next_j = (j + 1) % n_tube;
        const unsigned a = i * n_tube + j;
        const unsigned b = next_i * n_tube + j;
        const unsigned c = next_i * n_tube + next_j;
        const unsigned d = i * n_tube + next_j;
        faces.push_back({a, b, c});
        faces.push_back({a, c, d});
      }
  }
};
