#include "ply/ply_plan.hh"

#include <algorithm>
#include <span>
#include <string_view>

#include "bytes/words.hh"
#include "whittle/core/attribute_kinds.hh"

namespace whittle::io {
namespace {

struct NamedRole {
  std::string_view name;
  PlyRole role;
};
/// The first name of each role is the one it is written with.
constexpr NamedRole named_roles[] = {{"x", x},
                                     {"y", y},
                                     {"z", z},
                                     {"nx", nx},
                                     {"ny", ny},
                                     {"nz", nz},
                                     {"red", red},
                                     {"r", red},
                                     {"diffuse_red", red},
                                     {"green", green},
                                     {"g", green},
                                     {"diffuse_green", green},
                                     {"blue", blue},
                                     {"b", blue},
                                     {"diffuse_blue", blue},
                                     {"alpha", alpha},
                                     {"a", alpha},
                                     {"diffuse_alpha", alpha},
                                     {"tolerance", tolerance}};

bool is_float(PlyType type) { return type == PlyType::float32 || type == PlyType::float64; }

/// The number that means full intensity. Integers of 8 and 16 bits use their full range. `MeshBuilder` scales all
/// others when the whole file is known.
double color_unit(PlyType type) {
  if (type == PlyType::uint8 || type == PlyType::int8) return 255;
  if (type == PlyType::uint16 || type == PlyType::int16) return 65535;
  return 1;
}

/// A name without the number at its end: "texture_u", "1" of "texture_u1".
struct Stem {
  std::string_view stem;
  std::string_view number;
};

Stem stem_of(std::string_view name) {
  const std::size_t end = name.find_last_not_of("0123456789") + 1;
  return {name.substr(0, end), name.substr(end)};
}

/// Whether two properties are the coordinates of one point in a texture.
bool are_texcoords(const PlyProperty& u, const PlyProperty& v) {
  constexpr std::string_view pairs[][2] = {{"s", "t"},
                                           {"u", "v"},
                                           {"texture_u", "texture_v"},
                                           {"texture_s", "texture_t"},
                                           {"texcoord_u", "texcoord_v"},
                                           {"texcoord_s", "texcoord_t"},
                                           {"tex_u", "tex_v"},
                                           {"tex_s", "tex_t"}};
  if (u.type != v.type || !is_float(u.type) || u.count_type || v.count_type) return false;
  const Stem of_u = stem_of(u.name);
  const Stem of_v = stem_of(v.name);
  if (of_u.number != of_v.number) return false;
  return std::any_of(std::begin(pairs), std::end(pairs),
                     [&](const auto& pair) { return of_u.stem == pair[0] && of_v.stem == pair[1]; });
}

void append_name(std::string& names, const std::string& name) { names += (names.empty() ? "" : ", ") + name; }

class AttributePlanner {
 public:
  explicit AttributePlanner(const std::vector<PlyProperty>& properties) : properties_(properties) {
    plan_.places.resize(properties.size());
  }

  /// Takes several properties as one attribute. Its name are their names, with commas between.
  void add(AttributeKind kind, std::span<const std::size_t> which, double unit = 1) {
    Attribute attribute{.name = {}, .kind = kind, .n_components = which.size(), .values = {}};
    attribute.type = properties_[which.front()].type;
    attribute.is_normalized = unit != 1;
    for (std::size_t i = 0; i < which.size(); ++i) {
      attribute.name += (i > 0 ? "," : "") + properties_[which[i]].name;
      plan_.places[which[i]] = PlyPlace{plan_.attributes.size(), i, unit};
    }
    plan_.attributes.push_back(std::move(attribute));
  }

  /// Takes each property that is chosen and not taken yet. \param is_chosen by property
  void add_others(const std::vector<char>& is_chosen) {
    for (std::size_t p = 0; p < properties_.size(); ++p) {
      if (!is_chosen[p] || plan_.places[p]) continue;
      if (const auto pair = find_texcoord(p, is_chosen)) {
        add(AttributeKind::texcoord, *pair);
      } else {
        add(kind_of_numbers(properties_[p].name, properties_[p].type), std::array{p});
      }
    }
  }

  PlyAttributes take() { return std::move(plan_); }

 private:
  /// The coordinates that a property belongs to, in either order.
  std::optional<std::array<std::size_t, 2>> find_texcoord(std::size_t p, const std::vector<char>& is_chosen) const {
    for (std::size_t q = 0; q < properties_.size(); ++q) {
      if (!is_chosen[q] || plan_.places[q]) continue;
      if (are_texcoords(properties_[p], properties_[q])) return std::array{p, q};
      if (are_texcoords(properties_[q], properties_[p])) return std::array{q, p};
    }
    return std::nullopt;
  }

