#pragma once

#include <chrono>
#include <cstddef>
#include <utility>
#include <vector>

namespace whittle::detail {

/// While it lives, times the parallel sections (`for_each_block`) that its thread begins, and each block of them, to
/// predict a run on more cores. A section within a block is a part of that block. For benchmarks.
class SectionTrace {
 public:
  struct Section {
    double seconds = 0;          ///< wall-clock time, from beginning to end
    std::vector<double> blocks;  ///< seconds, in the order in which they are taken
  };

  SectionTrace() : outer_(std::exchange(current_of_thread, this)) {}
  ~SectionTrace() { current_of_thread = outer_; }
  SectionTrace(const SectionTrace&) = delete;
  SectionTrace& operator=(const SectionTrace&) = delete;

  const std::vector<Section>& sections() const { return sections_; }

 private:
  friend class TracedSection;

  static inline thread_local SectionTrace* current_of_thread = nullptr;
  SectionTrace* outer_;
  std::vector<Section> sections_;
};

/// A parallel section, for the trace, if any, of the thread that begins it.
class TracedSection {
 public:
  explicit TracedSection(std::size_t n_blocks) : trace_(std::exchange(SectionTrace::current_of_thread, nullptr)) {
    if (trace_ != nullptr) section_.blocks.resize(n_blocks);
  }
  ~TracedSection() {
    if (trace_ == nullptr) return;
    section_.seconds = seconds_since(begin_);
    trace_->sections_.push_back(std::move(section_));
    SectionTrace::current_of_thread = trace_;
  }
  TracedSection(const TracedSection&) = delete;
  TracedSection& operator=(const TracedSection&) = delete;

  /// Any thread may run a block, each once.
  template <class Work>
  void run(std::size_t block, const Work& work) {
    if (trace_ == nullptr) return work(block);
    const Clock::time_point begin = Clock::now();
    work(block);
    section_.blocks[block] = seconds_since(begin);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }

  SectionTrace* trace_;
  SectionTrace::Section section_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace whittle::detail
