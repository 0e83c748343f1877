#!/usr/bin/env python3
"""Simulates campaigns on 10 to 10,000 cores from what was measured on one machine.

    python3 scripts/campaign_scaling.py [options] DATABASE

    DATABASE         campaign.sqlite of a real campaign, or one of its shards, whose times of
                     runs are drawn from
    --figures FILE   of campaign_figures.py --json: hand-out, row, file and collection
    --share S        runs for each core (default: 100)
    --runs N         so many runs on any number of cores instead
    --launch S       between two starts of tasks by the cluster's controller, s (default: 0.01)
    --begin S        from a task's start to its first run, s (default: 0.05)
    --open S         added to each file's opening, for a shared file system, s (default: 0.002)
    --name S         to look at a file's name there, s (default: 0.00001)

Engines are simulated as they work. MPI: whoever is free asks rank 0, which answers one after the
other, each answer as long as measured, and every rank looks for messages once in a millisecond.
Slurm: tasks of equal numbers of runs, started one after the other by the controller; each first
looks through the names of the files that all tasks before have made, then does its runs one by one. At the end one
process collects the rows of all files. What is printed is the share of ideal: sum of the runs' times over cores times
time, without and with the collection.
"""

import argparse
import heapq
import json
import random
import sqlite3
import statistics
import sys

CORES = [10, 30, 100, 300, 1000, 3000, 10000]
POLL = 1e-3  # s, of a rank between two looks for messages
# Measured on two cores of 2.5 GHz with a solid-state disk; see campaign_figures.py.
FIGURES = {"overhead": 3.0, "hand_out": 0.06, "shard": 0.3, "collect": 0.12}  # ms


def run_times(database):
    with sqlite3.connect(f"file:{database}?mode=ro", uri=True) as base:
        tables = [row[0] for row in base.execute("SELECT name FROM sqlite_master")]
        table = "timings" if "timings" in tables else "runs"
        times = [row[0] for row in base.execute(f"SELECT wall_time FROM {table}")]
    if len(times) < 30:
        sys.exit(f"{database}: {len(times)} runs are too few to draw from")
    return times


def by_mpi(rng, times, cores, runs, f):
    """Seconds until all are done, and the sum of the runs' times."""
    free = [(rng.uniform(0, POLL), k) for k in range(min(cores, runs))]
    heapq.heapify(free)
    server = work = end = 0.0
    for _ in range(runs):
        asked, core = heapq.heappop(free)
        server = max(server, asked) + f["hand_out"]  # rank 0 answers in the order of asking
        took = rng.choice(times)
        work += took
        # Half a look's distance until rank 0 sees the question, half until the answer is seen.
        done = server + POLL + took + f["overhead"]
        end = max(end, done)
        heapq.heappush(free, (done, core))
    return end, work


def by_slurm(rng, times, cores, runs, batch, f, launch, begin, name):
    tasks = (runs + batch - 1) // batch
    free = [0.0] * min(cores, tasks)
    controller = work = end = 0.0
    for task in range(tasks):
        controller = max(controller + launch, heapq.heappop(free))
        took = begin + task * name
        for _ in range(min(batch, runs - task * batch)):
            run = rng.choice(times)
            work += run
            took += run + f["overhead"]
        done = controller + took
        end = max(end, done)
        heapq.heappush(free, done)
    return end, work


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("database")
    parser.add_argument("--figures")
    parser.add_argument("--share", type=int, default=100)
    parser.add_argument("--runs", type=int)
    parser.add_argument("--launch", type=float, default=0.01)
    parser.add_argument("--begin", type=float, default=0.05)
    parser.add_argument("--open", type=float, default=0.002)
    parser.add_argument("--name", type=float, default=1e-5)
    a = parser.parse_args()
    times = run_times(a.database)
    measured = dict(FIGURES)
    if a.figures:
        with open(a.figures) as file:
            measured.update({k: v for k, v in json.load(file).items() if k in FIGURES})
    f = {key: 1e-3 * value for key, value in measured.items()}  # s
    f["shard"] += a.open
    mean = statistics.fmean(times)
    print(f"{len(times)} runs: mean {mean:.3g} s, deviation {statistics.pstdev(times):.3g} s, "
          f"longest {max(times):.3g} s")
    print("a run's row {overhead:.3g} ms, hand-out {hand_out:.3g} ms, file {shard:.3g} ms, "
          "collecting a row {collect:.3g} ms".format(**{k: 1e3 * v for k, v in f.items()}))
    print(f"rank 0 can feed {mean / f['hand_out']:.3g} cores\n")
    print("cores     runs  mpi          slurm, tasks for each core:   collecting")
    print("                             1      4      16               after it")
    for cores in CORES:
        runs = a.runs or a.share * cores
        rng = random.Random(cores)
        cells = []
        end, work = by_mpi(rng, times, cores, runs, f)
        cells.append(f"{100 * work / (cores * end):5.1f} %")
        shortest = end
        for share in (1, 4, 16):
            batch = max(1, round(runs / (cores * share)))
            end, work = by_slurm(rng, times, cores, runs, batch, f, a.launch, a.begin, a.name)
            cells.append(f"{100 * work / (cores * end):5.1f}")
            shortest = min(shortest, end)
        collect = runs * f["collect"] + 4 * cores * f["shard"]
        print(f"{cores:5} {runs:8}  {cells[0]}      {cells[1]}  {cells[2]}  {cells[3]} %"
              f"        {collect:6.1f} s of {shortest:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
