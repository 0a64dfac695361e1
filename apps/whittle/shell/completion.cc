#include "shell/completion.hh"

namespace whittle::app {

std::string completion_script(Shell shell, const CLI::App& app, const std::string& program) {
  switch (shell) {
    case Shell::bash:
      return bash_script(app, program);
    case Shell::zsh:
      return zsh_script(app, program);
    case Shell::fish:
      break;
  }
  return fish_script(app, program);
}

}  // namespace whittle::app
