#include <array>
#include <optional>
#include <string>

#include "readers.hh"

namespace whittle::io {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"sv;

struct Signature {
  std::string_view start;
  std::string_view what;
  std::string_view advice;
};

constexpr std::string_view not_supported = "which is not supported; use OBJ, OFF, PLY or STL";
constexpr std::string_view unpack = "which is not supported; unpack it first";
constexpr std::string_view save_as_utf8 = "save it as UTF-8 or plain ASCII";

constexpr Signature foreign[] = {
    {"glTF"sv, "binary glTF", not_supported},
    {"Kaydara FBX"sv, "FBX", not_supported},
    {"OCTM"sv, "OpenCTM", not_supported},
    {"# vtk DataFile"sv, "VTK", not_supported},
    {"#VRML"sv, "VRML", not_supported},
    {"#X3D"sv, "X3D", not_supported},
    {"BLENDER"sv, "a Blender scene", not_supported},
    {"DRACO"sv, "Draco", not_supported},
    {"ISO-10303-21"sv, "STEP", not_supported},
    {"<?xml"sv, "XML (Collada, VTK, X3D...)", not_supported},
    {"<!DOCTYPE"sv, "a web page", "the download went wrong"},
    {"<html"sv, "a web page", "the download went wrong"},
    {"version https://git-lfs"sv, "a Git LFS pointer, not the mesh itself", "run git lfs pull"},
    {"PK\x03\x04"sv, "a zip archive", unpack},
    {"\x1F\x8B"sv, "compressed with gzip", unpack},
    {"BZh"sv, "compressed with bzip2", unpack},
    {"\xFD"
     "7zXZ"sv,
     "compressed with xz", unpack},
    {"\x28\xB5\x2F\xFD"sv, "compressed with zstd", unpack},
    {"7z\xBC\xAF"sv, "a 7z archive", unpack},
    {"\xFF\xFE"sv, "UTF-16 text", save_as_utf8},
    {"\xFE\xFF"sv, "UTF-16 text", save_as_utf8},
};

bool starts_with_word(std::string_view text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  return text.size() == word.size() || static_cast<unsigned char>(text[word.size()]) <= ' ';
}

// "OFF", "COFF", "STCNOFF BINARY"…
bool starts_with_off_keyword(std::string_view text) {
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
  return word.size() <= 8 && word.ends_with("OFF") &&
         word.substr(0, word.size() - 3).find_first_not_of("STCN4n") == std::string_view::npos;
}

std::optional<Format> evident_format(std::string_view bytes) {
  if (is_binary_stl_by_size(bytes)) return Format::stl;
  const std::string_view text = without_byte_order_mark(bytes);
  if (text.starts_with("ply\n") || text.starts_with("ply\r")) return Format::ply;
  if (starts_with_off_keyword(text)) return Format::off;
  if (starts_with_word(text, "solid") && text.substr(0, 1024).find("facet") != std::string_view::npos) {
    return Format::stl;
  }
  return std::nullopt;
}

// UTF-16 without its mark: every second byte of ASCII text is zero.
bool looks_like_utf16(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, 64);
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < start.size(); ++i) zeros[i % 2] += start[i] == '\0';
  const std::size_t half = start.size() / 2;
  return half > 2 && ((zeros[0] >= half - 1 && zeros[1] == 0) || (zeros[1] >= half - 1 && zeros[0] == 0));
}

bool has_null_byte(std::string_view bytes) { return bytes.substr(0, 1024).find('\0') != std::string_view::npos; }

}  // namespace

std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

void refuse_foreign_content(std::string_view bytes, std::string_view name, Format format) {
  const auto fail = [&](const std::string& problem) { throw ReadError(std::string(name), problem); };
  if (bytes.empty()) fail("the file is empty");
  const std::optional<Format> evident = evident_format(bytes);
  if (evident == format) return;
  if (evident) {
    const std::string other(name_of(*evident));
    fail("the content is " + other + ", not " + std::string(name_of(format)) + "; rename it to ." + other +
         " or give --format " + other);
  }
  for (const auto& [start, what, advice] : foreign) {
    if (bytes.starts_with(start)) fail("the content is " + std::string(what) + "; " + std::string(advice));
  }
  if (format == Format::stl) return;  // may be binary, with a count that doesn't fit; the reader says more
  if (looks_like_utf16(bytes)) fail("the content is UTF-16 text; " + std::string(save_as_utf8));
  if (format == Format::obj && has_null_byte(bytes)) fail("the content is binary data, not an OBJ file");
}

}  // namespace whittle::io
