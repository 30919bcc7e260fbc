#!/usr/bin/env python3
"""Breaks the code on purpose, one small change at a time, and tells which changes no test notices.

tests/mutations/*.toml lists the changes: for each source file the tests of its subject, and for each change the old
text, the new text and what it breaks. Each change is compiled alone, into copies of the test programs that hold these
tests; then they run until the first that fails. The tree is only read: a changed file lies in a folder of its own
under the build folder, and only the objects that contain it are compiled anew.

A survivor needs a test, or code that nothing depends on is removed, or the change is argued to be equivalent: then
`equivalent` in the list gives the reason. The exit status is 0 if nothing survives that is not argued.

Do not edit sources while it runs.
"""

import argparse
import concurrent.futures
import fnmatch
import hashlib
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import time
import tomllib
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
KEYS = {"old", "new", "breaks", "occurrence", "equivalent", "tests"}
# As CMakeLists.txt has it.
ENVIRONMENT = {**os.environ, "CCACHE_SLOPPINESS": "pch_defines,time_macros,include_file_mtime,include_file_ctime"}
SECONDS_TO_COMPILE = 600


@dataclass(frozen=True)
class Mutation:
    path: str
    tests: str  # a filter of GoogleTest
    old: str
    new: str
    breaks: str
    occurrence: int | None = None  # counted from 1; none: the old text occurs once
    equivalent: str | None = None

    def __str__(self):
        return f"{self.path}: {self.breaks}"

    def changed(self):
        """Returns the text of the file with the change. Raises ValueError where the list does not fit the file."""
        text = (ROOT / self.path).read_text()
        parts = text.split(self.old)
        count = len(parts) - 1
        where = f"{self.path}: the text {self.old!r} of the change \"{self.breaks}\""
        if count == 0:
            raise ValueError(f"{where} is not there")
        if self.occurrence is None and count > 1:
            raise ValueError(f"{where} is there {count} times: expected once, or an `occurrence`")
        at = self.occurrence or 1
        if at > count:
            raise ValueError(f"{where} is there {count} times: expected at least {at}")
        return self.old.join(parts[:at]) + self.new + self.old.join(parts[at:])

    def name(self):
        words = "\0".join([self.path, self.old, self.new, str(self.occurrence)])
        return hashlib.sha256(words.encode()).hexdigest()[:12]


def listed():
    mutations = []
    for table in sorted((ROOT / "tests/mutations").glob("*.toml")):
        for file in tomllib.loads(table.read_text())["file"]:
            for change in file["mutation"]:
                if unknown := change.keys() - KEYS:
                    sys.exit(f"{table}: a change of {file['path']} has the key {unknown.pop()!r}: expected {sorted(KEYS)}")
                mutations.append(Mutation(path=file["path"], **{"tests": file["tests"], **change}))
    return mutations


