#include "options/help.hh"

#include <functional>
#include <sstream>
#include <utility>

namespace whittle::app {
namespace {

constexpr std::size_t column = 30;
constexpr std::size_t line_width = 100;

/// `text` in lines of at most `line_width` columns, each indented by `column`.
std::string wrapped(const std::string& text) {
  std::string lines;
  std::istringstream words(text);
  std::string line(column, ' ');
  for (std::string word; words >> word;) {
    if (line.size() > column && line.size() + 1 + word.size() > line_width) {
      lines += line + '\n';
      line.assign(column, ' ');
    }
    if (line.size() > column) line += ' ';
    line += word;
  }
  return lines + line + '\n';
}

std::string entry(const std::string& name, const std::string& description) {
  const std::string text = wrapped(description);
  const std::string first = "  " + name;
  if (first.size() + 2 > column) return first + '\n' + text;
  return first + text.substr(first.size());
}

std::string section(const OptionGroup& group) {
  std::string text = "\n";
  text += group.title + ":\n";
  for (const CLI::Option* option : group.options) text += entry(shown_name(*option), shown_description(*option));
  return text;
}

}  // namespace

std::vector<OptionGroup> option_groups(const CLI::App& app) {
  std::vector<OptionGroup> groups;
  const auto add = [&](const std::string& title, const std::function<bool(const CLI::Option*)>& is_in) {
    OptionGroup group{title, app.get_options(is_in)};
    if (!group.options.empty()) groups.push_back(std::move(group));
  };
  add("Arguments", [](const CLI::Option* option) { return option->get_positional(); });
  for (const std::string& title : app.get_groups()) {
    add(title,
        [&title](const CLI::Option* option) { return option->get_group() == title && !option->get_positional(); });
  }
  return groups;
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

std::string shown_name(const CLI::Option& option) {
  std::string name;
  for (const char c : option.get_name(option.get_positional(), true)) {
    name += c;
    if (c == ',') name += ' ';
  }
  if (option.get_positional() || !takes_value(option)) return name;
  return name + ' ' + option.get_type_name();
}

std::string shown_description(const CLI::Option& option) {
  if (option.get_required()) return option.get_description() + " (required)";
  const std::string standard = option.get_default_str();
  return option.get_description() + (standard.empty() ? "" : " (default: " + standard + ")");
}

void set_usage(CLI::App& subcommand, const std::string& usage) { subcommand.get_option("--help")->option_text(usage); }

std::string usage_of(const CLI::App& subcommand) { return subcommand.get_option("--help")->get_option_text(); }

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode /*mode*/) const {
  const bool is_top = app->get_parent() == nullptr;
  std::string text = app->get_description() + "\n\nUsage: " + name;
  if (is_top) {
    text += " SUBCOMMAND ...\n\nSubcommands:\n";
    for (const CLI::App* sub : app->get_subcommands({})) text += entry(sub->get_name(), sub->get_description());
  } else {
    const std::string usage = usage_of(*app);
    text += (usage.empty() ? "" : ' ' + usage) + '\n';
  }
  for (const OptionGroup& group : option_groups(*app)) text += section(group);
  return text + '\n' + app->get_footer() + '\n';
}

}  // namespace whittle::app
