#pragma once

#include <gtest/gtest.h>

#include <OpenMesh/Tools/Decimater/McDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/MixedDecimaterT.hh>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../common/meshes.hh"
#include "../common/modules.hh"

// Classes derived from our modules, and runs with them.

namespace whittle::test::derived {

using Mesh = DoubleMesh;
using OpenMesh::VertexHandle;
using Info = OpenMesh::Decimater::CollapseInfoT<Mesh>;
using Priority = std::function<float(const Info&, const std::function<float()>& own)>;

/// Derives from any module, and asks a function for the priority.
template <class ModuleT>
class ByFunction : public ModuleT {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<ByFunction>;
  explicit ByFunction(Mesh& mesh) : ModuleT(mesh) {}
  float collapse_priority(const Info& collapse) override {
    return priority(collapse, [&] { return ModuleT::collapse_priority(collapse); });
  }
  Priority priority;
};

inline constexpr auto illegal = static_cast<float>(OpenMesh::Decimater::ModBaseT<Mesh>::ILLEGAL_COLLAPSE);
inline const auto own_value = [](const Info&, const std::function<float()>& own) { return own(); };

inline IndexedMesh shape() { return noisy_torus(24, 12, 1, 0.4, 0.03, 3); }
inline bool is_in_region(const IndexedMesh& mesh, VertexHandle v) {
  return mesh.positions[static_cast<std::size_t>(v.idx())].y() > 0;
}
inline const auto outside_of_region = [](const Info& collapse, const std::function<float()>& own) {
  static const IndexedMesh mesh = shape();
  return is_in_region(mesh, collapse.v0) || is_in_region(mesh, collapse.v1) ? illegal : own();
};

/// Decimates outside of the region with a module that refuses all else.
template <class DecimaterT, class ModuleT>
void expect_region_kept(bool ranks, const std::string& context) {
  const IndexedMesh before = shape();
  Mesh mesh = open_mesh<Mesh>(before);
  DecimaterT decimater(mesh);
  if (!ranks) add_module<ModGarlandHeckbertT<Mesh>>(decimater);
  add_module<ByFunction<ModuleT>>(decimater).priority = outside_of_region;
  ASSERT_TRUE(decimater.initialize()) << context;
  EXPECT_GT(decimater.decimate_to_faces(0, 400), 50U) << context;
  for (int i = 0; i < static_cast<int>(before.positions.size()); ++i) {
    const VertexHandle v(i);
    if (!is_in_region(before, v)) continue;
    EXPECT_FALSE(mesh.status(v).deleted()) << context << ", vertex " << i;
    EXPECT_EQ(to_vec3(mesh.point(v)), before.positions[static_cast<std::size_t>(i)]) << context << ", vertex " << i;
  }
}

template <class ModuleT>
void expect_region_kept_by_each_decimater(bool ranks) {
  using namespace OpenMesh::Decimater;
  expect_region_kept<DecimaterT<Mesh>, ModuleT>(ranks, "DecimaterT");
  expect_region_kept<McDecimaterT<Mesh>, ModuleT>(ranks, "McDecimaterT");
  expect_region_kept<MixedDecimaterT<Mesh>, ModuleT>(ranks, "MixedDecimaterT");
  expect_region_kept<PairDecimaterT<Mesh>, ModuleT>(ranks, "PairDecimaterT");
}

/// A run of `PairDecimaterT` on its mesh driver, and what it did.
struct Outcome {
  std::vector<Contraction> contractions;
  DecimateResult result;
  std::vector<ModuleRefusals> refusals;
};
template <class ModuleT>
Outcome run(Mesh mesh, const DecimateTarget& target, const std::function<void(ModuleT&)>& set_up = nullptr,
            const std::function<void(PairDecimaterT<Mesh>&)>& add_more = nullptr) {
  Outcome outcome;
  PairDecimaterT<Mesh> decimater(mesh);
  decimater.set_driver(Driver::mesh);
  auto& module = add_module<ModuleT>(decimater);
  if (set_up) set_up(module);
  if (add_more) add_more(decimater);
  decimater.set_listener([&](const Contraction& made) { outcome.contractions.push_back(made); });
  EXPECT_TRUE(decimater.initialize());
  outcome.result = decimater.decimate(target);
  outcome.refusals = decimater.module_refusals();
  expect_sound(mesh, "after the run");
  return outcome;
}
template <class ModuleT>
Outcome run_by(Mesh mesh, const DecimateTarget& target, const Priority& priority,
               const std::function<void(ModuleT&)>& set_up = nullptr) {
  return run<ByFunction<ModuleT>>(std::move(mesh), target, [&](ByFunction<ModuleT>& module) {
    module.priority = priority;
    if (set_up) set_up(module);
  });
}

/// Doesn't call what it overrides, before a collapse or after it.
template <class ModuleT, bool before>
class Forgetful : public ModuleT {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<Forgetful>;
  explicit Forgetful(Mesh& mesh) : ModuleT(mesh) {}
  void preprocess_collapse(const Info& collapse) override {
    if (!before) ModuleT::preprocess_collapse(collapse);
  }
  void postprocess_collapse(const Info& collapse) override {
    if (before) ModuleT::postprocess_collapse(collapse);
  }
};

template <class ModuleT>
void expect_that_calls_are_missed() {
  Mesh mesh = open_mesh<Mesh>(shape());
  PairDecimaterT<Mesh> decimater(mesh);
  if (!std::is_base_of_v<PairCostModuleT<Mesh>, ModuleT>) add_module<ModGarlandHeckbertT<Mesh>>(decimater);
  const std::string name = add_module<ModuleT>(decimater).name();
  ASSERT_TRUE(decimater.initialize());
  try {
    decimater.decimate();
    ADD_FAILURE() << name << " forgot a call";
  } catch (const std::logic_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(name));
  }
}

}  // namespace whittle::test::derived
