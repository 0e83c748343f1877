"""Plots mouth area and peak tension of a run: python3 plot_run.py DIR/run.h5 [picture.png]"""
import sys

import h5py
import matplotlib.pyplot as plt

with h5py.File(sys.argv[1], "r", swmr=True) as run:
    figure, axes = plt.subplots(2, sharex=True)
    for axis, name in zip(axes, ["mouth_area", "peak_tension"]):
        column = run["history"][name]
        axis.plot(run["history/time"][:], column[:])
        axis.set_ylabel(f"{name} / {column.attrs['units'].decode()}")
    axes[1].set_xlabel("time / s")
    plt.savefig(sys.argv[2]) if len(sys.argv) > 2 else plt.show()
