#include "structure/sizes.hh"

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>

namespace {

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// Replaces text[begin, end) by spaces; lines stay lines.
void blank(std::string& text, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < std::min(end, text.size()); ++i)
    if (text[i] != '\n') text[i] = ' ';
}

/// Position after the first `closing` from `begin` on; the end of the text if there is none.
std::size_t past(const std::string& text, const std::string& closing, std::size_t begin) {
  const std::size_t at = text.find(closing, begin);
  return at == std::string::npos ? text.size() : at + closing.size();
}

/// Position after the literal whose opening quote is at `i`.
std::size_t past_literal(const std::string& text, std::size_t i) {
  if (text[i] == '"' && i > 0 && text[i - 1] == 'R') {
    const std::size_t open = text.find('(', i);
    return past(text, ")" + text.substr(i + 1, open - i - 1) + "\"", open);
  }
  std::size_t end = i + 1;
  while (end < text.size() && text[end] != text[i] && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
  return end + 1;
}

/// Position after the preprocessor directive at `i`, including its continuation lines.
std::size_t past_directive(const std::string& text, std::size_t i) {
  std::size_t end = past(text, "\n", i);
  while (end < text.size() && end >= 2 && text[end - 2] == '\\') end = past(text, "\n", end);
  return end;
}

/// The text with comments, literals and directives replaced by spaces.
std::string bare_code(std::string text) {
  bool at_line_start = true;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const bool is_separator = c == '\'' && i > 0 && std::isxdigit(static_cast<unsigned char>(text[i - 1])) != 0;
    std::size_t end = i + 1;
    if (text.compare(i, 2, "//") == 0)
      end = past(text, "\n", i);
    else if (text.compare(i, 2, "/*") == 0)
      end = past(text, "*/", i + 2);
    else if (c == '#' && at_line_start)
      end = past_directive(text, i);
    else if (c == '"' || (c == '\'' && !is_separator))
      end = past_literal(text, i);
    if (end > i + 1) blank(text, i, end);
    at_line_start = text[std::min(end, text.size()) - 1] == '\n' || (at_line_start && is_space(c));
    i = end;
  }
  return text;
}

enum class Block { scope, body, braces };

std::string trimmed(const std::string& text) {
  const auto first = std::find_if_not(text.begin(), text.end(), is_space);
  const auto last = std::find_if_not(text.rbegin(), std::make_reverse_iterator(first), is_space).base();
  return {first, last};
}

/// The declaration without the leading `template <…>`.
std::string without_template(std::string head) {
  while (head.starts_with("template")) {
    std::size_t i = head.find('<');
    if (i == std::string::npos) break;
    int depth = 0;
    do {
      depth += head[i] == '<' ? 1 : head[i] == '>' ? -1 : 0;
      ++i;
    } while (i < head.size() && depth > 0);
    head = trimmed(head.substr(i));
  }
  return head;
}

/// The text without the contents of its parentheses. `depth` is the number of open ones at its end.
std::string without_parentheses(const std::string& text, int& depth) {
  std::string outside;
  depth = 0;
  for (const char c : text) {
    if (c == ')') --depth;
    if (depth == 0) outside += c;
    if (c == '(') ++depth;
  }
  return outside;
}

/// The kind of block that the brace after `declaration` opens, outside of functions.
Block opened_by(const std::string& declaration) {
  static const std::regex scope(R"(^(inline\s+)?(namespace|class|struct|union|extern)\b)");
  static const std::regex names_operator(R"(\boperator\s*[^\s\w(]+)");
  static const std::regex constructor_list(R"(\)\s*(noexcept\s*)?:[^:])");
  const std::string head = without_template(trimmed(declaration));
  int depth = 0;
  const std::string outside = std::regex_replace(without_parentheses(head, depth), names_operator, "operator");
  if (depth > 0) return Block::braces;
  const bool has_parentheses = outside.find("()") != std::string::npos;
  if (head.empty() || std::regex_search(outside, scope)) return Block::scope;
  if (const std::size_t equals = outside.rfind('='); equals != std::string::npos)
    return trimmed(outside.substr(equals + 1)).starts_with("[") ? Block::body : Block::braces;
  if (!has_parentheses) return Block::braces;
  const bool names_member =
      std::isalnum(static_cast<unsigned char>(head.back())) || head.back() == '_' || head.back() == '>';
  return names_member && std::regex_search(outside + " ", constructor_list) ? Block::braces : Block::body;
}

/// "name" of "type name(…) const".
std::string name_in(const std::string& declaration) {
  const std::string head = without_template(trimmed(declaration));
  const std::string before = trimmed(head.substr(0, head.find('(')));
  const std::size_t space = before.find_last_of(" \n&*");
  const std::string name = space == std::string::npos ? before : before.substr(space + 1);
  const bool is_macro = name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_") == std::string::npos;
  return is_macro ? head.substr(0, head.find(')') + 1) : name;
}

}  // namespace

std::vector<FunctionSize> function_sizes(const std::string& text) {
  const std::string code = bare_code(text);
  std::vector<FunctionSize> sizes;
  std::vector<Block> blocks;
  std::size_t head = 0;        // where the current declaration begins
  std::size_t body_depth = 0;  // size of `blocks` with the function's own block; 0: no function is open
  std::size_t line = 1, head_line = 1;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = code[i];
    if (c == '\n') ++line;
    if (trimmed(code.substr(head, i - head)).empty() && body_depth == 0 && !is_space(c) && head <= i) {
      head = i;
      head_line = line;
    }
    if (c == '{') {
      blocks.push_back(body_depth ? Block::braces : opened_by(code.substr(head, i - head)));
      if (blocks.back() == Block::body) body_depth = blocks.size();
      if (blocks.back() == Block::scope) head = i + 1;
    } else if (c == '}' && !blocks.empty()) {
      const Block closed = blocks.back();
      blocks.pop_back();
      if (closed == Block::body)
        sizes.push_back({name_in(code.substr(head, i - head)), head_line, line - head_line + 1});
      if (closed == Block::body) body_depth = 0;
      if (closed != Block::braces) head = i + 1;
    } else if (c == ';' && body_depth == 0 && (blocks.empty() || blocks.back() == Block::scope)) {
      head = i + 1;
    }
  }
  return sizes;
}

std::size_t n_lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

Findings long_functions(const SourceTree& tree, std::size_t limit) {
  Findings findings;
  for (const auto& [path, text] : tree)
    for (const FunctionSize& size : function_sizes(text))
      if (size.n_lines > limit)
        findings.push_back(path + ": " + size.name + " has " + std::to_string(size.n_lines) + " lines, from line " +
                           std::to_string(size.first_line));
  return findings;
}

Findings long_headers(const SourceTree& tree, std::size_t limit) {
  Findings findings;
  for (const auto& [path, text] : tree)
    if (path.ends_with(".hh") && n_lines(text) > limit)
      findings.push_back(path + " has " + std::to_string(n_lines(text)) + " lines");
  return findings;
}

Findings full_folders(const SourceTree& tree, std::size_t limit) {
  std::map<std::string, std::size_t> n_files;
  for (const auto& [path, text] : tree) ++n_files[folder_of(path)];
  Findings findings;
  for (const auto& [folder, n] : n_files)
    if (n > limit) findings.push_back(folder + " has " + std::to_string(n) + " files");
  return findings;
}
