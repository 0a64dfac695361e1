#include "fuzz/targets.hh"

#include <stdexcept>
#include <string>

namespace whittle::test {

std::vector<NamedTarget> library_targets() {
  std::vector<NamedTarget> targets{
      {"decimate", fuzz_decimate}, {"polish", fuzz_polish}, {"metrics", fuzz_metrics}, {"steps", fuzz_steps}};
  targets.reserve(targets.size() + io::all_formats.size());
  for (const io::Format format : io::all_formats) {
    targets.push_back({io::name_of(format), [format](std::string_view bytes) { fuzz_reader(bytes, format); }});
  }
  return targets;
}

FuzzTarget library_target(std::string_view name) {
  for (const NamedTarget& target : library_targets()) {
    if (target.name == name) return target.run;
  }
  throw std::out_of_range("no fuzz target " + std::string(name));
}

}  // namespace whittle::test
