// Numbers of vertices that name things are never blended, and other numbers stay in the range of those around.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/program.hh"
#include "whittle/engine/cost_traits.hh"
#include "whittle/io/read.hh"

namespace whittle::test {
namespace {

using testing::HasSubstr;

/// A wavy sheet with three numbers at each vertex: an id, a class that is missing somewhere, and a step.
std::string sheet_with_numbers(const std::string& id, const std::string& type) {
  constexpr int n = 24;
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(n * n) +
                     "\nproperty float x\nproperty float y\nproperty float z\nproperty " + type + " " + id +
                     "\nproperty float scalar_Classification\nproperty float step\nelement face " +
                     std::to_string(2 * (n - 1) * (n - 1)) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const std::string number = std::to_string(100 * (x / 6) + 7);
      const std::string step = 2 * x + y < n ? "0.25" : "1.25";
      text += std::to_string(x) + " " + std::to_string(y) + " " +
              std::to_string(std::sin(0.4 * x) * std::cos(0.3 * y)) + " " + number + " " + (y == 0 ? "nan" : number) +
              " " + step + "\n";
    }
  }
  for (int y = 0; y + 1 < n; ++y) {
    for (int x = 0; x + 1 < n; ++x) {
      const int a = y * n + x;
      const auto face = [](int u, int v, int w) {
        return "3 " + std::to_string(u) + " " + std::to_string(v) + " " + std::to_string(w) + "\n";
      };
      text += face(a, a + 1, a + n + 1) + face(a, a + n + 1, a + n);
    }
  }
  return text;
}

/// How many numbers of a mesh are none of the sheet's, or a step beyond its ends.
std::size_t n_new_numbers(const std::string& path) {
  const IndexedMesh mesh = io::read_mesh(path).mesh;
  std::size_t n = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (const double x : mesh.attributes.at(i).values) {
      const bool is_one = x == 7 || x == 107 || x == 207 || x == 307 || (i == 1 && std::isnan(x));
      n += i == 2 ? x < 0.25 || x > 1.25 : !is_one;
    }
  }
  return n;
}

class Categories : public testing::Test {
 protected:
  Outcome done(const std::vector<std::string>& arguments) {
    Outcome outcome = whittle(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    return outcome;
  }

  TemporaryFolder folder_;
  std::string in_ = folder_ / "in.ply";
  std::string out_ = folder_ / "out.ply";
};

TEST_F(Categories, AreNeverBlended) {
  for (const std::string id : {"_FEATURE_ID_0", "_BATCHID", "soil"}) {
    for (const std::string type : {"float", "int"}) {
      write_text(in_, sheet_with_numbers(id, type));
      for (const std::string effort : {"fast", "normal", "best"}) {
        for (const CostTraits& traits : all_cost_traits) {
          const std::string cost(traits.name);
          done({"simplify", in_, "-o", out_, "--faces", "150", "--effort", effort, "--cost", cost});
          EXPECT_EQ(n_new_numbers(out_), 0U) << id << ", " << type << ", " << effort << ", " << cost;
        }
      }
    }
  }
}

TEST_F(Categories, AreNeverBlendedByOtherCommands) {
  write_text(in_, sheet_with_numbers("soil", "float"));
  const std::string recording = folder_ / "run.whittle";
  done({"simplify", in_, "-o", out_, "--faces", "150", "--record", recording});
  EXPECT_EQ(n_new_numbers(out_), 0U);
  const std::string level = folder_ / "level.ply";
  for (const std::string faces : {"150", "400"}) {
    done({"replay", recording, "-o", level, "--faces", faces});
    EXPECT_EQ(n_new_numbers(level), 0U) << faces;
  }
  done({"polish", in_, out_, "-o", level});
  EXPECT_EQ(n_new_numbers(level), 0U);
  done({"lod", in_, "--ratios", "0.3,0.1", "-o", folder_ / "lod_{i}.ply"});
  for (const std::string i : {"0", "1"}) EXPECT_EQ(n_new_numbers(folder_ / ("lod_" + i + ".ply")), 0U) << i;
}

TEST_F(Categories, AreChosenByName) {
  write_text(in_, sheet_with_numbers("soil", "float"));
  const auto simplify = [&](const std::string& categories) {
    return whittle({"simplify", in_, "-o", out_, "--faces", "150", "--json", "-", "--categories", categories});
  };
  EXPECT_EQ(parse_json(simplify("auto").out)["options"]["categories"], "auto");
  EXPECT_EQ(n_new_numbers(out_), 0U);
  EXPECT_EQ(parse_json(simplify("none").out)["options"]["categories"], "none");
  EXPECT_GT(n_new_numbers(out_), 0U) << "all are blended";
  const auto n_steps_between = [&] {
    const std::vector<double> steps = io::read_mesh(out_).mesh.attributes.at(2).values;
    return std::count_if(steps.begin(), steps.end(), [](double x) { return x != 0.25 && x != 1.25; });
  };
  EXPECT_GT(n_steps_between(), 0);
  EXPECT_EQ(simplify("soil,scalar_Classification,step").exit_code, 0);
  EXPECT_EQ(n_steps_between(), 0);
  expect_failure(simplify("owner"), 4,
                 {"vertices have no numbers 'owner' for --categories; they have soil, scalar_Classification, step"});
  EXPECT_THAT(simplify("soil,").err, HasSubstr("a name is empty"));
}

}  // namespace
}  // namespace whittle::test
