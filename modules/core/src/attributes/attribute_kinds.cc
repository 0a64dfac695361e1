#include "whittle/core/attribute_kinds.hh"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "whittle/core/regions.hh"

namespace whittle {
namespace {

/// Each may have an "id" at its end without a gap: "batchid".
constexpr std::string_view things[] = {
    "batch",   "category", "class",    "classes",      "classification", "cluster", "code",     "face",
    "feature", "group",    "instance", "label",        "labels",         "layer",   "material", "object",
    "part",    "region",   "segment",  "segmentation", "source",         "type",    "zone"};
/// These say nothing without an "id": files name measurements by them, too.
constexpr std::string_view only_with_id[] = {"face", "feature", "layer", "part", "source"};

constexpr std::string_view measures[] = {
    "intensity",   "confidence",  "weight",    "density",   "height",    "elevation",  "depth",
    "temperature", "curvature",   "grey",      "gray",      "opacity",   "alpha",      "red",
    "green",       "blue",        "occlusion", "roughness", "metallic",  "distance",   "error",
    "time",        "probability", "accuracy",  "reflect",   "amplitude", "uncertainty"};
/// They say of integers that they measure something. Programs give them to reals of any meaning.
constexpr std::string_view any_numbers[] = {"quality", "scalar"};

bool is_stored_as_real(ScalarType type) { return type == ScalarType::float32 || type == ScalarType::float64; }

template <class Words>
bool is_one_of(std::string_view word, const Words& words) {
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

/// Long ones are found within words, too, as in "treeheight"; short ones are in many words: "predicted".
template <class Words>
bool has_one_of(std::string_view word, const Words& words) {
  constexpr std::size_t long_word = 6;
  return std::any_of(std::begin(words), std::end(words), [&](std::string_view part) {
    return word == part || (part.size() >= long_word && word.find(part) != word.npos);
  });
}

/// Words of letters, in lower case.
std::vector<std::string> words_of(std::string_view name) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto is_lower = [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0; };
  std::vector<std::string> words;
  char before = ' ';
  for (const char c : name) {
    const bool is_first = !is_letter(before) || (is_lower(before) && !is_lower(c));
    if (is_letter(c)) {
      if (is_first) words.emplace_back();
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    before = c;
  }
  return words;
}

bool names_thing(std::string_view word) {
  if (word == "id" || word == "ids" || word == "uid" || word == "identifier") return true;
  for (const std::string_view end : {std::string_view("ids"), std::string_view("id")}) {
    if (word.ends_with(end) && is_one_of(word.substr(0, word.size() - end.size()), things)) return true;
  }
  return is_one_of(word, things) && !is_one_of(word, only_with_id);
}

/// The kind by the last known word of a name; empty without a known word.
std::optional<AttributeKind> kind_by_name(std::string_view name, ScalarType type) {
  const std::vector<std::string> words = words_of(name);
  for (auto word = words.rbegin(); word != words.rend(); ++word) {
    if (names_thing(*word)) return AttributeKind::category;
    if (has_one_of(*word, measures)) return AttributeKind::scalar;
    if (!is_stored_as_real(type) && has_one_of(*word, any_numbers)) return AttributeKind::scalar;
  }
  return std::nullopt;
}

bool finite_are_whole(const std::vector<double>& values) {
  bool is_any_finite = false;
  for (const double x : values) {
    if (!std::isfinite(x)) continue;
    if (x != std::floor(x)) return false;
    is_any_finite = true;
  }
  return is_any_finite;
}

}  // namespace

AttributeKind kind_of_numbers(std::string_view name, ScalarType type, bool is_normalized) {
  const bool is_number_of_thing = !is_stored_as_real(type) && !is_normalized;
  return kind_by_name(name, type).value_or(is_number_of_thing ? AttributeKind::category : AttributeKind::scalar);
}

void find_whole_categories(IndexedMesh& mesh) {
  for (Attribute& attribute : mesh.attributes) {
    if (attribute.kind != AttributeKind::scalar || attribute.is_normalized) continue;
    if (kind_by_name(attribute.name, attribute.type) || !finite_are_whole(attribute.values)) continue;
    attribute.kind = AttributeKind::category;
  }
}

void set_categories(IndexedMesh& mesh, const CategoryNames& names) {
  if (!names) return;
  for (Attribute& attribute : mesh.attributes) {
    if (attribute.kind != AttributeKind::scalar && attribute.kind != AttributeKind::category) continue;
    const bool is_named =
        std::any_of(names->begin(), names->end(), [&](const std::string& name) { return has_name(attribute, name); });
    attribute.kind = is_named ? AttributeKind::category : AttributeKind::scalar;
  }
}

}  // namespace whittle
