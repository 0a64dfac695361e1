#include <memory>
#include <string>

#include "commands/subcommands.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "options/values.hh"
#include "shell/completion.hh"
#include "shell/man_page.hh"

namespace whittle::app {
namespace {

constexpr std::array<Choice<Shell>, 3> shells{{{"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}}};

}  // namespace

void setup_completion(CLI::App& app, Command& command) {
  const auto shell = std::make_shared<Shell>();
  CLI::App* sub = app.add_subcommand("completion", "Print the completion script of a shell.");
  add_value(
      *sub, "SHELL", words_of<Shell>(shells), *shell,
      [](std::string_view text) { return parse_choice<Shell>(text, shells); }, "bash, zsh or fish")
      ->required()
      ->group("Arguments");
  set_usage(*sub, "bash|zsh|fish");
  sub->footer(
      "'cmake --install' puts the scripts where the shells look for them. Without it:\n\n"
      "Examples:\n"
      "  source <(whittle completion bash)\n"
      "  whittle completion zsh > ~/.zfunc/_whittle\n"
      "  whittle completion fish > ~/.config/fish/completions/whittle.fish");
  sub->callback([&app, shell, &command] {
    command = [&app, shell] {
      print(completion_script(*shell, app, program_and_version()));
      return ExitCode::done;
    };
  });
}

void setup_man(CLI::App& app, Command& command) {
  CLI::App* sub = app.add_subcommand("man", "Print the manual page.");
  set_usage(*sub, "");
  sub->footer(
      "'cmake --install' puts the page where man looks for it. Without it:\n\n"
      "Examples:\n"
      "  whittle man | man -l -");
  sub->callback([&app, &command] {
    command = [&app] {
      print(man_page(app, program_and_version()));
      return ExitCode::done;
    };
  });
}

}  // namespace whittle::app
