#pragma once

#include <exception>
#include <string>

#include "commands/page/live/live_moment.hh"
#include "terminal/interruption.hh"
#include "whittle/core/progress.hh"
#include "whittle/pipeline/plan.hh"

namespace whittle::app {

/// A page of a run, written again while the run goes on: about once a second, less often where that would take more
/// than a fifteenth of the time. Each time it appears complete, in place of the one before. Signals stay pending
/// meanwhile (`SignalsWait`): whatever ends the run, `end` is to be called, or the page to be replaced.
class LivePage {
 public:
  /// Writes the first page, which shows the input.
  /// \param plan, since_start must outlive this \param output the result's file, for the title
  /// \param force whether a file that is write-protected, or that the input needs, may be replaced
  /// \pre `has_page()` \throw io::WriteError; UsageError if the input needs the file
  LivePage(std::string path, const Plan& plan, const std::string& output, bool force, const Stopwatch& since_start);

  /// Writes the page if it is time to. \return false, to end the run, if that failed
  bool update(const RunProgress& progress);
  /// Throws again what made `update` fail, if it did.
  void throw_if_failed() const;
  /// Writes the page of what a run has come to. \throw io::WriteError
  void show(const IndexedMesh& mesh, const std::string& stage);
  /// Writes the last page of a run that failed. Nothing is done about a page that can't be written.
  void end(const std::string& problem);

 private:
  void set_now(const IndexedMesh& mesh);
  std::string page(const std::string& problem = {}) const;
  void write(const std::string& problem = {});

  SignalsWait signals_wait_;
  std::string path_;
  const Stopwatch& since_start_;
  std::string title_;
  std::string target_;
  LiveMesh input_;
  LiveMesh now_;
  std::string stage_;
  double fraction_ = 0;
  std::uint64_t n_faces_ = 0;
  double next_ = 0;  ///< when to write again, seconds since the start
  std::exception_ptr failure_;
};

}  // namespace whittle::app
