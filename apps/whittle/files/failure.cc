#include "files/failure.hh"

#include <exception>
#include <new>

#include "terminal/errors.hh"
#include "whittle/io/errors.hh"

namespace whittle::app {

Failure current_failure() {
  try {
    throw;
  } catch (const Interrupted&) {
    throw;
  } catch (const UsageError& error) {
    return {ExitCode::usage, error.what()};
  } catch (const io::OutputConflict& error) {
    return {ExitCode::usage, error.what()};
  } catch (const io::ReadError& error) {
    return {ExitCode::unreadable, error.what()};
  } catch (const UnsupportedMesh& error) {
    return {ExitCode::unreadable, error.what()};
  } catch (const std::bad_alloc&) {
    return {ExitCode::failure, "out of memory; try a machine with more, or a smaller part of the mesh"};
  } catch (const std::exception& error) {
    return {ExitCode::failure, error.what()};
  }
}

}  // namespace whittle::app
