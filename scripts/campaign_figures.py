#!/usr/bin/env python3
"""Measures what campaigns cost beside their runs, and compares it with what is allowed.

    python3 scripts/campaign_figures.py [--json FILE] [--only PART]... [--folder DIR] [PROGRAM]

    --json FILE   write the figures too, for campaign_scaling.py
    --only PART   of overhead, efficiency, plan, status, pandas; may be given again (default: all)
    --folder DIR  where to work: a folder is made there (default: the system's for temporary files)
    PROGRAM       default: build/ci/program/retiarius

Needs a machine that does nothing else (efficiency and overhead are times), python3-pandas, and
2 GB of room for a database of a million rows. Exit code 1 where a figure misses its bar.
"""

import argparse
import json
import os
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
MISSION = os.path.join(ROOT, "tests", "campaign", "small-mission.toml")
PARTS = ["overhead", "efficiency", "plan", "status", "pandas"]
TINY = 'phase[0].until = "time >= 0.05"'
# A fifth of a second each on one core.
LONG = ["net.mesh = 0.125", 'contact.method = "modified-mass"', 'phase[0].until = "time >= 0.8"']


class Bench:
    def __init__(self, program):
        self.program = program
        self.rows = []
        self.figures = {}

    def figure(self, key, what, value, unit, bar=None, least=False):
        """Books a figure; `bar` is the most that it may be, or with `least` the least."""
        self.figures[key] = value
        good = bar is None or (value >= bar if least else value <= bar)
        allowed = "" if bar is None else f"{'>=' if least else '<'} {bar:g} {unit}"
        verdict = "" if bar is None else "ok" if good else "MISSED"
        self.rows.append((what, f"{value:.4g} {unit}", allowed, verdict))
        print(f"  {what}: {value:.4g} {unit}  {allowed} {verdict}", flush=True)

    def good(self):
        return not any(row[3] == "MISSED" for row in self.rows)

    def table(self):
        rows = [("what", "measured", "allowed", "")] + self.rows
        widths = [max(len(row[k]) for row in rows) for k in range(4)]
        return "\n".join("  ".join(cell.ljust(w) for cell, w in zip(row, widths)).rstrip()
                         for row in rows)

    def run(self, *words):
        """The program to its end; returns seconds, greatest memory (B) of it or a child, and what
        it printed."""
        begun = time.monotonic()
        with tempfile.TemporaryFile("w+") as out:
            child = subprocess.Popen([self.program, "campaign", *words], stdout=out)
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
            if child.returncode != 0:
                sys.exit(f"retiarius campaign {' '.join(words)}: exit code {child.returncode}")
            out.seek(0)
            return time.monotonic() - begun, usage.ru_maxrss * 1024, out.read()

    def run_watched(self, *words):
        """As run(); returns seconds and processor seconds of the coordinator without workers."""
        begun = time.monotonic()
        child = subprocess.Popen([self.program, "campaign", *words], stdout=subprocess.DEVNULL)
        used = 0.0
        while child.poll() is None:
            try:
                with open(f"/proc/{child.pid}/stat") as file:
                    fields = file.read().rsplit(")", 1)[1].split()
                used = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
            except (OSError, IndexError):
                pass
            time.sleep(0.01)
        if child.returncode != 0:
            sys.exit(f"retiarius campaign {' '.join(words)}: exit code {child.returncode}")
        return time.monotonic() - begun, used


def write_campaign(name, runs, changes):
    shutil.copy(MISSION, "m.toml")
    with open(name, "w") as file:
        file.write(f"""mission = "m.toml"
set = {json.dumps(changes)}
[plan]
design = "monte-carlo"
runs = {runs}
seed = 1
[[variable]]
name = "x"
set = "target.position[0]"
distribution = "uniform"
low = -0.3
high = 0.3
[[variable]]
name = "spin"
set = "target.spin_deg"
distribution = "cone"
half_angle_deg = 90
length = 100
""")
    return name


def times_in(folder):
    times = []
    for shard in sorted(os.listdir(os.path.join(folder, "shards"))):
        if shard.endswith(".sqlite"):
            with sqlite3.connect(os.path.join(folder, "shards", shard)) as base:
                times += [row[0] for row in base.execute("SELECT wall_time FROM runs")]
    return times


def fill(bench, campaign, out, rows):
    """Makes a shard with so many rows: one run done, the others with its content."""
    bench.run("run", campaign, "--out", out, "--ids", "0-0", "--jobs", "1", "--quiet")
    shards = os.path.join(out, "shards")
    shard = next(os.path.join(shards, name) for name in os.listdir(shards)
                 if name.endswith(".sqlite"))
    base = sqlite3.connect(shard)
    base.execute("PRAGMA synchronous = OFF")
    columns = [row[1] for row in base.execute("PRAGMA table_info(runs)")]
    rest = ", ".join(columns[1:])
    base.execute(f"""WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < ?)
        INSERT INTO runs SELECT i, {rest} FROM n JOIN runs ON runs.id = 0""", (rows - 1,))
    base.commit()
    base.close()
    return shard


def wait_for_device():
    """Seconds that the device takes to have 4 kB for good; each row of results asks for a few."""
    with open("device", "wb", buffering=0) as file:
        begun = time.monotonic()
        for _ in range(200):
            file.write(bytes(4096))
            os.fsync(file.fileno())
        return (time.monotonic() - begun) / 200


