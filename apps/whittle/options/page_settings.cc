#include "options/page_settings.hh"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "whittle/pipeline/values.hh"

namespace whittle::app {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A control of the page (viewer.html), or another setting in its address (app.js).
struct PageSetting {
  std::string_view name;
  std::string_view words;  ///< its values, with '|' between them; empty: a number, or nothing
  bool takes_number = false;
  double least = -infinite;
  double most = infinite;
};
constexpr std::array<PageSetting, 20> page_settings{{
    {"layout", "beside|over|original|result|split"},
    {"result", "", true, 0},
    {"split", "", true, 0, 1},
    {"colour", "none|error|valence|shape|material|colours|normals|texcoord|colour|normal"},
    {"top", "usual|1|0.5|0.2|0.1"},
    {"ghost", "transparent|edges|points"},
    {"shading", "flat|smooth|file"},
    {"up", "y|z|x"},
    {"faces", "on|off"},
    {"edges", "on|off"},
    {"borders", "on|off"},
    {"nonmanifold", "on|off"},
    {"refused", "on|off"},
    {"level", "", true, 0, 1},
    {"movement", "steps|continuous"},
    {"spacing", "contractions|faces"},
    {"plain", ""},
    {"turn", "", true},
    {"tilt", "", true},
    {"zoom", "", true, 0},
}};

const PageSetting& page_setting(const std::string& name) {
  const auto* const found = std::find_if(page_settings.begin(), page_settings.end(),
                                         [&name](const PageSetting& setting) { return setting.name == name; });
  if (found != page_settings.end()) return *found;
  std::string names;
  for (const PageSetting& setting : page_settings) names.append(names.empty() ? "" : ", ").append(setting.name);
  throw std::invalid_argument("'" + name + "' is none of " + names);
}

bool is_one_of(const std::string& value, std::string_view words) {
  std::istringstream parts{std::string(words)};
  for (std::string word; std::getline(parts, word, '|');) {
    if (word == value) return true;
  }
  return false;
}

/// \param part "colour=error"
void check_page_setting(const std::string& part) {
  const std::size_t equals = part.find('=');
  const std::string name = part.substr(0, equals);
  const PageSetting& setting = page_setting(name);
  if (setting.words.empty() && !setting.takes_number) {
    if (equals != std::string::npos) throw std::invalid_argument(name + " takes no value");
    return;
  }
  if (equals == std::string::npos) throw std::invalid_argument(name + " needs a value: '" + name + "=VALUE'");
  const std::string value = part.substr(equals + 1);
  if (setting.takes_number) {
    parse_number(value, {setting.least, setting.most, true, true}, name);
  } else if (!is_one_of(value, setting.words)) {
    throw std::invalid_argument(name + ": '" + value + "' is none of " + std::string(setting.words));
  }
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '=' || c == ',' || c == '.' || c == '-';
}

}  // namespace

std::map<std::string, std::string> parse_page_settings(std::string_view text) {
  if (!std::all_of(text.begin(), text.end(), is_plain)) {
    throw std::invalid_argument("'" + std::string(text) + "' is not of the form KEY=VALUE,...");
  }
  std::map<std::string, std::string> settings;
  std::istringstream parts{std::string(text)};
  for (std::string part; std::getline(parts, part, ',');) {
    check_page_setting(part);
    const std::size_t equals = std::min(part.find('='), part.size());
    settings[part.substr(0, equals)] = part.substr(std::min(equals + 1, part.size()));
  }
  return settings;
}

}  // namespace whittle::app
