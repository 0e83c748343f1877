import { describe, expect, it } from "vitest";
import { crc32 } from "../src/format/crc32";
import { Minifloat } from "../src/format/minifloat";
import { numberText, spaced, unitText, withUnit } from "../src/format/number";

describe("a minifloat", () => {
  it("keeps its error over many orders of magnitude", () => {
    const scale = new Minifloat(1e-7, 128);
    for (let value = 1e-12; value < 1e9; value *= 1.037) {
      const error = Math.abs(scale.value(scale.code(value)) - value);
      expect(error).toBeLessThanOrEqual(Math.max(0.5e-7, value / 256) * (1 + 1e-9));
      expect(scale.code(-value) + scale.code(value)).toBe(0);
    }
  });
  it("has one code for each of its values", () => {
    const scale = new Minifloat(0.5, 8);
    for (let code = 0; code < 400; ++code) expect(scale.code(scale.value(code))).toBe(code);
  });
});

it("checks sums as zlib does", () => {
  expect(crc32(new TextEncoder().encode("123456789"))).toBe(0xcbf43926);
});

describe("numbers", () => {
  it.each([
    [0, "0"],
    [1234.567, "1235"],
    [-0.07071, "\u22120.07071"],
    [1.872e-13, "1.872\u00b710\u207b\u00b9\u00b3"],
    [2e7, "2\u00b710\u2077"],
    [NaN, "\u2013"],
    [0.3000000001, "0.3"],
  ])("%d reads well", (value, text) => expect(numberText(value)).toBe(text));
  it("carry units", () => {
    expect(unitText("kg m2/s")).toBe("kg m\u00b2/s");
    expect(unitText("1")).toBe("");
    expect(withUnit(2.5, "m2")).toBe("2.5\u00a0m\u00b2");
    expect(spaced("mouth_area_max")).toBe("Mouth area max");
  });
});