  const std::vector<PlyProperty>& properties_;
  PlyAttributes plan_;
};

/// The properties with the colour of a face, if there are all three, of one type.
std::vector<std::size_t> face_color(const std::vector<PlyProperty>& properties) {
  std::vector<std::size_t> found;
  for (const std::string_view name : {"red", "green", "blue", "alpha"}) {
    const auto at = std::find_if(properties.begin(), properties.end(), [&](const PlyProperty& p) {
      return p.name == name && !p.count_type && (found.empty() || p.type == properties[found.front()].type);
    });
    if (at == properties.end()) break;
    found.push_back(static_cast<std::size_t>(at - properties.begin()));
  }
  return found.size() < 3 ? std::vector<std::size_t>{} : found;
}

}  // namespace

PlyRole role_of(const PlyProperty& property) {
  if (property.count_type) return other;
  for (const auto& [name, role] : named_roles) {
    if (property.name == name) return role;
  }
  return other;
}

void lower_known_names(std::vector<PlyProperty>& properties) {
  for (const auto& [name, role] : named_roles) {
    const auto has_name = [known = name](const PlyProperty& p) { return is_same_word(p.name, known); };
    if (std::count_if(properties.begin(), properties.end(), has_name) != 1) continue;
    std::find_if(properties.begin(), properties.end(), has_name)->name = std::string(name);
  }
}

std::string written_name(const PlyProperty& property) {
  const PlyRole role = role_of(property);
  for (const auto& [name, named] : named_roles) {
    if (role == named) return std::string(name);
  }
  return property.name;
}

PlyVertexPlan plan_vertices(const PlyElement& element, AttributeScope scope) {
  PlyVertexPlan plan;
  for (const PlyProperty& property : element.properties) {
    const PlyRole role = role_of(property);
    plan.roles.push_back(role);
    plan.has[role] = true;
    if (role >= red && role <= alpha) plan.color_units[role - red] = color_unit(property.type);
    if (role == red && is_float(property.type)) plan.color_type = PlyType::float32;
    if (role == red && property.type == PlyType::uint16) plan.color_type = PlyType::uint16;
  }
  plan.normals = plan.has[nx] && plan.has[ny] && plan.has[nz];
  plan.colors = plan.has[red] && plan.has[green] && plan.has[blue];
  std::vector<char> is_other(plan.roles.size(), 0);
  for (std::size_t p = 0; p < plan.roles.size(); ++p) {
    const PlyRole role = plan.roles[p];
    const bool has_place = role <= z || (role <= nz && plan.normals) || (role <= alpha && role >= red && plan.colors);
    if (has_place) continue;
    const bool is_scalar = !element.properties[p].count_type && role != tolerance;
    if (scope == AttributeScope::all && is_scalar) {
      is_other[p] = 1;
      plan.roles[p] = other;
    } else {
      append_name(plan.lost, element.properties[p].name);
    }
  }
  AttributePlanner planner(element.properties);
  planner.add_others(is_other);
  plan.others = planner.take();
  return plan;
}

PlyFacePlan plan_faces(const PlyElement& element, AttributeScope scope) {
  PlyFacePlan plan;
  std::vector<char> is_other(element.properties.size(), 0);
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    const bool is_carried = scope == AttributeScope::all;
    if (property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index")) {
      plan.corners = p;
    } else if (is_carried && property.count_type && property.name == "texcoord" && is_float(property.type)) {
      plan.texcoords = p;
    } else if (is_carried && !property.count_type) {
      is_other[p] = 1;
    } else {
      append_name(plan.lost, property.name);
    }
  }
  AttributePlanner planner(element.properties);
  const std::vector<std::size_t> color =
      scope == AttributeScope::all ? face_color(element.properties) : std::vector<std::size_t>{};
  if (!color.empty()) planner.add(AttributeKind::color, color, color_unit(element.properties[color.front()].type));
  planner.add_others(is_other);
  plan.others = planner.take();
  return plan;
}

std::vector<std::string> property_names(const Attribute& attribute, std::size_t n_before) {
  std::vector<std::string> names(1);
  for (const char c : attribute.name) {
    if (c == ',') {
      names.emplace_back();
    } else {
      names.back() += static_cast<unsigned char>(c) > ' ' ? c : '_';  // a blank ends a name
    }
  }
  const bool are_names = std::none_of(names.begin(), names.end(), [](const std::string& name) { return name.empty(); });
  if (names.size() == attribute.n_components && are_names) return names;
  std::string whole;
  for (const std::string& name : names) whole += (whole.empty() ? "" : "_") + name;
  names.clear();
  for (std::size_t i = 0; i < attribute.n_components; ++i) {
    if (attribute.kind == AttributeKind::texcoord && attribute.n_components <= 3) {
      names.push_back(std::string(1, "stp"[i]) + (n_before > 0 ? std::to_string(n_before) : ""));
    } else {
      names.push_back(attribute.n_components == 1 ? "attribute" : whole + "_" + std::to_string(i));
    }
  }
  return names;
}

}  // namespace whittle::io
