"""Changes one token of the modules at a time, builds the tests and runs them until one fails. See run.sh."""

import argparse
import collections
import fcntl
import hashlib
import os
import random
import signal
import subprocess
import sys
import time

import sites

MODULES = ("core", "engine", "polish", "metrics", "io", "openmesh")

# The first of them are the module's own tests, then these in their order.
PROGRAMS = ("test_core", "test_engine", "same_bytes", "test_polish", "test_metrics", "test_io", "example_plain_arrays",
            "example_locked_regions", "example_cancelling", "test_property", "test_fuzz", "test_data", "test_openmesh",
            "example_openmesh_properties", "example_own_cost_and_guard", "test_cli", "test_fuzz_command_line",
            "test_accuracy")

# What a program runs besides itself.
RUNS_TOO = {"test_cli": "whittle", "test_fuzz_command_line": "whittle", "test_accuracy": "whittle"}

BUILD_SECONDS = 240  # for the module's own tests; a change that takes longer is skipped
SLACK_SECONDS = 20  # a program may take this and three times what it takes without the change

Outcome = collections.namedtuple("Outcome", "word detail")


def take_all_signals():
    """Undoes what nohup and background jobs do to signals: tests send them to the program."""
    for number in (signal.SIGINT, signal.SIGHUP, signal.SIGQUIT):
        signal.signal(number, signal.SIG_DFL)


class Build:
    """The copy of the project: builds programs of it and runs them."""

    def __init__(self, folder):
        self.tree = os.path.join(folder, "tree")
        self.build_folder = os.path.join(self.tree, "build", "release")
        self.log = os.path.join(folder, "last.log")
        self.lock = os.path.join(os.path.dirname(folder), "building")
        self.paths = {}
        self.usual_hashes = {}
        self.usual_seconds = {}

    def command(self, words, seconds, where):
        """Exit status of a command, None if it took too long. Its output is in the log."""
        with open(self.log, "wb") as log:
            process = subprocess.Popen(words, cwd=where, stdin=subprocess.DEVNULL, stdout=log,
                                       stderr=subprocess.STDOUT, start_new_session=True,
                                       preexec_fn=take_all_signals)
            try:
                return process.wait(seconds)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
                return None

    def said(self):
        with open(self.log, encoding="utf-8", errors="replace") as log:
            return log.read()

    def build(self, program, seconds):
        """None if the program is there; else the outcome of the change."""
        with open(self.lock, "w", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)  # one run builds at a time
            status = self.command(["ninja", "-j1", program], seconds, self.build_folder)
        if status == 0:
            return None
        if status is None:
            return Outcome("too slow", "building " + program)
        if "error:" in self.said():
            return Outcome("invalid", "does not compile")
        return Outcome("caught", program + " does not start")  # the build asks it for the names of its tests

    def find(self, program):
        for folder, _, files in os.walk(self.build_folder):
            if program in files and os.access(os.path.join(folder, program), os.X_OK):
                return os.path.join(folder, program)
        sys.exit(program + " is not built")

    def hashes(self, program):
        def one(path):
            with open(path, "rb") as file:
                return hashlib.sha256(file.read()).hexdigest()

        return [one(self.paths[name]) for name in (program, RUNS_TOO.get(program)) if name]

    def run(self, program, seconds):
        path = self.paths[program]
        options = ["--gtest_fail_fast", "--gtest_brief=1"] if program.startswith("test_") else []
        return self.command([path] + options, seconds, os.path.dirname(path))

    def measure(self):
        """Builds all programs and runs them once, without a change."""
        for program in PROGRAMS:
            failure = self.build(program, None)
            if failure:
                sys.exit(f"{program} can't be built:\n{self.said()}")
            for name in (program, RUNS_TOO.get(program)):
                if name:
                    self.paths[name] = self.find(name)
            self.usual_hashes[program] = self.hashes(program)
            started = time.monotonic()
            if self.run(program, None) != 0:
                sys.exit(f"{program} fails without a change:\n{self.said()}")
            self.usual_seconds[program] = time.monotonic() - started
            print(f"{program}: {self.usual_seconds[program]:.0f} s", flush=True)

    def failure(self, program, status):
        if status is None:
            return program + " does not end"
        failed = [line for line in self.said().splitlines() if line.startswith("[  FAILED  ]") and "." in line]
        if failed:
            return f"{program}: {failed[0].split()[3].rstrip(',')}"
        return f"{program}: signal {-status}" if status < 0 else f"{program}: status {status}"

    def judge(self, module):
        """What becomes of the change that is in the tree."""
        own = "test_" + module
        n_changed = 0
        for program in [own] + [name for name in PROGRAMS if name != own]:
            outcome = self.build(program, BUILD_SECONDS if program == own else None)
            if outcome:
                return outcome
            if self.hashes(program) == self.usual_hashes[program]:
                continue
            n_changed += 1
            status = self.run(program, SLACK_SECONDS + 3 * self.usual_seconds[program])
            if status != 0:
                return Outcome("caught", self.failure(program, status))
        return Outcome("SURVIVED", "" if n_changed else "the programs are the same bytes")


def try_change(build, change):
    path = os.path.join(build.tree, change.path)
    with open(path, encoding="utf-8", newline="") as file:
        before = file.read()
    try:
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(change.apply(before))
        return build.judge(change.path.split("/")[1])
    finally:
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(before)


def report(lines, n_caught, survivors):
    n = n_caught + len(survivors)
    print(f"\n{n_caught} of {n} changes were caught; {lines} were drawn. Survivors:")
    for line in survivors:
        print(line)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--number", type=int, required=True)
    parser.add_argument("--folder", required=True)
    arguments = parser.parse_args()

    build = Build(arguments.folder)
    source_lines = sites.lines_with_sites(build.tree, MODULES)
    print(f"{len(source_lines)} lines have something to change", flush=True)
    build.measure()

    generator = random.Random(arguments.seed)
    n_drawn, n_caught, survivors = 0, 0, []
    with open(os.path.join(arguments.folder, "results.txt"), "w", encoding="utf-8") as results:
        while n_caught + len(survivors) < arguments.number:
            line = generator.choice(source_lines)
            change = generator.choice(line.changes)
            n_drawn += 1
            started = time.monotonic()
            outcome = try_change(build, change)
            text = f"{change}  ->  {outcome.word}{' by ' if outcome.word == 'caught' else ' '}{outcome.detail}".rstrip()
            print(f"{n_drawn}: {text} ({time.monotonic() - started:.0f} s)", flush=True)
            results.write(text + "\n")
            results.flush()
            if outcome.word == "caught":
                n_caught += 1
            if outcome.word == "SURVIVED":
                survivors.append(text)
    report(n_drawn, n_caught, survivors)


main()
