// The connectivity after vertices were joined. It is valid and keeps every handle that can be kept. Without copies it
// is that of the joined mesh.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>  // before OpenMesh's headers, which use std::find without it

#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>
#include <whittle/openmesh/detail/bulk_collapse.hh>
#include <whittle/openmesh/detail/face_relinker.hh>
#include <whittle/openmesh/garbage_collection.hh>

#include "common/meshes.hh"
#include "common/same_mesh.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;
using testing::ElementsAre;
using testing::IsEmpty;

/// For each vertex the vertex that it is joined to, or itself. There are no chains.
using Joins = std::vector<Index>;

Joins no_joins(std::size_t n_vertices) {
  Joins joins(n_vertices);
  std::iota(joins.begin(), joins.end(), Index{0});
  return joins;
}

/// Joins two random vertices, related or not, `n` times.
Joins random_joins(std::size_t n_vertices, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Joins joins = no_joins(n_vertices);
  for (std::size_t i = 0; i < n && n_vertices > 0; ++i) {
    const Index from = joins[random.below(n_vertices)];
    const Index to = joins[random.below(n_vertices)];
    std::replace(joins.begin(), joins.end(), from, to);
  }
  return joins;
}

/// Joins vertices closer than `threshold` to each other.
Joins joins_within(const IndexedMesh& mesh, double threshold) {
  Joins joins = no_joins(mesh.positions.size());
  for (Index v = 0; v < joins.size(); ++v) {
    for (Index w = v + 1; w < joins.size(); ++w) {
      if ((mesh.positions[v] - mesh.positions[w]).norm() >= threshold) continue;
      std::replace(joins.begin(), joins.end(), Index{joins[w]}, Index{joins[v]});
    }
  }
  return joins;
}

struct Task {
  JoinedFaces joined;
  IndexedMesh expected;
};

/// \param joins of the vertices of `geometry_of(mesh)`
Task make_task(const DoubleMesh& mesh, const Joins& joins) {
  const IndexedMesh before = geometry_of(mesh);
  const auto handle = [&](Index v) { return before.origins.empty() ? v : before.origins[v]; };
  std::vector<Index> face_handles;
  for (const FaceHandle f : mesh.faces()) face_handles.push_back(static_cast<Index>(f.idx()));

  Task task;
  std::set<Index> left;
  for (Index f = 0; f < before.faces.size(); ++f) {
    Triangle face = before.faces[f];
    for (Index& v : face) v = joins[v];
    if (!has_three_corners(face)) continue;
    left.insert(face.begin(), face.end());
    task.joined.faces.push_back(face);
    task.joined.face_handles.push_back(face_handles[f]);
  }
  std::map<Index, Index> number;
  for (const Index v : left) {
    number[v] = static_cast<Index>(number.size());
    task.joined.vertex_handles.push_back(handle(v));
    task.expected.positions.push_back(before.positions[v]);
  }
  for (Triangle& face : task.joined.faces) {
    for (Index& v : face) v = number[v];
  }
  task.expected.faces = task.joined.faces;
  const std::vector<Index> numbers = detail::number_vertices(mesh, Copies::joined).number_of;
  task.joined.first_copies = first_copies(mesh);
  task.joined.vertex_of.assign(mesh.n_vertices(), invalid_index);
  for (const VertexHandle v : mesh.vertices()) {
    const auto place = static_cast<std::size_t>(v.idx());
    const auto it = number.find(joins[numbers[place]]);
    if (it != number.end() && !mesh.is_isolated(v)) task.joined.vertex_of[place] = it->second;
  }
  return task;
}

/// Properties of a mesh that identify its elements afterwards.
struct Labels {
  OpenMesh::VProp<int> vertex;
  OpenMesh::FProp<int> face;
  OpenMesh::EProp<std::pair<Index, Index>> edge;  // the vertices of `joined` at its ends

  Labels(DoubleMesh& mesh, const JoinedFaces& joined) : vertex(mesh), face(mesh), edge(mesh) {
    for (const VertexHandle v : mesh.vertices()) vertex[v] = v.idx();
    for (const FaceHandle f : mesh.faces()) face[f] = f.idx();
    for (const EdgeHandle e : mesh.edges()) {
      const auto end = [&](unsigned side) {
        return joined.vertex_of[static_cast<std::size_t>(mesh.to_vertex_handle(mesh.halfedge_handle(e, side)).idx())];
      };
      edge[e] = std::minmax(end(0), end(1));
    }
  }
};

