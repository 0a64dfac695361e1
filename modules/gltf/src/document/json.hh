#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace whittle::gltf {

/// Keeps the order of names.
using Json = nlohmann::ordered_json;

/// Deeper ones are refused, as all that walks through a document recurses.
inline constexpr std::size_t deepest_nesting = 200;
/// An object with more names is refused: looking one up takes time in proportion to their number.
inline constexpr std::size_t most_names = 10'000;

/// \param file its name, for messages. \throw io::ReadError if this is no JSON, or beyond these limits
Json parse_json(std::string_view text, const std::string& file);

/// Null if there is none, or if `object` is no object.
const Json* member(const Json& object, std::string_view name);
/// The value as a whole number, if it is one and not negative. 2.0 is one, too.
std::optional<std::size_t> as_whole(const Json& value);
/// A name as it can stand in a message: one line, printable, not too long.
std::string printable(std::string_view text);

/// A value of a document, with its name for messages. Functions throw io::ReadError for values of another type or
/// range.
class Part {
 public:
  Part(const Json& json, std::string name, const std::string& file)
      : json_(&json), name_(std::move(name)), file_(&file) {}

  const Json& json() const { return *json_; }
  const std::string& name() const { return name_; }
  [[noreturn]] void fail(const std::string& problem) const;

  bool has(std::string_view key) const { return member(*json_, key) != nullptr; }
  /// A member that is an object. Called "name key".
  std::optional<Part> object(std::string_view key) const;
  /// The elements of a member that is an array; none if there is no such member. Called "label 3", after this one's
  /// name unless that is empty.
  std::vector<Part> array(std::string_view key, std::string_view label) const;

  std::optional<std::size_t> whole(std::string_view key) const;
  std::size_t whole_or(std::string_view key, std::size_t otherwise) const;
  std::size_t required_whole(std::string_view key) const;
  /// A whole number below `size`, of a `label`: "accessor".
  std::optional<std::size_t> index(std::string_view key, std::size_t size, std::string_view label) const;
  std::size_t required_index(std::string_view key, std::size_t size, std::string_view label) const;
  std::optional<std::string> text(std::string_view key) const;
  std::string required_text(std::string_view key) const;
  bool flag(std::string_view key) const;
  std::optional<double> number(std::string_view key) const;
  /// An array of numbers.
  std::optional<std::vector<double>> numbers(std::string_view key) const;
  /// `n` finite numbers.
  std::optional<std::vector<double>> numbers(std::string_view key, std::size_t n) const;
  /// Numbers below `size`: "children".
  std::vector<std::size_t> indices(std::string_view key, std::size_t size, std::string_view label) const;
  /// Names and numbers below `size`: "attributes". `whole` names the container.
  std::vector<std::pair<std::string, std::size_t>> named_indices(std::size_t size, std::string_view label) const;
  /// extensions.name, if there is one.
  std::optional<Part> extension(std::string_view extension) const;

 private:
  [[noreturn]] void fail_missing(std::string_view key) const;
  std::string called(std::string_view key) const;

  const Json* json_;
  std::string name_;
  const std::string* file_;
};

}  // namespace whittle::gltf
