#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "commands/subcommands.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "options/command_line.hh"
#include "options/help.hh"
#include "shell/completion.hh"
#include "shell/man_page.hh"

namespace whittle::app {
namespace {

constexpr std::array<Choice<Shell>, 3> shells{{{"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}}};

}  // namespace

void setup_completion(CLI::App& app, Command& command) {
  const auto shell = std::make_shared<Shell>();
  const SubcommandText text{"completion", "Print the completion script of a shell.", "bash|zsh|fish",
                            "'cmake --install' puts the scripts where the shells look for them. Without it:\n\n"
                            "Examples:\n"
                            "  source <(whittle completion bash)\n"
                            "  whittle completion zsh > ~/.zfunc/_whittle\n"
                            "  whittle completion fish > ~/.config/fish/completions/whittle.fish"};
  const OptionRow row{
      .names = "SHELL", .access = choice(*shell, shells), .help = "bash, zsh or fish", .is_required = true};
  const auto run = [&app, shell](const Given&) {
    print(completion_script(*shell, app, program_and_version()));
    return ExitCode::done;
  };
  add_subcommand(app, text, {row}, run, command);
}

void setup_man(CLI::App& app, Command& command) {
  const SubcommandText text{"man", "Print the manual page.", "",
                            "'cmake --install' puts the page where man looks for it. Without it:\n\n"
                            "Examples:\n"
                            "  whittle man | man -l -"};
  const auto run = [&app](const Given&) {
    print(man_page(app, program_and_version()));
    return ExitCode::done;
  };
  add_subcommand(app, text, {}, run, command);
}

}  // namespace whittle::app
