#include "format/content.hh"

#include <optional>
#include <stdexcept>
#include <string>

#include "format/foreign.hh"
#include "format/format_row.hh"
#include "whittle/io/path_of.hh"

namespace whittle::io {

namespace {

const detail::FormatRow* evident_format(std::string_view bytes) {
  const detail::FormatRow* found = nullptr;
  Evidence strongest = Evidence::none;
  for (const detail::FormatRow* row : detail::format_table) {
    const Evidence evidence = row->recognises != nullptr ? row->recognises(bytes) : Evidence::none;
    if (evidence <= strongest) continue;
    strongest = evidence;
    found = row;
  }
  return found;
}

bool has_null_byte(std::string_view bytes) { return bytes.substr(0, 1024).find('\0') != std::string_view::npos; }

std::optional<Format> format_by_name(std::string_view name) {
  try {
    return format_of(path_of(name));
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

// Names options of the program. It takes --format only for names that don't tell the format.
std::string advice_on(const std::string& right, const detail::FormatRow& expected, std::string_view name) {
  const std::optional<Format> named = format_by_name(name);
  if (!named) return "give --format " + right;
  if (*named != expected.format) return "give --input-format " + right;
  return "rename it to ." + right + (has_gzip_extension(path_of(name)) ? ".gz" : "");
}

std::string problem_of_other_format(const detail::FormatRow& evident, const detail::FormatRow& expected,
                                    std::string_view name) {
  const std::string right(evident.name);
  return "the content is " + right + ", not " + std::string(expected.name) + "; " + advice_on(right, expected, name);
}

std::optional<std::string> problem_of(std::string_view bytes, std::string_view name,
                                      const detail::FormatRow& expected) {
  if (bytes.empty()) return "the file is empty";
  const detail::FormatRow* const evident = evident_format(bytes);
  if (evident == &expected) return std::nullopt;
  if (evident != nullptr) return problem_of_other_format(*evident, expected, name);
  if (auto problem = problem_of_foreign_content(bytes)) return problem;
  if (expected.beginning == Beginning::any_bytes) return std::nullopt;
  if (looks_like_utf16(bytes)) return std::string(problem_of_utf16);
  if (expected.beginning == Beginning::text && has_null_byte(bytes)) {
    return "the content is binary data; " + std::string(expected.title) + " files are text";
  }
  return std::nullopt;
}

}  // namespace

void refuse_wrong_content(std::string_view bytes, std::string_view name, Format format) {
  if (const auto problem = problem_of(bytes, name, row_of(format))) throw ReadError(std::string(name), *problem);
}

}  // namespace whittle::io
