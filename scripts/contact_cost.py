#!/usr/bin/env python3
"""Measures what contact costs on missions/capture.toml, for each way of contact and several steps.

    python3 scripts/contact_cost.py [--steps H,H...] [--methods NAME,NAME...] [--check]
                                    [--limit SECONDS] [PROGRAM]

    --steps    integrator.step of the runs, s (default: 0.0025,0.005,0.01)
    --methods  of flight, modified-mass, barrier, barrier-self (default: all)
    --check    run each once more with a frame of every step, and let `retiarius check-contact` look
               for penetration: how many states and motions, and the deepest
    --limit    processor seconds that a run may take (default: 1200)
    PROGRAM    default: build/ci/program/retiarius

The mission's net is folded once (with threads that keep apart for barrier-self). From this bundle
each run shoots, catches, closes and holds for the same time; `flight` is the same shot without a
target. One thread, one run after the other; give it an idle machine. Prints a table in Markdown:
processor time per simulated second, its ratio to the flight at the same step, Newton iterations,
how deep threads got, and the shares of contact and of the search for it in the steps' time.
"""

import argparse
import json
import os
import re
import resource
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
MISSION = os.path.join(ROOT, "missions", "capture.toml")
METHODS = ["flight", "modified-mass", "barrier", "barrier-self"]
FLIGHT = 3.25  # s, about what the mission takes from the shot to its end


def sections(text):
    """The mission before its phases, the phases, and what follows them."""
    parts = re.split(r"(?m)^(?=\[\[)", text)
    phases = [part for part in parts if part.startswith("[[phase]]")]
    return parts[0], phases


def without(head, table):
    return re.sub(rf"(?ms)^\[{table}\]\n.*?(?=^\[|\Z)", "", head)


def write(folder, name, head, phases):
    path = os.path.join(folder, name + ".toml")
    with open(path, "w") as out:
        out.write(head + "".join(phases) + "[output]\ninterval = 0.01\nframe_interval = 1.0\n")
    return path


def run(program, mission, out, limit, settings=()):
    """Processor seconds and the summary; None where the run does not finish."""
    words = [program, "run", mission, "--quiet", "--threads", "1", "--out", out]
    for setting in settings:
        words += ["--set", setting]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, capture_output=True, text=True, preexec_fn=lambda:
                          resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        why = done.stderr.strip() or f"ended by signal {-done.returncode}"
        print(f"{os.path.basename(mission)}: {why}", file=sys.stderr)
        return None
    with open(os.path.join(out, "summary.json")) as file:
        return after.ru_utime - before.ru_utime, json.load(file)


def checked(program, mission, out, limit, settings):
    """What check-contact finds in the same run with a frame of every step."""
    if run(program, mission, out, limit, [*settings, "output.every_step=true"]) is None:
        return "?"
    words = [program, "check-contact", out, "--json"]
    if "self" in os.path.basename(mission):
        words.append("--self")
    found = json.loads(subprocess.run(words, capture_output=True, text=True).stdout)
    if found["clean"]:
        return f"none in {found['states']} states"
    return (f"{found['penetrations']} at states, {found['approaches'] + found['crossings']} in "
            f"motion, to {1e3 * found['deepest']:.2f} mm")


def contact(phase, method):
    """The phase with this way of contact."""
    lines = {"modified-mass": 'method = "modified-mass"',
             "barrier": 'method = "barrier"',
             "barrier-self": 'method = "barrier"\nself = true'}[method]
    own_step = r"\[phase\.integrator\]\nstep = .*\n"
    return re.sub(own_step, "", phase).replace('method = "barrier"', lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--steps", default="0.0025,0.005,0.01")
    parser.add_argument("--methods", default=",".join(METHODS))
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--limit", type=int, default=1200)
    parser.add_argument("program", nargs="?",
                        default=os.path.join(ROOT, "build", "ci", "program", "retiarius"))
    options = parser.parse_args()
    with open(MISSION) as file:
        head, phases = sections(file.read())
    mesh = os.path.join(ROOT, "missions", "satellite.obj")
    head = head.replace('"satellite.obj"', f'"{mesh}"')
    fold, rest = phases[0], phases[1:]
    empty = without(head, "target")
    shoot = re.sub(r"\[phase\.contact\]\n(?:.+\n)+", "", rest[0])
    flight = [shoot, f'[[phase]]\nkind = "free"\nuntil = "time >= {FLIGHT}"\n']
    with tempfile.TemporaryDirectory() as folder:
        state = {}
        for name in ("apart",) if options.methods == "barrier-self" else ("folded", "apart"):
            if name == "apart" and "barrier-self" not in options.methods:
                continue
            phase = fold
            if name == "apart":
                phase += '[phase.contact]\nmethod = "barrier"\nself = true\n'
            out = os.path.join(folder, name)
            if run(options.program, write(folder, name, head, [phase]), out, options.limit) is None:
                return 1
            state[name] = f'net.state="{out}"'
        print("| contact | step | processor s per s | over flight | iterations | smallest distance | "
              "contact | search |" + (" found by check-contact |" if options.check else "") +
              "\n|---|---|---|---|---|---|---|---|" + ("---|" if options.check else ""))
        base = {}
        for method in options.methods.split(","):
            for step in options.steps.split(","):
                start = state["apart" if method == "barrier-self" else "folded"]
                out = os.path.join(folder, f"{method}-{step}")
                if method == "flight":
                    mission = write(folder, f"{method}-{step}", empty, flight)
                else:
                    mission = write(folder, f"{method}-{step}", head,
                                    [contact(phase, method) for phase in rest])
                settings = [start, f"integrator.step={step}"]
                result = run(options.program, mission, out, options.limit, settings)
                if result is None:
                    print(f"| {method} | {step} | failed | | | | | |")
                    continue
                seconds, summary = result
                end = summary["phases"][-1]["end"]
                cost = seconds / end
                base.setdefault(step, cost if method == "flight" else None)
                ratio = f"{cost / base[step]:.2f}" if base[step] else ""
                m, work = summary["measures"], summary["timings"]["work_seconds"]
                whole = work["assembly"] + work["factorisation"] + work["solution"]
                near = m["smallest_distance"]
                found = ""
                if options.check and method != "flight":
                    found = checked(options.program, mission, out + "-checked", options.limit,
                                    settings)
                print(f"| {method} | {1e3 * float(step):g} ms | {cost:.1f} | {ratio} | "
                      f"{m['newton_iterations']} | {'' if near is None else f'{1e3 * near:.3f} mm'} | "
                      f"{100 * work['contact'] / whole:.0f} % | "
                      f"{100 * work['contact_search'] / whole:.0f} % |" +
                      (f" {found} |" if options.check else ""), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
