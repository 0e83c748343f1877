"""Draws what update-benchmarks.sh measured: python3 plot_results.py benchmarks/results/MACHINE"""
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "retiarius"  # the same picture for the same numbers
import matplotlib.pyplot as plt


def table(path):
    """The rows of a CSV file as dicts, and its line about machine and build."""
    with open(path, newline="") as file:
        lines = file.read().splitlines()
    about = [line[1:].strip() for line in lines if line.startswith("#")]
    return list(csv.DictReader(l for l in lines if not l.startswith("#"))), " ".join(about)


def save(figure, path, about):
    figure.text(0.01, 0.01, about, fontsize=6)
    figure.savefig(path, metadata={"Date": None})
    print(path)


def draw_step_time(folder):
    """Step time against nodes, beside real time and what Huang et al. (2022, Fig. 16) state."""
    rows, about = table(folder / "step-time.csv")
    if (folder / "threads.csv").exists():
        rows += [r for r in table(folder / "threads.csv")[0] if r["threads"] == "1"]
    figure, axis = plt.subplots(figsize=(7, 5))
    names = {("3", "1"): "3 inner nodes a piece, across knots", ("9", "1"): "9, across knots",
             ("9", "0"): "9, hinged", ("0", "1"): "none, across knots"}
    for (s, across), name in names.items():
        for single, style in ((False, "-"), (True, ":")):
            mine = [r for r in rows if r["s"] == s and r["across"] == across and r["h"] == "0.01"
                    and (r["solver"] == "single") == single]
            points = sorted((int(r["nodes"]), 1e3 * float(r["step"])) for r in mine)
            if points:
                label = name + (", single update" if single else "")
                axis.loglog(*zip(*points), style, marker=".", label=label)
    axis.loglog([300, 2e5], [10, 10], "k--", linewidth=0.8, label="real time at h = 0.01 s")
    axis.loglog([1000], [10], "ks", label="Huang et al. 2022: real time up to 1,000 nodes")
    axis.set_xlabel("nodes")
    axis.set_ylabel("time of a step / ms")
    axis.legend(fontsize=7)
    axis.grid(True, which="both", linewidth=0.2)
    save(figure, folder / "step-time.svg", about)


def draw_flights(folder):
    """Wall time of the stiff net's flight by each integrator, with its error."""
    rows, about = table(folder / "flights.csv")
    sizes = sorted({int(r["segments"]) for r in rows})
    ways = list(dict.fromkeys(r["way"] for r in rows))
    figure, axis = plt.subplots(figsize=(7, 4))
    for k, way in enumerate(ways):
        for place, size in enumerate(sizes):
            for r in (r for r in rows if r["way"] == way and int(r["segments"]) == size):
                at = place + 0.2 * (k - 0.5 * (len(ways) - 1))
                axis.bar(at, float(r["seconds"]), 0.18, color=f"C{k}",
                         label=way if place == 0 else None)
                note = f"{100 * float(r['error']):.2g} %"
                if r["until"] != rows[0]["until"]:
                    note += f"\n({r['until']} s)"
                axis.annotate(note, (at, float(r["seconds"])), ha="center", va="bottom", fontsize=6)
    axis.set_yscale("log")
    axis.margins(y=0.15)
    axis.set_xticks(range(len(sizes)), [f"{n} segments a piece" for n in sizes])
    axis.set_ylabel(f"wall time for {rows[0]['until']} s of flight / s")
    axis.legend(fontsize=7)
    save(figure, folder / "flights.svg", about + "; above the bars: error of the mouth's area")


def main():
    folder = pathlib.Path(sys.argv[1])
    for name, draw in (("step-time", draw_step_time), ("flights", draw_flights)):
        if (folder / f"{name}.csv").exists():
            draw(folder)


if __name__ == "__main__":
    main()
