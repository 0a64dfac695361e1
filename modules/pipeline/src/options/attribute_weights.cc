#include "options/attribute_weights.hh"

#include <algorithm>
#include <array>

namespace whittle {
namespace {

struct WeightKind {
  std::string_view word;
  double AttributeWeights::*weight;
};

constexpr std::array<WeightKind, 6> kinds{{{"uv", &AttributeWeights::texcoord},
                                           {"normal", &AttributeWeights::normal},
                                           {"color", &AttributeWeights::color},
                                           {"morph", &AttributeWeights::displacement},
                                           {"joints", &AttributeWeights::joint_weights},
                                           {"seam", &AttributeWeights::seam}}};

/// \param text "uv=0.5"
void set_one(std::string_view text, AttributeWeights& weights) {
  const std::size_t equals = text.find('=');
  const std::string_view word = text.substr(0, equals);
  const WeightKind* const end = kinds.data() + kinds.size();
  const WeightKind* const kind = std::find_if(kinds.data(), end, [&](const WeightKind& k) { return k.word == word; });
  if (equals == std::string_view::npos || kind == end) {
    throw std::invalid_argument("'" + std::string(text) +
                                "' isn't KIND=W with uv, normal, color, morph, joints or seam");
  }
  weights.*(kind->weight) = parse_number(text.substr(equals + 1), {0}, "W");
}

std::string text_of(const AttributeWeights& weights) {
  std::string text;
  for (const WeightKind& kind : kinds) {
    text.append(text.empty() ? "" : ",").append(kind.word).append("=").append(shortest(weights.*(kind.weight)));
  }
  return text;
}

}  // namespace

OptionAccess attribute_weights(AttributeWeights& target) {
  const auto set = [&target](std::string_view text) {
    AttributeWeights weights = target;
    for (const std::string_view part : parts_of(text)) set_one(part, weights);
    target = weights;
  };
  return {"KIND=W", set, [&target] { return OptionValue(text_of(target)); }};
}

}  // namespace whittle
