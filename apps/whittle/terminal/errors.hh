#pragma once

#include <stdexcept>
#include <string>

#include "whittle/scene/errors.hh"

namespace whittle::app {

/// The command line is invalid. `what()` names the option and the valid values. Exit status 2.
class UsageError : public std::runtime_error {
 public:
  explicit UsageError(const std::string& problem) : std::runtime_error(problem) {}
};

/// A signal asked the program to end. No file was left half-written.
class Interrupted : public std::exception {
 public:
  explicit Interrupted(int signal) : signal_(signal) {}
  const char* what() const noexcept override { return "interrupted"; }
  int signal() const { return signal_; }

 private:
  int signal_;
};

}  // namespace whittle::app
