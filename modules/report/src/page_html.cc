#include "whittle/report/page.hh"

#include <algorithm>
#include <map>
#include <ostream>
#include <stdexcept>
#include <string_view>

#include "packed_recording.hh"
#include "packed_surface.hh"
#include "page_bytes.hh"
#include "page_template.hh"
#include "whittle/core/bytes/base64.hh"
#include "whittle/core/geometry/box.hh"

namespace whittle::report {
namespace {

/// Text as it is shown by HTML, also within quotes.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// JSON within a script element, which ends at the first "</script".
std::string in_script(const Json& json) {
  std::string result;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

std::string charts_html(const std::vector<PageChart>& charts) {
  std::string html;
  for (const auto& [title, svg] : charts) {
    html += "<figure><figcaption>" + escaped(title) + "</figcaption>" + svg + "</figure>\n";
  }
  return html;
}

std::string row_html(const PageRow& row, std::size_t n_columns) {
  const std::string unit = row.unit.empty() ? "" : " <small>" + escaped(row.unit) + "</small>";
  std::string html = "<tr><th scope=\"row\">" + escaped(row.name) + unit + "</th>";
  for (std::size_t i = 0; i < n_columns; ++i) {
    const std::string value = i < row.values.size() ? escaped(row.values[i]) : "";
    html += row.best == i ? "<td class=\"best\">" + value + "<span class=\"unseen\"> (best)</span></td>"
                          : "<td>" + value + "</td>";
  }
  return html + "</tr>\n";
}

std::string table_html(const PageTable& table) {
  std::string html = "<table><caption>" + escaped(table.title) + "</caption>\n";
  if (!table.columns.empty()) {
    html += "<thead><tr><td></td>";
    for (const std::string& name : table.columns) html += "<th scope=\"col\">" + escaped(name) + "</th>";
    html += "</tr></thead>\n";
  }
  html += "<tbody>\n";
  for (const PageRow& row : table.rows) html += row_html(row, std::max<std::size_t>(table.columns.size(), 1));
  return html + "</tbody></table>\n";
}

/// What is wider than the window scrolls by itself.
std::string tables_html(const Page& page) {
  std::string html;
  for (const PageTable& table : page.tables) {
    html += "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" + escaped(table.title) + "\">" +
            table_html(table) + "</div>\n";
  }
  if (page.json.empty()) return html;
  return html + "<details id=\"json\"><summary>All figures, as JSON</summary><pre tabindex=\"0\">" +
         escaped(page.json) + "</pre></details>\n";
}

Box bounds_of_all(const Page& page) {
  Box all = bounds_of(page.original.mesh);
  for (const PageSurface& result : page.results) all.extend(bounds_of(result.mesh));
  if (page.recording) {
    for (const Contraction& c : page.recording->replay.steps().contractions) all.extend(c.position);
    for (const PassEnd& end : page.recording->replay.steps().pass_ends) {
      for (const auto& [vertex, position] : end.moved) all.extend(position);
    }
  }
  return all;
}

Json pack(const Page& page, PageBytes& bytes) {
  const Grid grid = Grid::around(bounds_of_all(page));
  Json json;
  json["title"] = page.title;
  json["advice"] = page.advice;
  json["origin"] = {grid.origin.x(), grid.origin.y(), grid.origin.z()};
  json["step"] = grid.step;
  PageImages images;
  json["original"] = pack(page.original, grid, bytes, images);
  json["results"] = Json::array();
  for (const PageSurface& result : page.results) {
    json["results"].push_back(pack(result, grid, bytes, images));
  }
  json["recording"] = page.recording ? pack(*page.recording, grid, bytes) : Json(nullptr);
  json["images"] = images.pack(bytes);
  if (const std::optional<PageLive>& live = page.live) {
    json["live"] = {{"stage", live->stage},   {"fraction", live->fraction}, {"faces", live->n_faces},
                    {"target", live->target}, {"seconds", live->seconds},   {"problem", live->problem}};
  }
  return json;
}

}  // namespace

void write_page(std::ostream& out, const Page& page) {
  PageBytes bytes;
  const std::string data = in_script(pack(page, bytes));
  const std::map<std::string_view, std::string> contents{{"title", escaped(page.title)},
                                                         {"data", data},
                                                         {"bytes", base64(deflated(bytes.bytes()))},
                                                         {"charts", charts_html(page.charts)},
                                                         {"tables", tables_html(page)}};
  // Only words of the template are replaced: contents may have braces of their own.
  const std::string page_text = page_template();
  std::string_view rest = page_text;
  while (!rest.empty()) {
    const std::size_t begin = rest.find("{{");
    const std::size_t end = begin == std::string_view::npos ? begin : rest.find("}}", begin);
    const auto found =
        end == std::string_view::npos ? contents.end() : contents.find(rest.substr(begin + 2, end - begin - 2));
    if (found == contents.end()) {
      const std::size_t n = begin == std::string_view::npos ? rest.size() : begin + 2;
      out << rest.substr(0, n);
      rest.remove_prefix(n);
      continue;
    }
    out << rest.substr(0, begin) << found->second;
    rest.remove_prefix(end + 2);
  }
}

}  // namespace whittle::report
