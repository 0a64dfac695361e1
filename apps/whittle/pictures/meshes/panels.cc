#include "pictures/meshes/panels.hh"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "pictures/meshes/font.hh"
#include "whittle/core/text/text.hh"

namespace whittle::app {
namespace {

constexpr std::size_t margin = 8;   // pixels, around a box
constexpr std::size_t padding = 8;  // left and right of its text
constexpr std::size_t row_height = 18;
constexpr std::size_t bar_height = 14;
constexpr std::size_t least_step = 18;  // width of a colour
constexpr std::size_t least_gap = 12;   // between ticks
constexpr render::Rgb color_of_text = rgb_of(0x1C1C1A);
constexpr render::Rgb color_of_panel = rgb_of(0xFFFFFF);
constexpr render::Rgb color_of_divider = rgb_of(0x0B62A8);
constexpr float opacity_of_panels = 0.92F;

struct Rectangle {
  std::size_t left, top, width, height;
};

void blend(RgbPicture& picture, std::size_t x, std::size_t y, const render::Rgb& color, float opacity) {
  if (x >= picture.width || y >= picture.height) return;
  std::uint8_t* const pixel = &picture.bytes[3 * (y * picture.width + x)];
  for (std::size_t k = 0; k < 3; ++k) {
    pixel[k] = static_cast<std::uint8_t>(std::lround(std::lerp(static_cast<float>(pixel[k]), color[k] * 255, opacity)));
  }
}

void fill(RgbPicture& picture, const Rectangle& box, const render::Rgb& color, float opacity = 1) {
  for (std::size_t y = box.top; y < box.top + box.height; ++y) {
    for (std::size_t x = box.left; x < box.left + box.width; ++x) blend(picture, x, y, color, opacity);
  }
}

/// With round corners.
void fill_panel(RgbPicture& picture, const Rectangle& box) {
  constexpr std::array<std::size_t, 3> insets{3, 1, 1};  // of the rows from an edge
  for (std::size_t y = 0; y < box.height; ++y) {
    const std::size_t from_edge = std::min(y, box.height - 1 - y);
    const std::size_t inset = from_edge < insets.size() ? insets[from_edge] : 0;
    fill(picture, {box.left + inset, box.top + y, box.width - 2 * inset, 1}, color_of_panel, opacity_of_panels);
  }
}

/// The characters of a text, those that the font doesn't have as 0x7F.
std::string drawable(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 && byte < 0xC0) continue;  // goes on with a character of UTF-8
    out += byte >= ' ' && byte < 0x7F ? c : '\x7F';
  }
  return out;
}

unsigned glyph_row(char c, std::size_t y) {
  constexpr int hexadecimal = 16;
  if (c == '\x7F') return y >= 2 && y <= 10 ? (y == 2 || y == 10 ? 0x3EU : 0x22U) : 0;  // a box
  const char* const digits = glyphs[static_cast<std::size_t>(c - first_glyph)] + 2 * y;
  unsigned row = 0;
  std::from_chars(digits, digits + 2, row, hexadecimal);
  return row;
}

void draw_text(RgbPicture& picture, const std::string& text, std::size_t left, std::size_t top) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (std::size_t y = 0; y < glyph_height; ++y) {
      const unsigned row = glyph_row(text[i], y);
      for (std::size_t x = 0; x < glyph_width; ++x) {
        if ((row >> (glyph_width - 1 - x) & 1U) != 0) {
          blend(picture, left + i * glyph_width + x, top + y, color_of_text, 1);
        }
      }
    }
  }
}

std::size_t width_of(const std::string& text) { return text.size() * glyph_width; }

/// Lines of at most so many characters, broken at blanks where there are some.
std::vector<std::string> wrapped(std::string text, std::size_t most) {
  std::vector<std::string> lines;
  while (text.size() > most) {
    const std::size_t blank = text.rfind(' ', most);
    const bool has_blank = blank != std::string::npos && blank > 0;
    lines.push_back(text.substr(0, has_blank ? blank : most));
    text.erase(0, has_blank ? blank + 1 : most);
  }
  lines.push_back(std::move(text));
  return lines;
}

