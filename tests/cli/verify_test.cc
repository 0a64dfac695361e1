// `whittle verify`, with certificates of `whittle simplify`.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

using Arguments = std::vector<std::string>;

Arguments joined(Arguments first, const Arguments& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

double diagonal_of_file(const std::string& path) { return diagonal_of(io::read_mesh(path).mesh.positions); }

/// A mesh, its result and the certificate of both.
class VerifyCommand : public ::testing::Test {
 protected:
  void simplify(const std::string& input, const Arguments& options, const std::string& output = "out.ply") {
    input_ = input;
    output_ = folder_ / output;
    const Outcome outcome =
        whittle(joined({"simplify", input_, "-o", output_, "--certificate", proof_, "--quiet"}, options));
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
  }
  Outcome verify(const Arguments& options = {}) const {
    return whittle(joined({"verify", input_, output_, proof_}, options));
  }
  nlohmann::json report(const Arguments& options = {}) const {
    return parse_json(verify(joined({"--json", "-"}, options)).out);
  }

  TemporaryFolder folder_;
  std::string input_;
  std::string output_;
  std::string proof_ = folder_ / "proof";
};

TEST_F(VerifyCommand, SaysWhatIsProven) {
  simplify(data_file("blob.obj"), {"--max-error", "0.5%"});
  const double limit = 0.005 * diagonal_of_file(input_);
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(outcome.err, "") << outcome;
  EXPECT_EQ(outcome.out.rfind("the certificate holds\neach point of " + input_ + " is within ", 0), 0U) << outcome;
  EXPECT_NE(outcome.out.find(" (0.5 %) of " + output_ + ", and each point of " + output_ + " of " + input_),
            std::string::npos)
      << outcome;
  const nlohmann::json json = report();
  EXPECT_EQ(json["holds"], true);
  EXPECT_NEAR(json["max_error"].get<double>(), limit, 1e-12 * limit);
  EXPECT_NEAR(json["max_error_rel"].get<double>(), 0.005, 1e-12);
  EXPECT_EQ(json["tolerances"], 0);
  EXPECT_EQ(json["why_not"], nullptr);
  EXPECT_EQ(json["malformed"], false);
  EXPECT_EQ(json["certificate"]["bytes"], std::filesystem::file_size(proof_));
  EXPECT_EQ(json["input"]["faces"], io::read_mesh(input_).mesh.faces.size());
  EXPECT_EQ(json["output"]["faces"], io::read_mesh(output_).mesh.faces.size());
}

TEST_F(VerifyCommand, TakesEachFormat) {
  struct Written {
    std::string name;
    Arguments options;
  };
  for (const Written& written : {Written{"out.ply", {}}, Written{"out.ply", {"--ascii"}}, Written{"out.stl", {}},
                                 Written{"out.stl", {"--ascii"}}, Written{"out.obj", {}}, Written{"out.off.gz", {}}}) {
    SCOPED_TRACE(written.name);
    simplify(data_file("blob.obj"), joined({"--max-error", "1%"}, written.options), written.name);
    const Outcome outcome = verify({"--max-error", "1%"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
  }
  simplify(data_file("bracket.stl"), {"--faces", "200"}, "out.obj");
  EXPECT_EQ(verify().exit_code, 0) << verify();
}

TEST_F(VerifyCommand, ReadsTheInputAsTheRunHasReadIt) {
  const std::string input = folder_ / "gaps.stl";
  IndexedMesh mesh = blob(3, 1);
  IndexedMesh apart;
  for (const Triangle& face : mesh.faces) {  // each corner a little elsewhere
    const auto first = static_cast<Index>(apart.positions.size());
    for (Index c = 0; c < 3; ++c) apart.positions.push_back(mesh.positions[face[c]] * (1 + 1e-5 * (first % 7 + c)));
    apart.faces.push_back({first, first + 1, first + 2});
  }
  io::write_mesh(input, apart);
  simplify(input, {"--face-ratio", "50%", "--weld", "0.1%"}, "out.stl");
  EXPECT_EQ(verify({"--weld", "0.1%"}).exit_code, 0) << verify({"--weld", "0.1%"});
  expect_failure(verify({"--quiet"}), 1, {proof_ + ": does not hold for ", "it is about other meshes: IN "});
  expect_failure(verify({"--quiet", "--no-weld"}), 1, {"it is about other meshes: IN "});
}

TEST_F(VerifyCommand, KeepsDuplicatesApartInBothMeshes) {
  for (const std::string output : {"out.stl", "out.ply"}) {
    SCOPED_TRACE(output);
    simplify(data_file("bracket.stl"), {"--max-error", "1%", "--no-weld"}, output);
    EXPECT_EQ(verify({"--no-weld"}).exit_code, 0) << verify({"--no-weld"});
    expect_failure(verify({"--quiet"}), 1, {"it is about other meshes: IN "});
  }
}

TEST_F(VerifyCommand, ReadsOneMeshFromStandardInput) {
  simplify(data_file("blob.obj"), {"--faces", "500"});
  RunOptions from_input;
  from_input.input = read_text(input_);
  EXPECT_EQ(whittle({"verify", "-", output_, proof_, "--format", "obj"}, from_input).exit_code, 0);
  from_input.input = read_text(output_);
  EXPECT_EQ(whittle({"verify", input_, "-", proof_, "--format", "ply"}, from_input).exit_code, 0);
}

TEST_F(VerifyCommand, TellsOfBorders) {
  simplify(data_file("terrain.ply"), {"--max-error", "1%", "--max-error-borders", "0.2%"});
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_NE(outcome.out.find("each point of the border of " + input_ + " is within "), std::string::npos) << outcome;
  EXPECT_NE(outcome.out.find(" (0.2 %) of the border of " + output_), std::string::npos) << outcome;
  EXPECT_NEAR(report()["max_error_borders_rel"].get<double>(), 0.002, 1e-12);

  simplify(data_file("blob.obj"), {"--faces", "500"});
  EXPECT_NE(verify().out.find("nothing is proven of borders"), std::string::npos) << verify();
  EXPECT_EQ(report()["max_error_borders"], nullptr);
}

TEST_F(VerifyCommand, TellsOfTolerances) {
  const std::string input = data_file("blob.obj");
  std::string lines;
  const IndexedMesh mesh = io::read_mesh(input).mesh;
  for (const Vec3& p : mesh.positions) lines += p.x() < 0 ? "0.5%\n" : "100\n";
  write_text(folder_ / "tolerances", lines);
  simplify(input, {"--max-error", "1%", "--tolerance-map", folder_ / "tolerances"});
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_NE(outcome.out.find(std::to_string(mesh.positions.size()) + " vertices of " + input + " with a tolerance"),
            std::string::npos)
      << outcome;
  EXPECT_EQ(report()["tolerances"], mesh.positions.size());
}

TEST_F(VerifyCommand, FailsIfLessIsProvenThanAsked) {
  simplify(data_file("terrain.ply"), {"--max-error", "1%", "--max-error-borders", "0.5%"});
  EXPECT_EQ(verify({"--max-error", "1%", "--max-error-borders", "0.5%"}).exit_code, 0);
  const auto exit_code = [&](const Arguments& options) { return verify(options).exit_code; };
  EXPECT_EQ(exit_code({"--max-error", "0.99%"}), 1);
  EXPECT_EQ(exit_code({"--max-error-borders", "0.49%"}), 1);
  EXPECT_EQ(exit_code({"--max-error", std::to_string(0.011 * diagonal_of_file(input_))}), 0);
  const Outcome outcome = verify({"-e", "0.5%"});
  EXPECT_NE(outcome.out.find("the certificate holds"), std::string::npos) << outcome;
  EXPECT_EQ(outcome.err.rfind("whittle: " + proof_ + ": ", 0), 0U) << outcome;
  EXPECT_NE(outcome.err.find("(0.5 %) is asked at most, and "), std::string::npos) << outcome;
  EXPECT_NE(outcome.err.find("(1 %) is proven"), std::string::npos) << outcome;
  const nlohmann::json json = report({"-e", "0.5%"});
  EXPECT_EQ(json["holds"], true);
  EXPECT_EQ(json["asked"]["met"], false);
  EXPECT_NEAR(json["asked"]["max_error"].get<double>(), 0.005 * diagonal_of_file(input_), 1e-12);
  EXPECT_EQ(json["asked"]["max_error_borders"], nullptr);

  simplify(data_file("blob.obj"), {"--faces", "500"});
  EXPECT_NE(verify({"--max-error-borders", "1"}).err.find("nothing is proven"), std::string::npos);
}

TEST_F(VerifyCommand, RefusesAnotherMesh) {
  const std::string input = data_file("blob.obj");
  simplify(input, {"--faces", "500"});
  const std::string other = folder_ / "other.ply";
  IndexedMesh mesh = io::read_mesh(output_).mesh;
  mesh.positions[7] *= 1.5;
  io::write_mesh(other, mesh);
  expect_failure(whittle({"verify", input, other, proof_}), 1,
                 {proof_ + ": does not hold for " + input + " and " + other + ": ", "face"});
  expect_failure(whittle({"verify", output_, input, proof_}), 1, {"it is about other meshes: IN "});
  expect_failure(whittle({"verify", input, input, proof_}), 1, {"it is about other meshes: OUT "});
  output_ = other;
  const nlohmann::json json = report();
  EXPECT_EQ(json["holds"], false);
  EXPECT_EQ(json["max_error"], nullptr);
  EXPECT_EQ(json["malformed"], false);
  EXPECT_EQ(json["asked"]["met"], false);
  EXPECT_TRUE(json["why_not"].is_string()) << json;
}

TEST_F(VerifyCommand, RefusesWhatIsNoCertificate) {
  simplify(data_file("blob.obj"), {"--faces", "500"});
  const std::string whole = read_text(proof_);
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{21}, std::size_t{50}, whole.size() / 2, whole.size() - 1}) {
    write_text(proof_, whole.substr(0, length));
    expect_failure(verify(), 4, {proof_ + ": no whole certificate: "});
  }
  write_text(proof_, whole + '\n');
  expect_failure(verify(), 4, {"bytes follow the last proof"});
  EXPECT_EQ(report()["malformed"], true);
  std::swap(proof_, output_);
  EXPECT_EQ(verify().exit_code, 4) << "a certificate in place of a mesh";
}

TEST_F(VerifyCommand, EndsWithFourIfAFileIsMissing) {
  simplify(data_file("blob.obj"), {"--faces", "500"});
  expect_failure(whittle({"verify", input_, output_, folder_ / "missing"}), 4, {"missing: cannot be opened"});
  expect_failure(whittle({"verify", input_, output_, folder_.path().string()}), 4, {folder_.path().string() + ": "});
  expect_failure(whittle({"verify", input_, folder_ / "missing.ply", proof_}), 4, {"missing.ply"});
  expect_failure(whittle({"verify", folder_ / "missing.ply", output_, proof_}), 4, {"missing.ply"});
}

TEST_F(VerifyCommand, WritesNoReportOverItsInputs) {
  simplify(data_file("blob.obj"), {"--faces", "500"});
  for (const std::string& path : {output_, proof_}) {
    expect_failure(verify({"--json", path}), 2, {"--json", "--force"});
  }
  EXPECT_EQ(verify({"--json", folder_ / "report"}).exit_code, 0);
  EXPECT_EQ(parse_json(read_text(folder_ / "report"))["holds"], true);
}

TEST_F(VerifyCommand, SaysTheSameOnAnyThreads) {
  simplify(data_file("knot.ply"), {"--face-ratio", "10%"});
  const Outcome one = verify({"--threads", "1"});
  EXPECT_EQ(one.exit_code, 0) << one;
  EXPECT_EQ(verify({"--threads", "3"}).out, one.out);
}

}  // namespace
}  // namespace whittle::test
