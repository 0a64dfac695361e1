#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <string>

#include "whittle/web/job.hh"

// What JavaScript calls. There is one job at a time; its arrays are filled and read in the memory of the module. Errors
// are exceptions (support/exceptions.cc), which end the instance.

#define WHITTLE_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace whittle::web::exported {
namespace {

std::unique_ptr<Job> job;
std::string name;  ///< of an option or attribute; its bytes are written by JavaScript
std::string word;  ///< a value

/// Tells JavaScript how far the work is, which may throw. \param stage 0: contracting, 1: polish
__attribute__((import_module("whittle"), import_name("progress"))) void tell_progress(double fraction, int stage,
                                                                                      double n_faces);

void listen_to_progress() {
  job->settings.options.decimate.progress = [](const Progress& progress) {
    tell_progress(progress.fraction, static_cast<int>(progress.stage), static_cast<double>(progress.n_faces));
    return true;
  };
}

/// Makes the memory grow at once to about what a run takes: in many small steps that takes as long as the run.
void reserve_memory(std::size_t n_faces) {
  constexpr std::size_t bytes_per_face = 512;
  constexpr std::size_t most_faces = 2'000'000;  // a GiB; with less memory than that the run may do, too
  void* const all = std::malloc(bytes_per_face * std::min(n_faces, most_faces));
  asm volatile("" : : "r"(all));  // else both calls are left out
  std::free(all);
}

}  // namespace

WHITTLE_EXPORT(begin) void begin(std::size_t n_vertices, std::size_t n_faces, bool tells_progress) {
  job = std::make_unique<Job>();
  reserve_memory(n_faces);
  job->mesh.positions.resize(n_vertices);
  job->mesh.faces.resize(n_faces);
  if (tells_progress) listen_to_progress();
}
WHITTLE_EXPORT(end) void end() { job.reset(); }

WHITTLE_EXPORT(name_of) char* name_of(std::size_t length) {
  name.resize(length);
  return name.data();
}
WHITTLE_EXPORT(word_of) char* word_of(std::size_t length) {
  word.resize(length);
  return word.data();
}
WHITTLE_EXPORT(option) void option(double number, bool is_percent) {
  set_option(name, {word, number, is_percent}, job->settings);
}

WHITTLE_EXPORT(positions) double* positions() { return job->mesh.positions.data()->data(); }
WHITTLE_EXPORT(faces) Index* faces() { return job->mesh.faces.data()->data(); }
WHITTLE_EXPORT(normals) float* normals() {
  job->mesh.normals.resize(job->mesh.positions.size());
  return job->mesh.normals.data()->data();
}
WHITTLE_EXPORT(locked) std::uint8_t* locked() {
  job->locked.resize(job->mesh.positions.size());
  return job->locked.data();
}
WHITTLE_EXPORT(groups) Index* groups(std::size_t n_groups) {
  job->mesh.face_groups.resize(job->mesh.faces.size());
  for (std::size_t i = 0; i < n_groups; ++i) job->mesh.group_names.push_back(std::to_string(i));
  return job->mesh.face_groups.data();
}
/// \param kind a number of `AttributeKind`; the name is the last that was written
WHITTLE_EXPORT(attribute) double* attribute(int kind, std::size_t n_components) {
  const std::uint64_t n_values = std::uint64_t{n_components} * job->mesh.positions.size();
  if (n_values > SIZE_MAX / sizeof(double)) throw std::bad_alloc();
  Attribute& added = job->mesh.attributes.emplace_back();
  added.name = name;
  added.kind = static_cast<AttributeKind>(kind);
  added.n_components = n_components;
  added.values.resize(static_cast<std::size_t>(n_values));
  return added.values.data();
}
WHITTLE_EXPORT(level) void level(double n_faces) { job->levels.push_back(static_cast<std::uint64_t>(n_faces)); }

WHITTLE_EXPORT(simplify) void simplify() { job->simplify(); }
WHITTLE_EXPORT(record) void record() { job->record(); }
WHITTLE_EXPORT(take_level) void take_level(double n, bool counts_vertices) {
  job->take_level(static_cast<std::uint64_t>(n), counts_vertices);
}
WHITTLE_EXPORT(simplify_indices) double simplify_indices(std::size_t n_faces, double max_distance, bool opens_seams) {
  return job->simplify_indices(n_faces, max_distance, opens_seams);
}

WHITTLE_EXPORT(n_results) std::size_t n_results() { return job->results.size(); }
WHITTLE_EXPORT(result_size) std::size_t result_size(std::size_t i) { return job->results[i].positions.size(); }
WHITTLE_EXPORT(result_n_faces) std::size_t result_n_faces(std::size_t i) { return job->results[i].faces.size(); }
WHITTLE_EXPORT(result_positions) const double* result_positions(std::size_t i) {
  return job->results[i].positions.data()->data();
}
WHITTLE_EXPORT(result_faces) const Index* result_faces(std::size_t i) { return job->results[i].faces.data()->data(); }
WHITTLE_EXPORT(result_origins) const Index* result_origins(std::size_t i) { return job->results[i].origins.data(); }
WHITTLE_EXPORT(result_normals) const float* result_normals(std::size_t i) {
  return job->results[i].normals.empty() ? nullptr : job->results[i].normals.data()->data();
}
WHITTLE_EXPORT(result_groups) const Index* result_groups(std::size_t i) { return job->results[i].face_groups.data(); }
WHITTLE_EXPORT(result_attribute) const double* result_attribute(std::size_t i, std::size_t which) {
  return job->results[i].attributes[which].values.data();
}
WHITTLE_EXPORT(vertex_map) const Index* vertex_map() { return job->vertex_map.data(); }
WHITTLE_EXPORT(face_origins) const Index* face_origins() { return job->face_origins.data(); }
WHITTLE_EXPORT(report) const JobReport* report() { return &job->report; }
WHITTLE_EXPORT(option_names) const char* list_options() { return option_names().data(); }

}  // namespace whittle::web::exported
