#include "commands/page/page_tables.hh"

#include "terminal/table.hh"
#include "whittle/pipeline/values.hh"

namespace whittle::app {
namespace {

std::string text_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return yes_no(value.get<bool>());
  if (value.is_number_float()) return significant(value.get<double>());
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void add_rows(const std::string& name, const Json& json, report::PageTable& table) {
  if (json.is_null() || (json.is_structured() && json.empty())) return;
  if (!json.is_structured()) {
    table.rows.emplace_back(name, text_of(json));
    return;
  }
  std::size_t i = 0;
  for (const auto& [key, value] : json.items()) {
    std::string words = json.is_array() ? std::to_string(++i) : key;
    for (char& c : words) {
      if (c == '_') c = ' ';
    }
    if (!name.empty()) words.insert(0, name + ' ');
    add_rows(words, value, table);
  }
}

}  // namespace

report::PageTable table_of(const std::string& title, const Json& json) {
  report::PageTable table{title, {}};
  add_rows("", json, table);
  return table;
}

}  // namespace whittle::app
