// Prints options.d.ts: the type of each option that the package has, from the row of the program's table.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/pipeline/request.hh"
#include "whittle/web/options.hh"

namespace {

/// Of "face-ratio" faceRatio. Counts are facesLeft and verticesLeft: a mesh has `faces`.
std::string camel_case(std::string_view name) {
  if (name == "faces" || name == "vertices") return std::string(name) + "Left";
  std::string result;
  bool is_upper = false;
  for (const char c : name) {
    if (c != '-') result += is_upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    is_upper = c == '-';
  }
  return result;
}

/// "'keep' | 'free'" of "keep|free", without the words that only the program knows.
std::string words_type(const std::string& meta, std::string_view name) {
  std::string type;
  for (std::size_t begin = 0; begin <= meta.size();) {
    const std::size_t end = std::min(meta.find('|', begin), meta.size());
    const std::string word = meta.substr(begin, end - begin);
    if (name != "self-intersections" || word != "count") type += (type.empty() ? "'" : " | '") + word + "'";
    begin = end + 1;
  }
  return type;
}

std::string type_of(const whittle::OptionRow& row, std::string_view name) {
  const std::string& meta = row.access.meta;
  if (meta.empty()) return "boolean";
  if (name == "threshold") return "number | `${number}%`";
  if (name == "attribute-weight") {
    return "{uv?: number, normal?: number, color?: number, morph?: number, joints?: number, seam?: number}";
  }
  if (meta.find('|') != std::string::npos) return words_type(meta, name);
  const bool takes_percent = meta == "R" || meta == "E" || meta == "T" || meta == "S";
  return takes_percent ? "number | `${number}%`" : "number";
}

/// "    * text", in lines of at most 110 columns.
void print_comment(const std::string& text) {
  std::printf("  /**\n");
  std::string line;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!line.empty() && line.size() + word.size() > 105) {
      std::printf("   * %s\n", line.c_str());
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
    begin = end + 1;
  }
  std::printf("   * %s\n   */\n", line.c_str());
}

std::vector<std::string> names_of_package() {
  std::vector<std::string> names;
  const std::string_view all = whittle::web::option_names();
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = std::min(all.find('\n', begin), all.size());
    std::string name(all.substr(begin, end - begin));
    name = name.substr(0, name.find(' '));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    begin = end + 1;
  }
  return names;
}

}  // namespace

int main() {
  whittle::Request request;
  const whittle::OptionRows rows = whittle::option_rows(request);
  std::printf(
      "// Made by modules/web/types/option_types.cc from the program's table of options.\n\n"
      "/** Options of `simplify`: at least one target, the first one reached ends the run. */\n"
      "export interface SimplifyOptions {\n");
  for (const std::string& name : names_of_package()) {
    const whittle::OptionRow* const row = whittle::find_row(rows, "--" + name);
    if (row == nullptr) {
      std::fprintf(stderr, "the program has no option --%s\n", name.c_str());
      return 1;
    }
    const std::string standard = row->standard.empty() ? whittle::to_string(row->access.get()) : row->standard;
    print_comment(row->help + " (default: " + standard + ")");
    std::printf("  %s?: %s;\n", camel_case(name).c_str(), type_of(*row, name).c_str());
  }
  std::printf("}\n");
}