void expect_manifold(const DoubleMesh& mesh, const std::string& context) {
  expect_sound(mesh, context);
  for (const VertexHandle v : mesh.vertices()) ASSERT_TRUE(mesh.is_manifold(v)) << context << ": vertex " << v.idx();
}

void expect_labels_kept(const DoubleMesh& mesh, const Labels& labels, const JoinedFaces& joined,
                        const std::vector<FaceRelinker::Copy>& copies, const std::string& context) {
  std::vector<Index> faces;
  for (const FaceHandle f : mesh.faces()) {
    faces.push_back(static_cast<Index>(f.idx()));
    EXPECT_EQ(labels.face[f], f.idx()) << context;
  }
  EXPECT_EQ(faces, joined.face_handles) << context;

  std::map<VertexHandle, Index> vertex_of;
  std::set<Index> own;
  for (const auto& [vertex, handle] : copies) {
    EXPECT_FALSE(mesh.status(handle).deleted()) << context;
    EXPECT_TRUE(vertex_of.emplace(handle, vertex).second) << context << ": two vertices with one handle";
    const auto first = static_cast<int>(joined.vertex_handles[vertex]);
    if (handle.idx() == first) own.insert(vertex);
    if (static_cast<std::size_t>(handle.idx()) >= joined.vertex_of.size()) {
      EXPECT_EQ(labels.vertex[handle], first) << context << ": a new copy hasn't the properties of the first";
    } else {
      EXPECT_EQ(labels.vertex[handle], handle.idx()) << context;
    }
  }
  EXPECT_EQ(own.size(), joined.vertex_handles.size()) << context << ": a vertex that is left lost its handle";

  for (const VertexHandle v : mesh.vertices()) {
    if (!mesh.is_isolated(v)) {
      EXPECT_TRUE(vertex_of.count(v)) << context << ": vertex " << v.idx();
    }
  }
  for (const EdgeHandle e : mesh.edges()) {
    const std::pair<Index, Index> ends = std::minmax(vertex_of[mesh.to_vertex_handle(mesh.halfedge_handle(e, 0))],
                                                     vertex_of[mesh.to_vertex_handle(mesh.halfedge_handle(e, 1))]);
    ASSERT_EQ(labels.edge[e], ends) << context << ": edge " << e.idx() << " was another";
  }
}

/// Joins vertices and checks everything that is promised.
void join_and_check(DoubleMesh& mesh, const Joins& joins, const std::string& context) {
  const Task task = make_task(mesh, joins);
  const Labels labels(mesh, task.joined);
  const auto copies = FaceRelinker(mesh, task.joined).run();
  expect_manifold(mesh, context);
  const IndexedMesh after = geometry_of(mesh);
  EXPECT_EQ(after.faces, task.expected.faces) << context;
  EXPECT_EQ(after.positions, task.expected.positions) << context;
  expect_labels_kept(mesh, labels, task.joined, copies, context);
}

/// Joins random vertices four times in succession. Before the last time garbage is collected.
void join_again_and_again(DoubleMesh mesh, std::size_t n_joins, std::uint64_t seed, const std::string& name) {
  for (int round = 1; round <= 4; ++round) {
    const std::string context = name + ", " + std::to_string(n_joins) + " joins, seed " + std::to_string(seed) +
                                ", round " + std::to_string(round);
    const std::size_t n_vertices = geometry_of(mesh).positions.size();
    join_and_check(mesh, random_joins(n_vertices, n_joins, seed + 100 * static_cast<std::uint64_t>(round)), context);
    if (round == 3) {
      const Topology before = topology(geometry_of(mesh));
      collect_garbage(mesh);
      expect_manifold(mesh, context + ", collected");
      EXPECT_EQ(topology(geometry_of(mesh)), before) << context << ", collected";
    }
  }
}

DoubleMesh cut_mesh_with_status(const IndexedMesh& shape) {
  DoubleMesh mesh;
  EXPECT_THAT(to_open_mesh(shape, mesh), IsEmpty());
  request_status(mesh);
  return mesh;
}

