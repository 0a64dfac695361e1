#include "options/attribute_weights.hh"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "options/values.hh"

namespace whittle::app {
namespace {

struct Kind {
  std::string_view word;
  double AttributeWeights::*weight;
};

constexpr std::array<Kind, 6> kinds{{{"uv", &AttributeWeights::texcoord},
                                     {"normal", &AttributeWeights::normal},
                                     {"color", &AttributeWeights::color},
                                     {"morph", &AttributeWeights::displacement},
                                     {"joints", &AttributeWeights::joint_weights},
                                     {"seam", &AttributeWeights::seam}}};

/// \param text "uv=0.5"
void parse_one(std::string_view text, AttributeWeights& weights) {
  const std::size_t equals = text.find('=');
  const std::string_view word = text.substr(0, equals);
  const auto* const kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.word == word; });
  if (equals == std::string_view::npos || kind == kinds.end()) {
    throw std::invalid_argument("'" + std::string(text) +
                                "' isn't KIND=W with uv, normal, color, morph, joints or seam");
  }
  weights.*(kind->weight) = parse_number(text.substr(equals + 1), {0}, "W");
}

}  // namespace

AttributeWeights parse_attribute_weights(std::string_view text, AttributeWeights weights) {
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parse_one(text.substr(begin, end - begin), weights);
    begin = end + 1;
  }
  return weights;
}

std::string to_string(const AttributeWeights& weights) {
  std::string text;
  for (const Kind& kind : kinds) {
    text += (text.empty() ? "" : ",") + std::string(kind.word) + "=" + shortest(weights.*(kind.weight));
  }
  return text;
}

}  // namespace whittle::app
