#include "document/json.hh"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "whittle/io/errors.hh"

namespace whittle::gltf {
namespace {

std::string in_quotes(std::string_view word) {
  std::string text(1, '"');
  text += word;
  text += '"';
  return text;
}

bool are_numbers(const Json& json) {
  return json.is_array() && std::all_of(json.begin(), json.end(), [](const Json& x) { return x.is_number(); });
}

/// Reads through a document before it is parsed. (A callback of the parser would do the same, but with one the parser
/// looks through an array again after each object in it.)
class Limits : public nlohmann::json_sax<Json> {
 public:
  explicit Limits(const std::string& file) : file_(file) {}

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return start(); }
  bool start_array(std::size_t) override { return start(); }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }
  bool key(string_t&) override {
    if (++n_names_.back() > most_names) throw io::ReadError(file_, "an object of the document has too many names");
    return true;
  }
  /// The parser says it.
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override { return false; }

 private:
  bool start() {
    if (n_names_.size() >= deepest_nesting) throw io::ReadError(file_, "the document is nested too deeply");
    n_names_.push_back(0);
    return true;
  }
  bool end() {
    n_names_.pop_back();
    return true;
  }

  const std::string& file_;
  std::vector<std::size_t> n_names_;  ///< of each object and array that is open
};

/// The message of the JSON library, without its number.
std::string reason_of(const Json::exception& error) {
  const std::string text = error.what();
  const std::size_t begin = text.find("] ");
  return printable(begin == std::string::npos ? text : text.substr(begin + 2));
}

}  // namespace

Json parse_json(std::string_view text, const std::string& file) {
  Limits limits(file);
  Json::sax_parse(text.begin(), text.end(), &limits);
  try {
    return Json::parse(text.begin(), text.end());
  } catch (const Json::parse_error& error) {
    throw io::ReadError(file, {.byte = error.byte}, "this is no valid JSON: " + reason_of(error));
  } catch (const Json::exception& error) {
    throw io::ReadError(file, "this is no valid JSON: " + reason_of(error));
  }
}

const Json* member(const Json& object, std::string_view name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

std::optional<std::size_t> as_whole(const Json& value) {
  if (value.is_number_unsigned()) return value.get<std::size_t>();
  if (!value.is_number()) return {};
  const double number = value.get<double>();
  if (!(number >= 0) || number > 0x1p53 || number != std::floor(number)) return {};
  return static_cast<std::size_t>(number);
}

std::string printable(std::string_view text) {
  constexpr std::size_t longest = 200;
  std::string line;
  for (const char c : text.substr(0, longest)) line += static_cast<unsigned char>(c) < 32 || c == 127 ? ' ' : c;
  if (text.size() > longest) {
    // Not in the middle of a character of UTF-8.
    while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xC0U) == 0x80U) line.pop_back();
    if (!line.empty() && (static_cast<unsigned char>(line.back()) & 0x80U) != 0) line.pop_back();
    line += "...";
  }
  return line;
}

void Part::fail(const std::string& problem) const {
  throw io::ReadError(*file_, name_.empty() ? problem : name_ + ": " + problem);
}

void Part::fail_missing(std::string_view key) const { fail(in_quotes(key) + " is missing"); }

std::string Part::called(std::string_view key) const {
  return name_.empty() ? std::string(key) : name_ + ' ' + printable(key);
}

std::optional<Part> Part::object(std::string_view key) const {
  const Json* found = member(*json_, key);
  if (!found) return {};
  if (!found->is_object()) fail(in_quotes(key) + " is not an object");
  return Part(*found, called(key), *file_);
}

std::vector<Part> Part::array(std::string_view key, std::string_view label) const {
  std::vector<Part> parts;
  const Json* found = member(*json_, key);
  if (!found) return parts;
  if (!found->is_array()) fail(in_quotes(key) + " is not an array");
  parts.reserve(found->size());
  for (const Json& element : *found) {
    Part part(element, called(label) + ' ' + std::to_string(parts.size()), *file_);
    if (!element.is_object()) part.fail("not an object");
    parts.push_back(std::move(part));
  }
  return parts;
}

