"""Changes one token of the modules at a time, builds the tests and runs them until one fails. See run.sh."""

import argparse
import collections
import fcntl
import glob
import hashlib
import json
import math
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time

import sites

MODULES = ("core", "engine", "polish", "metrics", "verify", "progressive", "io", "openmesh")

# In this order, but first same_bytes if the module's results are among its own, and the module's own tests.
PROGRAMS = ("test_core", "test_engine", "same_bytes", "test_polish", "test_metrics", "test_verify", "test_progressive", "test_io",
            "example_plain_arrays", "example_locked_regions", "example_cancelling", "test_property", "test_fuzz",
            "test_data", "test_openmesh", "example_openmesh_properties", "example_own_cost_and_guard", "test_cli",
            "test_fuzz_command_line", "test_accuracy")

HASHED_MODULES = ("core", "engine", "polish")

# What a program runs besides itself.
RUNS_TOO = {"test_cli": "whittle", "test_fuzz_command_line": "whittle", "test_accuracy": "whittle"}

SLACK_SECONDS = 10  # a program may compute this and three times what it computes without the change
WAITING = 20  # times as long it may run, as other programs may take the processor

Outcome = collections.namedtuple("Outcome", "word detail")


def prepare_child(processor_seconds):
    """Undoes what nohup and background jobs do to signals: tests send them to the program. Limits what it computes."""
    for number in (signal.SIGINT, signal.SIGHUP, signal.SIGQUIT):
        signal.signal(number, signal.SIG_DFL)
    if processor_seconds is not None:
        resource.setrlimit(resource.RLIMIT_CPU, (processor_seconds, processor_seconds))


def files_under(folder):
    """Size and time of each file, by its path in the folder."""
    found = {}
    for parent, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(parent, name)
            status = os.lstat(path)
            found[os.path.relpath(path, folder)] = (status.st_size, status.st_mtime_ns)
    return found


def copy_what_differs(source, target):
    """Makes the files of target those of source, with their times."""
    wanted, present = files_under(source), files_under(target)
    for path in (path for path in present if present[path] != wanted.get(path)):
        os.remove(os.path.join(target, path))
    for path in (path for path in wanted if present.get(path) != wanted[path]):
        os.makedirs(os.path.dirname(os.path.join(target, path)), exist_ok=True)
        shutil.copy2(os.path.join(source, path), os.path.join(target, path), follow_symlinks=False)