TEST(FaceRelinker, HoldsWhateverJoiningLeaves) {
  for (const auto& [name, shape] : all_meshes()) {
    const DoubleMesh mesh = cut_mesh_with_status(shape);
    for (const std::size_t n_joins : {std::size_t{1}, std::size_t{4}, shape.positions.size() / 4}) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) join_again_and_again(mesh, n_joins, seed, name);
    }
  }
}

TEST(FaceRelinker, HoldsWhatGluingWithinADistanceLeaves) {
  for (const double threshold : {0.05, 0.21, 0.5, 0.9, 2.5}) {
    for (const auto& [name, shape] : {NamedMesh{"boxes", boxes(4, 3)}, NamedMesh{"spheres", spheres(3, 2, 0.1)},
                                      NamedMesh{"grids", joined(grid(6, 6), moved(grid(6, 6), Vec3(0.1, 0.1, 0.1)))}}) {
      DoubleMesh mesh = cut_mesh_with_status(shape);
      const std::string context = name + " within " + std::to_string(threshold);
      join_and_check(mesh, joins_within(shape, threshold), context);
    }
  }
}

TEST(FaceRelinker, LeavesAMeshAloneWhereNothingIsJoined) {
  for (const auto& [name, shape] : holdable_meshes()) {
    DoubleMesh mesh = mesh_with_status(shape);
    bool is_manifold = true;
    for (const VertexHandle v : mesh.vertices()) is_manifold = is_manifold && mesh.is_manifold(v);
    if (!is_manifold) continue;
    const DoubleMesh before = mesh;
    const Task task = make_task(mesh, no_joins(shape.positions.size()));
    FaceRelinker(mesh, task.joined).run();
    expect_same_mesh(before, mesh, name);
    EXPECT_FALSE(find_copies_property(mesh).is_valid()) << name;
    for (const VertexHandle v : mesh.vertices()) EXPECT_EQ(mesh.halfedge_handle(v), before.halfedge_handle(v)) << name;
  }
}

TEST(FaceRelinker, LeavesCopiesAloneWhereNothingIsJoined) {
  for (const auto& [name, shape] : nonmanifold_meshes()) {
    DoubleMesh mesh = cut_mesh_with_status(shape);
    const DoubleMesh before = mesh;
    FaceRelinker(mesh, make_task(mesh, no_joins(shape.positions.size())).joined).run();
    expect_same_mesh(before, mesh, name);
    EXPECT_EQ(first_copies(mesh), first_copies(before)) << name;
  }
}

TEST(FaceRelinker, ACornerThatTouchesIsTwoVerticesWithTheSameProperties) {
  DoubleMesh mesh = cut_mesh_with_status(joined(tetrahedron(), moved(tetrahedron(), Vec3(5, 0, 0))));
  mesh.request_vertex_colors();
  mesh.set_color(VertexHandle(2), {1, 2, 3});
  mesh.status(VertexHandle(2)).set_tagged(true);
  Joins joins = no_joins(8);
  joins[5] = 2;
  const auto copies = FaceRelinker(mesh, make_task(mesh, joins).joined).run();
  EXPECT_EQ(copies.size(), 8U);
  ASSERT_EQ(mesh.n_vertices(), 9U);
  EXPECT_TRUE(mesh.status(VertexHandle(5)).deleted());
  const VertexHandle added(8);
  EXPECT_EQ(mesh.point(added), mesh.point(VertexHandle(2)));
  EXPECT_EQ(mesh.color(added), mesh.color(VertexHandle(2)));
  EXPECT_TRUE(mesh.status(added).tagged());
  EXPECT_EQ(mesh.valence(added), 3U);
  const auto property = find_copies_property(mesh);
  ASSERT_TRUE(property.is_valid());
  for (const VertexHandle v : mesh.vertices()) {
    EXPECT_EQ(mesh.property(property, v), v == added || v.idx() == 2 ? 1 : 0) << v.idx();
  }
  for (const EdgeHandle e : mesh.edges()) EXPECT_LT(e.idx(), 12) << "an edge was made for nothing";
}