def overhead(bench):
    runs = 2000
    bench.figure("device", "the device has 4 kB for good", 1e3 * wait_for_device(), "ms")
    campaign = write_campaign("tiny.toml", runs, [TINY])
    elapsed, used = bench.run_watched("run", campaign, "--out", "tiny", "--jobs", "1", "--quiet")
    times = times_in("tiny")
    bench.figure("overhead", f"beside each of {runs} runs of {1e3 * sum(times) / runs:.2g} ms",
                 1e3 * (elapsed - sum(times)) / runs, "ms", 5.0)
    bench.figure("hand_out", "of which the coordinator computes", 1e3 * used / runs, "ms")


def efficiency(bench):
    runs = 120
    campaign = write_campaign("long.toml", runs, LONG)
    one = two = 1e300
    for k in range(3):  # the best of three
        for jobs in (1, 2):
            out = f"long-{jobs}-{k}"
            elapsed, _, _ = bench.run("run", campaign, "--out", out, "--jobs", str(jobs), "--quiet")
            if jobs == 1:
                one = min(one, elapsed)
            else:
                two = min(two, elapsed)
    print(f"  {runs} runs: {one:.2f} s by one process, {two:.2f} s by two")
    bench.figure("efficiency", "efficiency of two processes against one", 100 * one / (2 * two),
                 "%", 95.0, least=True)


def plan(bench):
    campaign = write_campaign("big.toml", 1000000, [TINY])
    _, memory, _ = bench.run("plan", campaign)
    bench.figure("plan_memory", "plan of a million runs: memory", memory / 1e6, "MB", 200.0)
    elapsed, memory, _ = bench.run("plan", campaign, "--csv", "plan.csv")
    bench.figure("plan_csv_memory", "the same into a CSV file: memory", memory / 1e6, "MB", 200.0)
    bench.figure("plan_csv", "the same: time", elapsed, "s")
    os.remove("plan.csv")
    _, memory, _ = bench.run("run", campaign, "--out", "begun", "--ids", "0-99", "--jobs", "2",
                             "--quiet")
    bench.figure("run_memory", "a hundred of them run: memory", memory / 1e6, "MB", 200.0)
    elapsed, _, _ = bench.run("status", campaign, "--out", "begun")
    bench.figure("status_begun", "status of a million runs, a hundred done", elapsed, "s", 2.0)


def status(bench):
    campaign = write_campaign("full.toml", 1000000, [TINY])
    shard = fill(bench, campaign, "full", 1000000)
    elapsed, memory, text = bench.run("status", campaign, "--out", "full")
    if "1000000 of 1000000 done" not in text:
        sys.exit("status does not see all rows")
    bench.figure("status_full", f"status of a million done, {os.path.getsize(shard) / 1e9:.2g} GB",
                 elapsed, "s", 2.0)
    bench.figure("status_memory", "the same: memory", memory / 1e6, "MB", 200.0)
    shutil.rmtree("full")
    # What each file costs: a thousand of them, as tasks of a cluster leave.
    campaign = write_campaign("many.toml", 1000000, [TINY])
    shard = fill(bench, campaign, "many", 10)
    none, _, _ = bench.run("status", campaign, "--out", "many")
    for k in range(1000):
        shutil.copy(shard, f"many/shards/copy-{k}.sqlite")
    all_, _, _ = bench.run("status", campaign, "--out", "many")
    bench.figure("shard", "each further file of results, to status and to a task's start",
                 1e3 * (all_ - none) / 1000, "ms")


def pandas_(bench):
    rows = 100000
    campaign = write_campaign("rows.toml", rows, [TINY])
    fill(bench, campaign, "rows", rows)
    elapsed, _, _ = bench.run("collect", campaign, "--out", "rows", "--csv", "rows.csv")
    bench.figure("collect", f"collect and CSV of {rows} rows: each", 1e3 * elapsed / rows, "ms")
    import pandas
    for key, what, bar, load in (
            ("pandas_csv", "as CSV into pandas", 2.0, lambda: pandas.read_csv("rows.csv")),
            ("pandas_sql", "by SQL into pandas", None,
             lambda: pandas.read_sql("SELECT * FROM runs",
                                     sqlite3.connect("rows/campaign.sqlite")))):
        begun = time.monotonic()
        frame = load()
        elapsed = time.monotonic() - begun
        if len(frame) != rows or not (frame["outcome"] == "finished").all():
            sys.exit("the rows do not come back")
        bench.figure(key, f"{rows} rows of {len(frame.columns)} columns {what}", elapsed, "s", bar)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json")
    parser.add_argument("--only", action="append", choices=PARTS, metavar="PART")
    parser.add_argument("--folder")
    parser.add_argument("program", nargs="?",
                        default=os.path.join(ROOT, "build", "ci", "program", "retiarius"))
    arguments = parser.parse_args()
    bench = Bench(os.path.abspath(arguments.program))
    keep = os.path.abspath(arguments.json) if arguments.json else None
    parts = {"overhead": overhead, "efficiency": efficiency, "plan": plan, "status": status,
             "pandas": pandas_}
    with tempfile.TemporaryDirectory(dir=arguments.folder) as folder:
        os.chdir(folder)
        for name in PARTS:
            if not arguments.only or name in arguments.only:
                print(f"{name}:", flush=True)
                parts[name](bench)
        os.chdir(ROOT)
    print("\n" + bench.table())
    if keep:
        with open(keep, "w") as file:
            json.dump(bench.figures, file, indent=2)
    return 0 if bench.good() else 1


if __name__ == "__main__":
    sys.exit(main())
