import { describe, expect, it } from "vitest";
import {
  oklch,
  placeInRange,
  scaleBytes,
  scaleColour,
  type Rgb,
  valueAtPlace,
} from "../src/scene/colour";
import { roundUp } from "../src/scene/survey";

const linear = (c: number): number => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const luminance = ([r, g, b]: Rgb): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;
/** Linear colours as people without green or without red cones see them, after Vienot et al. (1999). */
const without =
  (red: number, blue: number) =>
  ([r, g, b]: Rgb): Rgb => [red * r + (1 - red) * g, red * r + (1 - red) * g, b + blue * (r - g)];
const views = [(c: Rgb): Rgb => c, without(0.29275, -0.02234), without(0.11238, 0.00401)];

describe.each(["light", "dark"] as const)("the scale on a %s ground", (theme) => {
  const steps = Array.from({ length: 101 }, (_, k) => scaleColour(k / 100, theme));
  it("rises evenly in lightness, for colour-blind readers too", () => {
    const sign = theme === "dark" ? 1 : -1;
    for (const view of views) {
      const light = steps.map((c) => Math.cbrt(luminance(view(c.map(linear) as Rgb))));
      const rises = light.slice(1).map((l, k) => sign * (l - light[k]!));
      const mean = rises.reduce((a, b) => a + b, 0) / rises.length;
      expect(mean).toBeGreaterThan(0.003);
      for (const rise of rises) expect(rise).toBeGreaterThan(0.3 * mean);
    }
  });
  it("stays within what displays show, so that no part of it is flat", () => {
    for (const colour of steps) for (const c of colour) expect(c).toBeGreaterThan(0.0);
    for (const colour of steps) for (const c of colour) expect(c).toBeLessThan(1.0);
  });
  it("is given to the graphics card as it is", () => {
    const bytes = scaleBytes(theme, false);
    for (const k of [0, 100, 255])
      expect([...bytes.slice(4 * k, 4 * k + 3)]).toEqual(
        scaleColour(k / 255, theme).map((c) => Math.round(255 * c)),
      );
  });
});

it("knows white, black and grey", () => {
  expect(oklch(1, 0, 0).map((c) => Math.round(1000 * c))).toEqual([1000, 1000, 1000]);
  expect(oklch(0, 0, 0)).toEqual([0, 0, 0]);
});

describe("ranges", () => {
  it("place values and give them back", () => {
    for (const range of [
      { low: -1, high: 3, logarithmic: false },
      { low: 0.01, high: 10, logarithmic: true },
    ])
      for (const t of [0, 0.3, 1])
        expect(placeInRange(valueAtPlace(t, range), range)).toBeCloseTo(t, 12);
  });
  it("clamp what lies outside", () => {
    expect(placeInRange(-5, { low: 0, high: 1, logarithmic: false })).toBe(0);
    expect(placeInRange(5, { low: 0, high: 1, logarithmic: false })).toBe(1);
    expect(placeInRange(0, { low: 0.1, high: 1, logarithmic: true })).toBe(0);
    expect(placeInRange(2, { low: 1, high: 1, logarithmic: false })).toBe(1);
  });
  it("end at round numbers", () => {
    expect([0.0123, 1, 7.2, 95, 441].map(roundUp)).toEqual([0.015, 1, 8, 100, 500]);
  });
});
