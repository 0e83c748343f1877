import { describe, expect, it } from "vitest";
import { Table } from "../src/data/table";
import { nearestFrame, phasesOfFrames, placeOf, steppedTime } from "../src/data/timeline";
import { joined, valueAt } from "../src/ui/chart";
import { plotsOf } from "../src/ui/plots";

const times = [0, 0.1, 0.2, 0.4];

describe("the timeline", () => {
  it("finds an instant between frames", () => {
    expect(placeOf(times, 0.25)).toEqual({ frame: 2, fraction: expect.closeTo(0.25, 12) });
    expect(placeOf(times, 0.1)).toEqual({ frame: 1, fraction: 0 });
    expect(placeOf(times, -1)).toEqual({ frame: 0, fraction: 0 });
    expect(placeOf(times, 9)).toEqual({ frame: 3, fraction: 0 });
    expect(placeOf([], 1)).toEqual({ frame: 0, fraction: 0 });
  });
  it("knows the nearest frame", () => {
    expect([0.04, 0.06, 0.31, 0.29].map((t) => nearestFrame(times, t))).toEqual([0, 1, 3, 2]);
  });
  it("steps from frame to frame", () => {
    expect(steppedTime(times, 0.1, 1)).toBe(0.2);
    expect(steppedTime(times, 0.15, 1)).toBe(0.2);
    expect(steppedTime(times, 0.15, -1)).toBe(0.1);
    expect(steppedTime(times, 0, -1)).toBe(0);
    expect(steppedTime(times, 0.4, 1)).toBe(0.4);
  });
  it("reads phases from frames", () => {
    const names = [{ name: "shoot", kind: "shoot" }];
    expect(phasesOfFrames(times, [0, 0, 1, 1], names)).toEqual([
      { name: "shoot", kind: "shoot", start: 0, end: 0.1 },
      { name: "phase 1", kind: "", start: 0.1, end: 0.4 },
    ]);
  });
});

describe("the history", () => {
  const csv =
    "time,step,mouth_area,contacts,momentum_x,newton_iterations\n0,0,2,0,5,0\n0.5,2,,0,5.5,8\n1,4,3,0,4,20\n1.5,6,9";
  it("takes whole rows, with gaps", () => {
    const table = new Table(csv);
    expect(table.rows).toBe(3);
    expect(table.column("mouth_area")).toEqual(Float64Array.of(2, NaN, 3));
    expect(table.column("absent")).toBeUndefined();
    expect(new Table("").rows).toBe(0);
  });
  it("is plotted without what says nothing", () => {
    const table = new Table(csv);
    const plots = plotsOf([table]);
    expect(plots.map((p) => p.title)).toEqual([
      "Mouth area",
      "Change of momentum",
      "Newton iterations per step",
    ]);
    expect(plots[1]!.curves[0]!.values(table)).toEqual(Float64Array.of(0, 0.5, -1));
    expect(plots[2]!.curves[0]!.values(table)).toEqual(Float64Array.of(NaN, 4, 6));
  });
  it("joins runs with different rows", () => {
    const lines = [
      { x: [0, 1], y: [5, NaN] },
      { x: [0.5, 1], y: [6, 7] },
    ].map((l) => ({ label: "", colour: 0, ...l }));
    expect(joined(lines)).toEqual([
      [0, 0.5, 1],
      [5, null, null],
      [null, 6, 7],
    ]);
  });
  it("has a value between rows and none outside", () => {
    const line = { x: [0, 1, 3], y: [0, 10, 30] };
    expect([0, 0.5, 2, 3].map((t) => valueAt(line, t))).toEqual([0, 5, 20, 30]);
    expect(valueAt(line, 3.1)).toBeNaN();
    expect(valueAt({ x: [], y: [] }, 0)).toBeNaN();
  });
});