class Build:
    """The copy of the project: builds programs of it and runs them."""

    def __init__(self, folder):
        self.tree = os.path.join(folder, "tree")
        self.build_folder = os.path.join(self.tree, "build", "release")
        self.usual_folder = os.path.join(folder, "usual")  # the build without a change
        self.seconds_path = os.path.join(folder, "seconds.json")
        self.log = os.path.join(folder, "last.log")
        self.lock = os.path.join(os.path.dirname(folder), "building")
        self.paths = {}
        self.usual_hashes = {}
        self.usual_seconds = {}

    def command(self, words, seconds, where, processor_seconds=None):
        """Exit status of a command, None if it took too long. Its output is in the log."""
        with open(self.log, "wb") as log:
            process = subprocess.Popen(words, cwd=where, stdin=subprocess.DEVNULL, stdout=log,
                                       stderr=subprocess.STDOUT, start_new_session=True,
                                       preexec_fn=lambda: prepare_child(processor_seconds))
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
        folder = os.path.dirname(path)
        if seconds is None:
            return self.command([path] + options, None, folder)
        status = self.command([path] + options, WAITING * seconds, folder, math.ceil(seconds))
        return None if status == -signal.SIGXCPU or status == -signal.SIGKILL else status

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
        self.usual_seconds = self.seconds_of_earlier_run() or {name: self.seconds_of(name) for name in PROGRAMS}
        with open(self.seconds_path, "w", encoding="utf-8") as file:
            json.dump(self.usual_seconds, file, indent=1)
        copy_what_differs(self.build_folder, self.usual_folder)

    def seconds_of_earlier_run(self):
        if not os.path.exists(self.seconds_path):
            return None
        with open(self.seconds_path, encoding="utf-8") as file:
            return json.load(file)

    def seconds_of(self, program):
        """What the program computes, which must not fail."""
        started = self.seconds_computed()
        if self.run(program, None) != 0:
            sys.exit(f"{program} fails without a change:\n{self.said()}")
        seconds = self.seconds_computed() - started
        print(f"{program}: {seconds:.0f} s", flush=True)
        return seconds

    @staticmethod
    def seconds_computed():
        """By all programs that have ended."""
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    def undo_what_a_stopped_run_left(self):
        for kept in glob.glob(os.path.join(self.tree, "modules", "**", "*.kept"), recursive=True):
            os.replace(kept, kept.removesuffix(".kept"))
        if os.path.exists(self.usual_folder):
            self.undo()

    def undo(self):
        """Puts back what was built without a change, which is faster than to build it again."""
        copy_what_differs(self.usual_folder, self.build_folder)

    def failure(self, program, status):
        if status is None:
            return program + " does not end"
        failed = [line for line in self.said().splitlines() if line.startswith("[  FAILED  ]") and "." in line]
        if failed:
            return f"{program}: {failed[0].split()[3].rstrip(',')}"
        return f"{program}: signal {-status}" if status < 0 else f"{program}: status {status}"

    def judge(self, module, most_seconds):
        """What becomes of the change that is in the tree. Its first programs may take `most_seconds` to build."""
        first = (["same_bytes"] if module in HASHED_MODULES else []) + ["test_" + module]
        n_changed = 0
        for program in first + [name for name in PROGRAMS if name not in first]:
            outcome = self.build(program, most_seconds if program in first else None)
            if outcome:
                return outcome
            if self.hashes(program) == self.usual_hashes[program]:
                continue
            n_changed += 1
            status = self.run(program, SLACK_SECONDS + 3 * self.usual_seconds[program])
            if status != 0:
                return Outcome("caught", self.failure(program, status))
        return Outcome("SURVIVED", "" if n_changed else "the programs are the same bytes")


def try_change(build, change, most_seconds):
    path = os.path.join(build.tree, change.path)
    kept = path + ".kept"
    shutil.copy2(path, kept)
    try:
        with open(path, encoding="utf-8", newline="") as file:
            before = file.read()
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(change.apply(before))
        return build.judge(change.path.split("/")[1], most_seconds)
    finally:
        os.replace(kept, path)  # with its time
        build.undo()


def lines_of(path):
    """What an earlier run wrote."""
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        return file.read().splitlines()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--number", type=int, required=True)
    parser.add_argument("--seconds", type=int, required=True)
    parser.add_argument("--folder", required=True)
    arguments = parser.parse_args()

    build = Build(arguments.folder)
    build.undo_what_a_stopped_run_left()
    source_lines = sites.lines_with_sites(build.tree, MODULES)
    print(f"{len(source_lines)} lines have something to change", flush=True)
    build.measure()

    generator = random.Random(arguments.seed)
    results_path = os.path.join(arguments.folder, "results.txt")
    known = lines_of(results_path)
    n_drawn, n_caught, survivors = 0, 0, []
    with open(results_path, "a", encoding="utf-8", buffering=1) as results:
        while n_caught + len(survivors) < arguments.number:
            change = generator.choice(generator.choice(source_lines).changes)
            n_drawn += 1
            if n_drawn <= len(known):
                text = known[n_drawn - 1]
            else:
                started = time.monotonic()
                outcome = try_change(build, change, arguments.seconds)
                text = f"{change}  ->  {outcome.word}: {outcome.detail}"
                results.write(text + "\n")
                text += f" ({time.monotonic() - started:.0f} s)"
            print(f"{n_drawn}: {text}", flush=True)
            n_caught += "  ->  caught" in text
            if "  ->  SURVIVED" in text:
                survivors.append(text)
    print(f"\n{n_caught} of {arguments.number} changes were caught; {n_drawn} were drawn. Survivors:", *survivors,
          sep="\n")


if __name__ == "__main__":
    main()
