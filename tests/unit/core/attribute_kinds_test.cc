// Which numbers name things, and which measure something.
#include "whittle/core/attribute_kinds.hh"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace whittle::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

AttributeKind kind_of_reals(const std::string& name) { return kind_of_numbers(name, ScalarType::float32); }
AttributeKind kind_of_integers(const std::string& name) { return kind_of_numbers(name, ScalarType::int32); }

TEST(AttributeKinds, FollowTheNameOfReals) {
  for (const char* name : {"_FEATURE_ID_0", "_BATCHID", "scalar_Classification", "id", "objectId", "PointSourceId",
                           "label", "Labels", "class", "semantic_class", "height_class", "instance_3", "material"}) {
    EXPECT_EQ(kind_of_reals(name), AttributeKind::category) << name;
  }
  for (const char* name : {"quality", "height", "class_probability", "grid", "solid", "fluid_depth", "valid", "value",
                           "feature_0", "predicted", "subclassing", "u", ""}) {
    EXPECT_EQ(kind_of_reals(name), AttributeKind::scalar) << name;
  }
}

TEST(AttributeKinds, OfIntegersAreCategoriesUnlessTheNameMeasures) {
  for (const char* name : {"tree", "x7", "time_id", "predicted", "valid", ""}) {
    EXPECT_EQ(kind_of_integers(name), AttributeKind::category) << name;
  }
  for (const char* name : {"quality", "scalar_field", "Intensity", "treeheight", "class_confidence", "red"}) {
    EXPECT_EQ(kind_of_integers(name), AttributeKind::scalar) << name;
  }
  EXPECT_EQ(kind_of_numbers("share", ScalarType::uint8, true), AttributeKind::scalar);
}

IndexedMesh mesh_with(const std::string& name, const std::vector<double>& values) {
  IndexedMesh mesh;
  mesh.attributes.push_back({.name = name, .kind = AttributeKind::scalar, .n_components = 1, .values = values});
  return mesh;
}

TEST(AttributeKinds, WholeRealsAreCategoriesUnlessTheNameMeasures) {
  const auto kind = [](const std::string& name, const std::vector<double>& values) {
    IndexedMesh mesh = mesh_with(name, values);
    find_whole_categories(mesh);
    return mesh.attributes[0].kind;
  };
  EXPECT_EQ(kind("soil", {0, 7, -3}), AttributeKind::category);
  EXPECT_EQ(kind("quality", {0, nan, 3}), AttributeKind::category);
  EXPECT_EQ(kind("quality", {0, 0.5, 3}), AttributeKind::scalar);
  EXPECT_EQ(kind("quality", {nan, nan}), AttributeKind::scalar);
  EXPECT_EQ(kind("height", {3, 4, 5}), AttributeKind::scalar);
  EXPECT_EQ(kind("intensity", {0, 128, 255}), AttributeKind::scalar);
}

TEST(AttributeKinds, CanBeSaidByName) {
  IndexedMesh mesh = mesh_with("a", {0, 1});
  mesh.attributes.push_back({.name = "b", .kind = AttributeKind::category, .n_components = 1, .values = {0, 1}});
  mesh.attributes.push_back({.name = "s,t", .kind = AttributeKind::texcoord, .n_components = 2, .values = {0, 1}});
  const auto kinds = [&] {
    std::vector<AttributeKind> all;
    for (const Attribute& attribute : mesh.attributes) all.push_back(attribute.kind);
    return all;
  };
  using enum AttributeKind;
  set_categories(mesh, {});
  EXPECT_EQ(kinds(), (std::vector{scalar, category, texcoord}));
  set_categories(mesh, std::vector<std::string>{"a", "s"});
  EXPECT_EQ(kinds(), (std::vector{category, scalar, texcoord}));
  set_categories(mesh, std::vector<std::string>{});
  EXPECT_EQ(kinds(), (std::vector{scalar, scalar, texcoord}));
}

}  // namespace
}  // namespace whittle::test
