#include "bench/command_line.hh"

#include <exception>
#include <iostream>

namespace whittle::bench {

void add_options(CLI::App& app, Rounds& rounds, const std::string& who) {
  app.add_option("--repetitions", rounds.n, "rounds that count")
      ->type_name("N")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--slow", rounds.slow_s, who + " that take longer than this are run once, seconds")
      ->type_name("S")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--limit", rounds.limit_s, who + " that take longer than this are stopped, seconds")
      ->type_name("S")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag_callback(
      "--cpu-time", [&rounds] { rounds.clock = Clock::cpu; },
      "processor time (of all threads together) instead of wall-clock time");
}

void add_options(CLI::App& app, RowsFile& rows) {
  app.add_option("--csv", rows.csv, "where the rows are saved")->type_name("FILE")->take_last()->capture_default_str();
  app.add_option("--commit", rows.commit, "of the sources, for the rows")->type_name("ID");
}

int run_program(CLI::App& app, int argc, char** argv, const std::function<int()>& run) {
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}

}  // namespace whittle::bench