TEST(FaceRelinker, AFinSpreadsToBothSidesOfTheEdgeItIsJoinedTo) {
  // The two triangles of a square, and a third on the diagonal.
  IndexedMesh shape = grid(1, 1);
  const Triangle first = shape.faces[0];
  for (const Vec3& p : {Vec3(0, 0, 1), Vec3(1, 1, 1), Vec3(0.5, 0.5, 2)}) shape.positions.push_back(p);
  shape.faces.push_back({4, 5, 6});
  DoubleMesh mesh = cut_mesh_with_status(shape);
  EdgeHandle diagonal;
  for (const EdgeHandle e : mesh.edges()) {
    if (!mesh.is_boundary(e)) diagonal = e;
  }
  OpenMesh::EProp<int> label(mesh);
  label[diagonal] = 7;
  mesh.status(diagonal).set_feature(true);
  const int a = mesh.to_vertex_handle(mesh.halfedge_handle(diagonal, 0)).idx();
  const int b = mesh.to_vertex_handle(mesh.halfedge_handle(diagonal, 1)).idx();
  Joins joins = no_joins(7);
  joins[4] = static_cast<Index>(a);
  joins[5] = static_cast<Index>(b);
  join_and_check(mesh, joins, "fin");
  EXPECT_FALSE(mesh.status(diagonal).deleted());
  int n_features = 0;
  int n_labels = 0;
  for (const EdgeHandle e : mesh.edges()) {
    n_features += mesh.status(e).feature();
    n_labels += label[e] == 7;
  }
  EXPECT_EQ(n_features, 3) << "the edges of all three faces";
  EXPECT_EQ(n_labels, 2) << "the diagonal, and the one made of it";
  EXPECT_EQ(mesh.face_handle(mesh.halfedge_handle(FaceHandle(0))), FaceHandle(0));
  EXPECT_EQ(geometry_of(mesh).faces[0], first);
}

TEST(FaceRelinker, OfLegalCollapsesLeavesTheSameFacesAsTheyDo) {
  const DoubleMesh mesh = mesh_with_status(noisy_torus(20, 12, 1, 0.4, 0.03, 9));
  const std::size_t n = mesh.n_vertices();
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    std::vector<VertexMerge> merges;
    Joins joins = no_joins(n);
    DoubleMesh one_by_one = mesh;
    while (merges.size() < n / 2) {
      const HalfedgeHandle h(static_cast<int>(random.below(mesh.n_halfedges())));
      if (one_by_one.status(one_by_one.edge_handle(h)).deleted() || !one_by_one.is_collapse_ok(h)) continue;
      merges.push_back({one_by_one.from_vertex_handle(h), one_by_one.to_vertex_handle(h)});
      one_by_one.collapse(h);
      std::replace(joins.begin(), joins.end(), static_cast<Index>(merges.back().removed.idx()),
                   static_cast<Index>(merges.back().survivor.idx()));
    }
    DoubleMesh relinked = mesh;
    join_and_check(relinked, joins, "seed " + std::to_string(seed));
    EXPECT_EQ(relinked.n_vertices(), n) << "nothing had to be cut";
    EXPECT_EQ(geometry_of(relinked).positions, geometry_of(one_by_one).positions);
    for (const FaceHandle f : mesh.all_faces()) {
      ASSERT_EQ(relinked.status(f).deleted(), one_by_one.status(f).deleted());
      if (relinked.status(f).deleted()) continue;
      auto corners = face_corners(relinked, f);
      const auto expected = face_corners(one_by_one, f);
      std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), expected[0]), corners.end());
      EXPECT_EQ(corners, expected) << f.idx();
    }
    int n_edges = 0;
    for ([[maybe_unused]] const EdgeHandle e : one_by_one.edges()) ++n_edges;
    for ([[maybe_unused]] const EdgeHandle e : relinked.edges()) --n_edges;
    EXPECT_EQ(n_edges, 0);
  }
}

TEST(FaceRelinker, LeavesIsolatedVerticesAlone) {
  const IndexedMesh shape = with_isolated_vertices(boxes(2, 1), 5, 3);
  DoubleMesh mesh = cut_mesh_with_status(shape);
  std::set<int> isolated;
  for (const VertexHandle v : mesh.vertices()) {
    if (mesh.is_isolated(v)) isolated.insert(v.idx());
  }
  Task task = make_task(mesh, joins_within(shape, 0.21));
  FaceRelinker(mesh, task.joined).run();
  EXPECT_EQ(isolated.size(), 5U);
  for (const int v : isolated) EXPECT_FALSE(mesh.status(VertexHandle(v)).deleted());
  expect_manifold(mesh, "boxes");
}

}  // namespace
}  // namespace whittle::test
