#!/usr/bin/env python3
"""Shows whether a campaign's resolution is enough: repeats some of its runs with finer nets and
shorter steps, and compares how they end.

    python3 scripts/campaign_resolution.py [options] [CAMPAIGN]

    CAMPAIGN        default: missions/campaigns/aim-and-spin.toml
    --runs N        so many runs, spread evenly over the ids (default: 12)
    --ids A,B,...   these instead
    --set PATH=V    a change that makes it finer; may be given again
                    (default: net.segments=2 and integrator.step=0.005)
    --jobs N        runs at a time (default: 2)
    --program FILE  default: build/ci/program/retiarius
    --csv FILE      write the table too

The inputs of a run follow from the campaign and its id, so each pair differs in resolution alone.
Exit code 1 where runs without an answer keep any pair from being compared.
"""

import argparse
import concurrent.futures
import csv
import math
import os
import subprocess
import sys
import tempfile
import tomllib

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FINER = ["net.segments=2", "integrator.step=0.005"]
MEASURES = ["captured_share", "capture_quality_final", "capture_quality_settled", "mouth_area_max",
            "peak_tension_20ms"]


def write_variant(campaign, folder, name, changes):
    """The campaign with further overrides, as a file of its own; all else is the same."""
    with open(campaign) as file:
        text = file.read()
    spec = tomllib.loads(text)
    mission = os.path.join(os.path.dirname(os.path.abspath(campaign)), spec["mission"])
    given = spec.get("set", [])
    given = [given] if isinstance(given, str) else given
    lines = text.splitlines()
    top = next((k for k, line in enumerate(lines) if line.startswith("[")), len(lines))
    head = [line for line in lines[:top] if not line.startswith(("mission", "set"))]
    head.append(f"mission = '''{mission}'''")
    if given + changes:
        head.append("set = [" + ", ".join(f"'''{change}'''" for change in given + changes) + "]")
    path = os.path.join(folder, name + ".toml")
    with open(path, "w") as file:
        file.write("\n".join(head + lines[top:]) + "\n")
    return path


def run_all(program, variants, ids, jobs):
    def run(task):
        path, out, run_id = task
        subprocess.run([program, "campaign", "run", path, "--out", out, "--ids", str(run_id),
                        "--jobs", "1", "--quiet"], check=True)
        print(f"  {os.path.basename(out)}: run {run_id} done", file=sys.stderr, flush=True)
    tasks = [(path, path[:-len(".toml")], run_id) for run_id in ids for path in variants]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        list(pool.map(run, tasks))


def rows_of(program, path):
    table = path + ".csv"
    subprocess.run([program, "campaign", "collect", path, "--out", path[:-len(".toml")], "--csv",
                    table], check=True, stdout=subprocess.DEVNULL)
    with open(table, newline="") as file:
        return {int(row["id"]): row for row in csv.DictReader(file)}


def number(row, name):
    return float(row[name]) if row.get(name) else math.nan


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("campaign", nargs="?",
                        default=os.path.join(ROOT, "missions", "campaigns", "aim-and-spin.toml"))
    parser.add_argument("--runs", type=int, default=12)
    parser.add_argument("--ids")
    parser.add_argument("--set", action="append")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--program",
                        default=os.path.join(ROOT, "build", "ci", "program", "retiarius"))
    parser.add_argument("--csv")
    a = parser.parse_args()
    program = os.path.abspath(a.program)
    with open(a.campaign, "rb") as file:
        planned = tomllib.load(file)["plan"]["runs"]
    ids = [int(word) for word in a.ids.split(",")] if a.ids else \
        [(2 * k + 1) * planned // (2 * a.runs) for k in range(a.runs)]
    changes = a.set or FINER
    with tempfile.TemporaryDirectory() as folder:
        coarse = write_variant(a.campaign, folder, "as-it-is", [])
        fine = write_variant(a.campaign, folder, "finer", changes)
        run_all(program, [coarse, fine], ids, a.jobs)
        pairs = [(rows_of(program, coarse)[k], rows_of(program, fine)[k]) for k in ids]
    print(f"{os.path.relpath(a.campaign, ROOT)} against {', '.join(changes)}")
    header = ["id", "outcome", "success"] + [m for m in MEASURES if m in pairs[0][0]]
    table = [header]
    for one, two in pairs:
        table.append([one["id"]] + [
            f"{one[name]} / {two[name]}" if name in ("outcome", "success") else
            f"{number(one, name):.3g} / {number(two, name):.3g}" for name in header[1:]])
    widths = [max(len(row[k]) for row in table) for k in range(len(header))]
    for row in table:
        print("  ".join(cell.ljust(w) for cell, w in zip(row, widths)).rstrip())
    answered = [(one, two) for one, two in pairs if one["success"] and two["success"]]
    same = sum(one["success"] == two["success"] for one, two in answered)
    print(f"\nsuccess is the same in {same} of {len(answered)} pairs with an answer of {len(pairs)}")
    for name in header[3:]:
        off = [number(two, name) - number(one, name) for one, two in answered]
        off = [value for value in off if math.isfinite(value)]
        scale = [abs(number(two, name)) for _, two in answered if math.isfinite(number(two, name))]
        if off:
            print(f"{name}: mean difference {sum(off) / len(off):.3g}, greatest "
                  f"{max(off, key=abs):.3g}, of a mean of {sum(scale) / len(scale):.3g}")
    if a.csv:
        with open(a.csv, "w", newline="") as file:
            csv.writer(file).writerows(table)
    return 0 if len(answered) == len(pairs) else 1


if __name__ == "__main__":
    sys.exit(main())
