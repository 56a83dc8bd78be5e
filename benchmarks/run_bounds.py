#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the benchmarks that benchmarks/bounds.json bounds, and says which bounds are met.

Each line of bounds.json bounds one counter of one benchmark, or how many times that of another one (`over`); most are ratios of two things timed in turn in one run,
so that they mean something on other machines. Programs run one after another, `--repeat` times each: the median is held
against the bound, the least and the largest stand beside it. `--against` compares with an earlier run's file: a number
has changed where the two ranges do not overlap.

  scripts/bench                              all of them, some ten minutes
  scripts/bench --only readers -o now.json   those of one program, kept
  scripts/bench --against now.json           what has changed since
"""

import argparse
import datetime
import json
import os
import pathlib
import platform
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=HERE.parent / "build/release", help="where the programs are")
    parser.add_argument("--only", default="", metavar="TEXT", help="bounds whose program or benchmark contains TEXT")
    parser.add_argument("--repeat", type=int, default=3, help="runs of each program (3)")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="keep what was measured, as JSON")
    parser.add_argument("--against", type=pathlib.Path, help="an earlier run's JSON to compare with")
    parser.add_argument("--busy", action="store_true", help="measure although something else runs")
    parser.add_argument("--check", action="store_true", help="only look whether the programs have what is bounded")
    parser.add_argument("--list", action="store_true", help="print the bounds, and measure nothing")
    return parser.parse_args()


def read_bounds(only):
    bounds = json.loads((HERE / "bounds.json").read_text())["bounds"]
    return [bound for bound in bounds if only in bound["program"] + " " + bound["benchmark"]]


def name_of(bound):
    return f"{bound['benchmark']} {bound['counter']}"


def limit_of(bound):
    return f"<= {bound['at_most']:g}" if "at_most" in bound else f">= {bound['at_least']:g}"


def is_met(bound, value):
    return value <= bound["at_most"] if "at_most" in bound else value >= bound["at_least"]


def require_quiet_machine():
    """Another process that computes would be in every number. What has just been built is gone soon: it is waited for."""
    longest, most = 180, 0.3 * os.cpu_count()  # seconds; the load is a mean over a minute
    for second in range(longest):
        if os.getloadavg()[0] <= most:
            return
        if second == 0:
            print(f"bench: waiting for the machine to be quiet (load {os.getloadavg()[0]:.2f})", file=sys.stderr)
        time.sleep(1)
    sys.exit(f"bench: the machine is busy (load {os.getloadavg()[0]:.2f}): wait, or say --busy")


def command_of(program, build):
    """VTK's windows need a display."""
    command = [str(build / program)]
    return ["xvfb-run", "-a", *command] if program == "bench_peeling" else command


def can_run(program):
    return program != "bench_peeling" or shutil.which("xvfb-run")


def run_once(program, bounds, build):
    """Returns the numbers of the program's bounds, by name; those of a benchmark that fails are missing."""
    names = {bound[key] for bound in bounds for key in ("benchmark", "over") if key in bound}
    wanted = "|".join(sorted("^" + escaped(name) + "(/|$)" for name in names))
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / "out.json"
        run = subprocess.run([*command_of(program, build), f"--benchmark_filter={wanted}", f"--benchmark_out={output}",
                              "--benchmark_out_format=json"], capture_output=True, text=True)
        if run.returncode != 0 or not output.exists() or not output.stat().st_size:
            print(f"bench: {program} failed: {run.stderr.strip().splitlines()[-1:] or run.returncode}", file=sys.stderr)
            return {}
        measured = json.loads(output.read_text())["benchmarks"]
    values = {name_of(bound): value_of(bound, measured) for bound in bounds}
    return {name: value for name, value in values.items() if value is not None}


def escaped(name):
    """For the regular expressions of POSIX, which know fewer escapes than Python's."""
    return re.sub(r"([][.*^$+?(){}|\\])", r"\\\1", name)


def value_of(bound, measured):
    def counter(benchmark):
        return next((row[bound["counter"]] for row in measured if is_of(benchmark, row["name"]) and bound["counter"] in row), None)

    value, other = counter(bound["benchmark"]), counter(bound["over"]) if "over" in bound else 1
    return None if value is None or other is None else value / other