std::optional<std::size_t> Part::whole(std::string_view key) const {
  const Json* found = member(*json_, key);
  if (!found) return {};
  const std::optional<std::size_t> number = as_whole(*found);
  if (!number) fail(in_quotes(key) + " is not a whole number from 0 on");
  return number;
}

std::size_t Part::whole_or(std::string_view key, std::size_t otherwise) const { return whole(key).value_or(otherwise); }

std::size_t Part::required_whole(std::string_view key) const {
  const std::optional<std::size_t> number = whole(key);
  if (!number) fail_missing(key);
  return *number;
}

std::optional<std::size_t> Part::index(std::string_view key, std::size_t size, std::string_view label) const {
  const std::optional<std::size_t> number = whole(key);
  if (number && *number >= size) {
    fail(in_quotes(key) + " names " + std::string(label) + ' ' + std::to_string(*number) + ", there are " +
         std::to_string(size));
  }
  return number;
}

std::size_t Part::required_index(std::string_view key, std::size_t size, std::string_view label) const {
  const std::optional<std::size_t> number = index(key, size, label);
  if (!number) fail_missing(key);
  return *number;
}

std::optional<std::string> Part::text(std::string_view key) const {
  const Json* found = member(*json_, key);
  if (!found) return {};
  if (!found->is_string()) fail(in_quotes(key) + " is not a string");
  return found->get<std::string>();
}

std::string Part::required_text(std::string_view key) const {
  std::optional<std::string> found = text(key);
  if (!found) fail_missing(key);
  return *std::move(found);
}

bool Part::flag(std::string_view key) const {
  const Json* found = member(*json_, key);
  if (found && !found->is_boolean()) fail(in_quotes(key) + " is neither true nor false");
  return found && found->get<bool>();
}

std::optional<double> Part::number(std::string_view key) const {
  const Json* found = member(*json_, key);
  if (!found) return {};
  if (!found->is_number()) fail(in_quotes(key) + " is not a number");
  return found->get<double>();
}

std::optional<std::vector<double>> Part::numbers(std::string_view key) const {
  const Json* found = member(*json_, key);
  if (!found) return {};
  if (!are_numbers(*found)) fail(in_quotes(key) + " is not an array of numbers");
  return found->get<std::vector<double>>();
}

std::optional<std::vector<double>> Part::numbers(std::string_view key, std::size_t n) const {
  const Json* found = member(*json_, key);
  if (!found) return {};
  if (!are_numbers(*found) || found->size() != n) fail(in_quotes(key) + " is not " + std::to_string(n) + " numbers");
  return found->get<std::vector<double>>();
}

std::vector<std::size_t> Part::indices(std::string_view key, std::size_t size, std::string_view label) const {
  std::vector<std::size_t> all;
  const Json* found = member(*json_, key);
  if (!found) return all;
  if (!found->is_array()) fail(in_quotes(key) + " is not an array");
  for (const Json& element : *found) {
    const std::optional<std::size_t> number = as_whole(element);
    if (!number || *number >= size) {
      fail(in_quotes(key) + " names a " + std::string(label) + " that is not there");
    }
    all.push_back(*number);
  }
  return all;
}

std::vector<std::pair<std::string, std::size_t>> Part::named_indices(std::size_t size, std::string_view label) const {
  std::vector<std::pair<std::string, std::size_t>> all;
  if (!json_->is_object()) fail("not an object");
  for (const auto& [key, value] : json_->items()) {
    const std::optional<std::size_t> number = as_whole(value);
    if (!number) fail(in_quotes(printable(key)) + " is not a whole number from 0 on");
    if (*number >= size) {
      fail(in_quotes(printable(key)) + " names " + std::string(label) + ' ' + std::to_string(*number) + ", there are " +
           std::to_string(size));
    }
    all.emplace_back(key, *number);
  }
  return all;
}

std::optional<Part> Part::extension(std::string_view extension) const {
  const Json* extensions = member(*json_, "extensions");
  const Json* found = extensions ? member(*extensions, extension) : nullptr;
  if (!found) return {};
  Part part(*found, called(extension), *file_);
  if (!found->is_object()) part.fail("not an object");
  return part;
}

}  // namespace whittle::gltf
