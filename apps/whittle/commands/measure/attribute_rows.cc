#include "commands/measure/attribute_rows.hh"

#include <array>

#include "terminal/table.hh"
#include "whittle/pipeline/values.hh"

namespace whittle::app {
namespace {

constexpr std::array<Choice<AttributeKind>, 9> kinds{{{"texcoord", AttributeKind::texcoord},
                                                      {"normal", AttributeKind::normal},
                                                      {"tangent", AttributeKind::tangent},
                                                      {"color", AttributeKind::color},
                                                      {"joint_weights", AttributeKind::joint_weights},
                                                      {"displacement", AttributeKind::displacement},
                                                      {"direction", AttributeKind::direction},
                                                      {"scalar", AttributeKind::scalar},
                                                      {"category", AttributeKind::category}}};

Json directed(const metrics::DirectedAttributeDeviation& deviation) {
  return {{"mean", deviation.mean}, {"max", deviation.max}};
}

/// "NORMAL, deg"
std::string label_of(const metrics::AttributeDeviation& attribute) {
  const bool is_angle = attribute.kind == AttributeKind::normal || attribute.kind == AttributeKind::tangent;
  return attribute.name + (is_angle ? ", deg" : attribute.kind == AttributeKind::category ? ", differing" : "");
}

}  // namespace

Json attributes_json(std::span<const metrics::AttributeDeviation> attributes) {
  Json json = Json::array();
  for (const metrics::AttributeDeviation& attribute : attributes) {
    json.push_back({{"name", attribute.name},
                    {"kind", word_of<AttributeKind>(kinds, attribute.kind)},
                    {"mean", attribute.mean},
                    {"max", attribute.max},
                    {"forward", directed(attribute.forward)},
                    {"backward", directed(attribute.backward)}});
  }
  return json;
}

std::string attributes_table(std::span<const metrics::AttributeDeviation> attributes) {
  if (attributes.empty()) return {};
  Table table;
  table.add({"attributes, at nearest points", "mean", "largest of samples"});
  for (const metrics::AttributeDeviation& attribute : attributes) {
    const bool is_share = attribute.kind == AttributeKind::category;
    table.add({label_of(attribute), is_share ? percent(attribute.mean) : significant(attribute.mean),
               is_share ? "" : significant(attribute.max)});
  }
  return table.text();
}

}  // namespace whittle::app
