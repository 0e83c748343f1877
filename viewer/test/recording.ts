// A tiny recording made by hand for the tests, the way docs/viewer.md describes it.
import { deflateSync } from "node:zlib";
import { crc32 } from "../src/format/crc32";

export const nodes = 3;
export const segments = 2;

function little(...parts: [kind: "u32" | "i32" | "f32" | "f64", value: number][]): Uint8Array {
  const view = new DataView(
    new ArrayBuffer(parts.reduce((n, [kind]) => n + (kind === "f64" ? 8 : 4), 0)),
  );
  let place = 0;
  for (const [kind, value] of parts) {
    if (kind === "u32") view.setUint32(place, value, true);
    if (kind === "i32") view.setInt32(place, value, true);
    if (kind === "f32") view.setFloat32(place, value, true);
    if (kind === "f64") view.setFloat64(place, value, true);
    place += kind === "f64" ? 8 : 4;
  }
  return new Uint8Array(view.buffer);
}

export function join(...parts: Uint8Array[]): Uint8Array {
  const all = new Uint8Array(parts.reduce((n, p) => n + p.length, 0));
  let place = 0;
  for (const part of parts) {
    all.set(part, place);
    place += part.length;
  }
  return all;
}

export function chunk(name: string, content: Uint8Array): Uint8Array {
  const head = join(new TextEncoder().encode(name), little(["u32", content.length]), content);
  return join(head, little(["u32", crc32(head)]));
}

export function preamble(format = 1): Uint8Array {
  return join(new TextEncoder().encode("RETREPL\n"), little(["u32", format], ["u32", 0]));
}

export function head(): Uint8Array {
  const list: [string, "u32" | "f64", number[], number[]][] = [
    ["segments", "u32", [2, 2], [0, 1, 1, 2]],
    ["material", "u32", [2], [0, 0]],
    ["rest_length", "f64", [2], [1, 1]],
    ["mass", "f64", [3], [0.1, 0.2, 0.1]],
    ["knots", "u32", [1], [1]],
  ];
  const text = {
    title: "Tiny",
    program: "retiarius test",
    nodes,
    segments,
    size: 2,
    quantum: 0.5,
    error: 0.25,
    key_interval: 64,
    channels: [
      { name: "tension", unit: "N", on: "segment", quantum: 0.01, steps: 128 },
      { name: "strain", unit: "1", on: "segment", quantum: 1e-4, steps: 128 },
      { name: "curvature", unit: "1/m", on: "node", quantum: 0.1, steps: 64 },
      { name: "speed", unit: "m/s", on: "node", quantum: 0.1, steps: 64 },
    ],
    materials: [{ radius: 0.001, axial_stiffness: 100 }],
    corners: [0, 2],
    bullets: [{ node: 0, mass: 0.1, radius: 0.01 }],
    phases: [
      { name: "shoot", kind: "shoot" },
      { name: "spread", kind: "spread" },
    ],
    bodies: [],
    arrays: list.map(([name, type, shape]) => ({ name, type, shape })),
  };
  const json = new TextEncoder().encode(JSON.stringify(text));
  const arrays = list.flatMap(([, type, , values]) => values.map((v) => little([type, v])));
  return chunk("HEAD", join(little(["u32", json.length]), json, deflateSync(join(...arrays))));
}

/** One sequence of a frame: method, and residuals as they are folded. */
export interface Sequence {
  method: number;
  residuals: number[];
}

function planes({ method, residuals }: Sequence): Uint8Array {
  const folded = residuals.map((r) => ((r << 1) ^ (r >> 31)) >>> 0);
  const largest = Math.max(0, ...folded);
  const count = largest === 0 ? 0 : Math.ceil((32 - Math.clz32(largest)) / 8);
  const bytes = [method, count];
  for (let p = 0; p < count; ++p) for (const n of folded) bytes.push((n >>> (8 * p)) & 255);
  return Uint8Array.from(bytes);
}

export function frame(
  number: number,
  time: number,
  phase: number,
  sequences: Sequence[],
  touch = [0, 0, 0],
): Uint8Array {
  const fixed = little(
    ["f64", time],
    ["u32", number],
    ["i32", phase],
    ["u32", number % 64 === 0 ? 0 : 1],
  );
  return chunk(
    "FRAM",
    join(fixed, deflateSync(join(...sequences.map(planes), Uint8Array.from(touch)))),
  );
}

const zeros = (n: number): Sequence => ({ method: 0, residuals: new Array<number>(n).fill(0) });

/** A key frame with nodes at x = 0, 2, 4 quanta. */
export function firstFrame(): Uint8Array {
  return frame(
    0,
    0,
    0,
    [
      { method: 8, residuals: [0, 2, 2] },
      zeros(3),
      zeros(3),
      { method: 0, residuals: [100, 0] },
      { method: 3, residuals: [0, -5] },
      { method: 0, residuals: [3, 3, 3] },
      { method: 0, residuals: [10, 10, 10] },
    ],
    [0, 1, 2],
  );
}

export function secondFrame(): Uint8Array {
  return frame(
    1,
    0.5,
    1,
    [
      { method: 1, residuals: [1, 1, 1] },
      { method: 1, residuals: [0, -300, 0] },
      { method: 0, residuals: [0, 0, 70000] },
      { method: 1, residuals: [-100, 7] },
      { method: 3, residuals: [0, 0] },
      { method: 9, residuals: [1, 0, 0] },
      { method: 3, residuals: [0, 0, 0] },
    ],
    [0, 1, 0],
  );
}

export function tiny(): Uint8Array {
  return join(
    preamble(),
    head(),
    firstFrame(),
    secondFrame(),
    chunk("ENDS", new TextEncoder().encode('{"outcome":"finished","reason":"","phases":[]}')),
  );
}
