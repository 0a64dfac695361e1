// Does natively what the package does in WebAssembly, to compare bytes: native_job FOLDER NAME=VALUE...
// With times=N it runs N times more, and prints the median in milliseconds.
// FOLDER has positions and indices, maybe normals, uv and groups, each in a file of raw numbers. Writes the result's
// there.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "whittle/web/job.hh"

namespace {

using whittle::web::Job;

template <class T>
std::vector<T> read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(static_cast<void*>(values.data()), bytes.data(), values.size() * sizeof(T));
  return values;
}

template <class T>
void write(const std::string& path, const std::vector<T>& values) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
}

void set(const std::string& given, Job& job) {
  const std::size_t equals = given.find('=');
  const std::string value = given.substr(equals + 1);
  const bool is_percent = value.back() == '%';
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  set_option(given.substr(0, equals), {value, end == value.c_str() ? std::nan("") : number, is_percent}, job.settings);
}

double milliseconds_of(Job& job) {
  const auto start = std::chrono::steady_clock::now();
  job.simplify();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main(int n_arguments, char** arguments) {
  const std::string folder = arguments[1];
  Job job;
  job.mesh.positions = read<whittle::Vec3>(folder + "/positions");
  job.mesh.faces = read<whittle::Triangle>(folder + "/indices");
  job.mesh.normals = read<std::array<float, 3>>(folder + "/normals");
  if (std::vector<double> uv = read<double>(folder + "/uv"); !uv.empty()) {
    job.mesh.attributes.push_back({"uv", whittle::AttributeKind::texcoord, 2, std::move(uv)});
  }
  job.mesh.face_groups = read<whittle::Index>(folder + "/groups");
  for (const whittle::Index group : job.mesh.face_groups) {
    while (job.mesh.group_names.size() <= group) {
      job.mesh.group_names.push_back(std::to_string(job.mesh.group_names.size()));
    }
  }
  int n_times = 0;
  for (int i = 2; i < n_arguments; ++i) {
    const std::string given = arguments[i];
    if (given.starts_with("times=")) {
      n_times = std::atoi(given.c_str() + 6);
    } else {
      set(given, job);
    }
  }
  try {
    job.simplify();
    std::vector<double> times;
    for (int i = 0; i < n_times; ++i) times.push_back(milliseconds_of(job));
    std::sort(times.begin(), times.end());
    if (!times.empty()) std::cout << times[times.size() / 2] << '\n';
  } catch (const std::exception& problem) {
    std::cout << problem.what() << '\n';
    return 1;
  }
  const whittle::IndexedMesh& result = job.results.front();
  write(folder + "/result_positions", result.positions);
  write(folder + "/result_indices", result.faces);
  write(folder + "/result_normals", result.normals);
  if (!result.attributes.empty()) write(folder + "/result_uv", result.attributes.front().values);
  write(folder + "/result_vertex_map", job.vertex_map);
  write(folder + "/result_face_origins", job.face_origins);
  return 0;
}