/// Three digits that count.
std::string short_number(double value) {
  constexpr int digits = 3;
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
  double rounded = value;
  std::from_chars(text.data(), result.ptr, rounded);
  return shortest(rounded);
}

std::vector<std::string> ticks_of(const PanelRow& row) {
  if (!row.scale->names.empty()) return row.scale->names;
  constexpr int n_parts = 4;
  std::vector<std::string> ticks;
  ticks.reserve(n_parts + 1);
  for (int i = 0; i <= n_parts; ++i) ticks.push_back(short_number(row.top * i / n_parts));
  return ticks;
}

std::size_t width_of(const std::vector<std::string>& ticks) {
  std::size_t width = (ticks.size() - 1) * least_gap;
  for (const std::string& tick : ticks) width += width_of(tick);
  return width;
}

std::size_t width_of(const PanelRow& row) {
  const std::size_t text = width_of(drawable(row.text));
  if (row.scale == nullptr) return text;
  return std::max({text, least_step * row.scale->colors.size(), width_of(ticks_of(row))});
}

std::size_t height_of(const PanelRow& row) { return row.scale == nullptr ? row_height : 2 * row_height + bar_height; }

/// Colours beside each other, and below them the ticks, as far apart as there is room.
void draw_scale(RgbPicture& picture, const PanelRow& row, const Rectangle& bar) {
  const std::vector<render::Rgb>& colors = row.scale->colors;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const std::size_t begin = bar.width * i / colors.size();
    const std::size_t end = bar.width * (i + 1) / colors.size();
    fill(picture, {bar.left + begin, bar.top, end - begin, bar.height}, colors[i]);
  }
  const std::vector<std::string> ticks = ticks_of(row);
  const std::size_t n_gaps = ticks.size() - 1;
  const std::size_t room = bar.width + n_gaps * least_gap - width_of(ticks);
  std::size_t before = 0;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    draw_text(picture, ticks[i], bar.left + before + room * i / n_gaps, bar.top + bar.height + 2);
    before += width_of(ticks[i]);
  }
}

}  // namespace

void draw_divider(RgbPicture& picture, std::size_t x) {
  constexpr std::size_t width = 2;
  const std::size_t left = std::min(x - std::min(x, width / 2), picture.width - std::min(picture.width, width));
  fill(picture, {left, 0, std::min(width, picture.width), picture.height}, color_of_divider);
}

void draw_label(RgbPicture& picture, const std::string& text, const PanelCorner& corner, std::size_t width) {
  constexpr std::size_t least = 8;  // characters
  constexpr std::size_t share_percent = 92;
  const std::size_t room = width * share_percent / 100;
  const std::size_t most = std::max(least, room > 2 * padding ? (room - 2 * padding) / glyph_width : 0);
  const std::vector<std::string> lines = wrapped(drawable(text), most);
  std::size_t widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, width_of(line));
  Rectangle box{corner.left + margin, corner.top + margin, widest + 2 * padding, lines.size() * row_height + 4};
  if (box.left + box.width > picture.width) box.left = picture.width - std::min(picture.width, box.width + margin);
  fill_panel(picture, box);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    draw_text(picture, lines[i], box.left + padding, box.top + 5 + i * row_height);
  }
}

void draw_legend(RgbPicture& picture, const std::vector<PanelRow>& rows) {
  if (rows.empty()) return;
  Rectangle box{0, 0, 2 * padding, padding};
  for (const PanelRow& row : rows) {
    box.width = std::max(box.width, width_of(row) + 2 * padding);
    box.height += height_of(row);
  }
  if (box.width + 2 * margin > picture.width || box.height + 2 * margin > picture.height) return;  // no room
  box.left = picture.width - margin - box.width;
  box.top = picture.height - margin - box.height;
  fill_panel(picture, box);
  std::size_t top = box.top + padding / 2;
  for (const PanelRow& row : rows) {
    draw_text(picture, drawable(row.text), box.left + padding, top + 2);
    if (row.scale != nullptr) {
      draw_scale(picture, row, {box.left + padding, top + row_height, box.width - 2 * padding, bar_height});
    }
    top += height_of(row);
  }
}

}  // namespace whittle::app