def is_of(benchmark, name):
    """Google Benchmark adds to a name how often, and by which clock, it ran."""
    suffixes = r"(/(iterations:\d+|manual_time|real_time|process_time|repeats:\d+|min_time:[\d.]+))*"
    return name.startswith(benchmark) and re.fullmatch(suffixes, name.removeprefix(benchmark))


def names_of(program, build):
    run = subprocess.run([*command_of(program, build), "--benchmark_list_tests"], capture_output=True, text=True)
    return run.stdout.split("\n")


def check(bounds, build):
    """Says which bounds are of a benchmark that is not there, and returns how many."""
    names = {program: names_of(program, build) for program in {bound["program"] for bound in bounds} if can_run(program)}
    missing = [bound for bound in bounds if bound["program"] in names
               and not any(is_of(bound["benchmark"], name) for name in names[bound["program"]])]
    for bound in missing:
        print(f"bench: {bound['program']} has no '{bound['benchmark']}'", file=sys.stderr)
    return len(missing)


def measure(bounds, build, repeat):
    numbers = {}
    for program in dict.fromkeys(bound["program"] for bound in bounds):
        if not can_run(program):
            print(f"bench: {program} needs xvfb-run: apt-get install xvfb", file=sys.stderr)
            continue
        of_program = [bound for bound in bounds if bound["program"] == program]
        for turn in range(repeat):
            print(f"bench: {program}, {turn + 1} of {repeat}", file=sys.stderr)
            for name, value in run_once(program, of_program, build).items():
                numbers.setdefault(name, []).append(value)
    return numbers


def print_table(bounds, numbers):
    """Returns how many bounds are not met, of those that have a number."""
    missed = unknown = 0
    print(f"{'':6} {'median':>9} {'least … largest':>21} {'bound':>9}  what")
    for bound in bounds:
        values = numbers.get(name_of(bound))
        met = bool(values) and is_met(bound, statistics.median(values))
        missed += bool(values) and not met
        unknown += not values
        verdict = "–" if not values else "met" if met else "MISSED"
        shown = f"{statistics.median(values):9.3g} {min(values):9.3g} … {max(values):9.3g}" if values else f"{'no number':>31}"
        print(f"{verdict:6} {shown} {limit_of(bound):>9}  {name_of(bound)}: {bound['what']}")
    print(f"\n{len(bounds) - missed - unknown} of {len(bounds)} bounds met, {missed} missed, {unknown} without a number")
    return missed


def print_changes(old, numbers):
    print("\nbeyond the spread of both runs:")
    changed = False
    for name, values in numbers.items():
        before = old.get(name)
        if before and (min(values) > max(before) or max(values) < min(before)):
            changed = True
            print(f"  {name}: {statistics.median(before):.3g} -> {statistics.median(values):.3g}")
    if not changed:
        print("  nothing has changed")


def machine(build):
    version = subprocess.run([str(build / "pellucid"), "--version"], capture_output=True, text=True).stdout.strip()
    models = re.findall(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    return {"processor": models[0] if models else platform.machine(), "cores": os.cpu_count(),
            "system": platform.platform(), "program": version}


def main():
    arguments = parse_arguments()
    bounds = read_bounds(arguments.only)
    if not bounds:
        sys.exit(f"bench: --only '{arguments.only}' fits no bound; --list prints them")
    if arguments.list:
        for bound in bounds:
            print(f"{bound['program']} {name_of(bound)} {limit_of(bound)}: {bound['what']}")
        return 0
    if arguments.check:
        return 1 if check(bounds, arguments.build) else 0
    old = json.loads(arguments.against.read_text())["numbers"] if arguments.against else None
    if not arguments.busy:
        require_quiet_machine()
    numbers = measure(bounds, arguments.build, arguments.repeat)
    if arguments.output:
        kept = {"format": "pellucid-benchmarks", "version": 1, "machine": machine(arguments.build),
                "date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"), "numbers": numbers}
        arguments.output.write_text(json.dumps(kept, indent=1) + "\n")
    missed = print_table(bounds, numbers)
    if old is not None:
        print_changes(old, numbers)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
