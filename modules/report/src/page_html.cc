#include "whittle/report/page.hh"

#include <zlib.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <stdexcept>
#include <string_view>

#include "page_template.hh"
#include "whittle/core/bytes/base64.hh"

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
std::string in_script(std::string_view json) {
  std::string result;
  for (const char c : json) {
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

/// Compresses by zlib (RFC 1950). Output of meshoptimizer becomes a sixth smaller still.
std::string deflated(const std::vector<unsigned char>& bytes) {
  uLongf n = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(n, '\0');
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &n, bytes.data(), static_cast<uLong>(bytes.size()),
                Z_DEFAULT_COMPRESSION) != Z_OK) {
    throw std::runtime_error("zlib can't compress the page");
  }
  result.resize(n);
  return result;
}

std::string charts_html(const std::vector<PageChart>& charts) {
  std::string html;
  for (const auto& [title, svg] : charts) {
    const bool may_scroll = svg.find("width=\"920") != std::string::npos;  // as style.css has it
    html += may_scroll ? "<figure tabindex=\"0\">" : "<figure>";
    html += "<figcaption>" + escaped(title) + "</figcaption>" + svg + "</figure>\n";
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

}  // namespace

void write_page(std::ostream& out, const Page& page) {
  const PageData data = page_data(page);
  const std::map<std::string_view, std::string> contents{{"title", escaped(page.title)},
                                                         {"data", in_script(data.json)},
                                                         {"bytes", base64(deflated(data.bytes))},
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