class Build:
    """A build folder of the unchanged tree, and what it takes to compile one change."""

    def __init__(self, folder, mutations):
        self.folder = folder
        if not (folder / "build.ninja").exists():
            self.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                      "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"])
        programs = self.programs({mutation.path.split("/")[0] for mutation in mutations})
        self.run(["cmake", "--build", folder, "--target", *programs])
        self.tests = {program: self.tests_of(program) for program in programs}
        self.launcher = [ccache] if (ccache := shutil.which("ccache")) else []
        commands = json.loads((folder / "compile_commands.json").read_text())
        compilers = [(shlex.split(entry["command"]), entry["file"]) for entry in commands]
        self.commands = {command[command.index("-o") + 1]: (command, source) for command, source in compilers}
        self.links = {program: self.link_command(program) for program in programs}
        self.objects = self.objects_by_file()

    @staticmethod
    def run(command):
        if subprocess.run(command).returncode != 0:
            sys.exit("the unchanged tree does not build")

    def programs(self, tops):
        """Returns the test programs of these top folders that need neither a display nor mocked devices."""
        targets = re.findall(r"^bin/(\w+): ", self.ninja("-t", "targets", "all"), re.MULTILINE)
        return sorted(t for t in targets if re.fullmatch(f"({'|'.join(tops)})_[a-z_]+_test", t)
                      and not re.search("_(drawn|mocked)_", t))

    def tests_of(self, program):
        """Returns the names of the tests in a program, suite and test."""
        suite, tests = "", []
        for line in subprocess.run([self.folder / "bin" / program, "--gtest_list_tests"],
                                   capture_output=True, text=True, check=True).stdout.splitlines():
            name = line.split("#")[0].strip()
            if line.startswith(" "):
                tests.append(suite + name)
            else:
                suite = name
        return tests

    def programs_with(self, tests):
        """Returns the programs that hold tests of a filter of GoogleTest, which may have no '-'."""
        patterns = tests.split(":")
        return [program for program, names in self.tests.items()
                if any(fnmatch.fnmatchcase(name, pattern) for name in names for pattern in patterns)]

    def ninja(self, *arguments):
        return subprocess.run(["ninja", "-C", self.folder, *arguments], capture_output=True, text=True, check=True).stdout

    def link_command(self, program):
        last = self.ninja("-t", "commands", f"bin/{program}").splitlines()[-1]
        return shlex.split(next(part for part in last.split(" && ") if f"-o bin/{program}" in part))

    def objects_by_file(self):
        """For each file of the tree the objects that contain it."""
        objects, current = {}, None
        for line in self.ninja("-t", "deps").splitlines():
            if line and not line.startswith(" "):
                current = line.split(":")[0]
            elif line.strip() and current in self.commands:
                objects.setdefault(os.path.realpath(self.folder / line.strip()), []).append(current)
        return objects

    def is_part_of(self, link, output):
        target = re.search(r"/([^/]+)\.dir/", output)
        return output in link or any(token.endswith(f"/lib{target[1]}.a") for token in link)

    def make(self, mutation, unchanged, limit_s=SECONDS_TO_COMPILE):
        """Returns an unchanged program with the change; None if it does not compile, and the unchanged one if nothing in
        it contains the file."""
        own = self.folder / "mutants" / mutation.name()
        changed = own / mutation.path
        changed.parent.mkdir(parents=True, exist_ok=True)
        changed.write_text(mutation.changed())
        link = list(self.links[unchanged])
        outputs = [o for o in self.objects.get(str(ROOT / mutation.path), []) if self.is_part_of(link, o)]
        if not outputs:
            return self.folder / "bin" / unchanged
        for k, output in enumerate(outputs):
            command, source = self.commands[output]
            made = str(own / f"{unchanged}.{k}.o")
            command = [str(changed) if part == source and Path(source) == ROOT / mutation.path else
                       made if part == output else part for part in command]
            command[1:1] = [f"-I{own}"]
            if subprocess.run([*self.launcher, *command, "-O1", "-w"], cwd=self.folder, env=ENVIRONMENT, timeout=limit_s,
                              capture_output=True).returncode != 0:
                return None
            if output in link:
                link[link.index(output)] = made
            else:  # before the library that has the unchanged object, which is then not needed
                link.insert(next(i for i, part in enumerate(link) if part.endswith(".a")), made)
        program = own / unchanged
        link[link.index(f"bin/{unchanged}")] = str(program)
        if subprocess.run(link, cwd=self.folder, capture_output=True).returncode != 0:
            return None
        return program


def failure_of(program, tests, limit_s, shard=0, shards=1):
    """Returns the first test that fails, or how the program ended; None if all pass."""
    environment = {**os.environ, "GTEST_SHARD_INDEX": str(shard), "GTEST_TOTAL_SHARDS": str(shards)}
    try:
        ran = subprocess.run([program, f"--gtest_filter={tests}", "--gtest_fail_fast"], capture_output=True, text=True,
                             errors="replace", timeout=limit_s, env=environment)
    except subprocess.TimeoutExpired:
        return f"the time limit of {limit_s:.0f} s"
    if failed := re.search(r"\[  FAILED  \] (\S+?),? ", ran.stdout):
        return failed[1]
    if ran.returncode != 0:
        begun = re.findall(r"\[ RUN      \] (\S+)", ran.stdout)
        return f"{begun[-1] if begun else 'the start'} (exit status {ran.returncode})"
    return None


class Trial:
    """Tries changes, several at a time."""

    def __init__(self, build, jobs):
        self.build, self.pool, self.jobs = build, concurrent.futures.ThreadPoolExecutor(jobs), jobs
        self.limits_s = {}

    def measure(self, mutations):
        """Runs all the tests once for the unchanged code, which must pass them; one that fails beside others, as on a busy
        machine, may pass alone. What takes as long as all is endless."""
        tests = ":".join(sorted({m.tests for m in mutations}))
        for program in self.build.programs_with(tests):
            begin = time.monotonic()
            path = self.build.folder / "bin" / program
            shards = [self.pool.submit(failure_of, path, tests, 3600, k, self.jobs) for k in range(self.jobs)]
            failed = next(filter(None, [shard.result() for shard in shards]), None)
            if failed and failure_of(path, failed, 3600):
                sys.exit(f"{program}: the unchanged code fails by {failed}")
            self.limits_s[program] = 60 + self.jobs * (time.monotonic() - begin)

    def verdict(self, mutation):
        """Returns the kind of the outcome and a sentence."""
        failed = None
        programs = self.build.programs_with(mutation.tests)
        if not programs:
            return "error", f"no test has a name like {mutation.tests}"
        try:
            for unchanged in programs:
                program = self.build.make(mutation, unchanged)
                if program is None:
                    return "error", f"{unchanged} does not compile with it"
                if failed := failure_of(program, mutation.tests, self.limits_s[unchanged]):
                    break
        except ValueError as error:
            return "error", str(error)
        finally:
            shutil.rmtree(self.build.folder / "mutants" / mutation.name(), ignore_errors=True)
        if failed:
            return ("error", f"is argued to be equivalent, but noticed by {failed}") if mutation.equivalent else \
                   ("killed", f"killed by {failed}")
        return ("equivalent", f"equivalent: {mutation.equivalent}") if mutation.equivalent else ("survivor", "SURVIVED")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--list", action="store_true", help="print the changes and check that each fits its file")
    parser.add_argument("--only", default="", metavar="PATTERN", help="changes whose file and words match this pattern")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="changes at a time (default: the cores)")
    parser.add_argument("--build", type=Path, default=ROOT / "build/mutations", help="the build folder")
    arguments = parser.parse_args()
    mutations = [m for m in listed() if re.search(arguments.only, str(m))]
    if not mutations:
        sys.exit(f"no change matches {arguments.only!r}")
    stale = 0
    for mutation in mutations:
        try:
            mutation.changed()
            if arguments.list:
                print(f"{mutation}{'  [equivalent]' if mutation.equivalent else ''}")
        except ValueError as error:
            stale += 1
            print(f"error: {error}")
    if stale:
        sys.exit(f"{stale} of {len(mutations)} changes do not fit the code any more")
    if arguments.list:
        return print(f"{len(mutations)} changes")

    trial = Trial(Build(arguments.build.resolve(), mutations), arguments.jobs)
    trial.measure(mutations)
    outcomes = {"killed": [], "equivalent": [], "survivor": [], "error": []}
    begun = {trial.pool.submit(trial.verdict, mutation): mutation for mutation in mutations}
    for number, done in enumerate(concurrent.futures.as_completed(begun), 1):
        kind, words = done.result()
        outcomes[kind].append((begun[done], words))
        print(f"[{number}/{len(mutations)}] {begun[done]}: {words}", flush=True)
    print(", ".join(f"{len(all)} {kind}" for kind, all in outcomes.items()))
    for kind in ("survivor", "error"):
        for mutation, words in outcomes[kind]:
            print(f"{kind}: {mutation}: {words}")
    sys.exit(1 if outcomes["survivor"] or outcomes["error"] else 0)


if __name__ == "__main__":
    main()
