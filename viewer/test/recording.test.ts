import { describe, expect, it } from "vitest";
import { Recording } from "../src/format/recording";
import { positionAt, valueAt } from "../src/scene/instant";
import { chunk, firstFrame, frame, head, join, preamble, secondFrame, tiny } from "./recording";

async function read(...parts: Uint8Array[]): Promise<Recording> {
  const recording = new Recording();
  for (const part of parts) await recording.append(part);
  return recording;
}

describe("a recording", () => {
  it("gives positions and values as they were written", async () => {
    const recording = await read(tiny());
    expect(recording.times).toEqual([0, 0.5]);
    expect(recording.end?.outcome).toBe("finished");
    expect(recording.torn).toBe(0);
    const { header } = recording;
    expect(header.restLength).toEqual(Float64Array.of(1, 1));
    const first = await recording.load(0);
    expect([0, 1, 2].map((n) => positionAt(header, first, n)[0])).toEqual([0, 1, 2]);
    expect(valueAt(header, first, "tension", 0)).toBeCloseTo(1, 12);
    // Of the tension of 1 N on 100 N follows a strain of 0.01, code 100; of no tension, none.
    expect(first.channels[1]![0]).toBe(100);
    expect(first.channels[1]![1]).toBe(-5);
    expect(valueAt(header, first, "contact", 2)).toBe(2);
  });

  it("follows each kind of prediction", async () => {
    const recording = await read(tiny());
    const second = await recording.load(1);
    const { header } = recording;
    expect([...second.x]).toEqual([1, 3, 5]);
    expect([...second.y]).toEqual([0, -300, 0]);
    expect([...second.z]).toEqual([0, 0, 70000]);
    expect([...second.channels[0]!]).toEqual([0, 7]);
    // Slack now, taut before: from its length of 150 m; under tension: 0.07 N on 100 N.
    const length = 0.5 * Math.hypot(2, 300);
    expect([...second.channels[1]!]).toEqual([header.channels[1]!.scale.code(length - 1), 7]);
    expect([...second.channels[2]!]).toEqual([4, 4, 4]);
    // One quantum in half a second is 1 m/s; twice that less the 1 m/s before.
    expect(valueAt(header, second, "speed", 0)).toBeCloseTo(1, 12);
    expect([...second.touch]).toEqual([0, 0, 2]);
    expect(recording.phase(1)).toBe(1);
  });

  it("is the same however it arrives", async () => {
    const bytes = tiny();
    const pieces = Array.from(bytes, (_, k) => bytes.subarray(k, k + 1));
    const recording = await read(...pieces);
    expect(recording.count).toBe(2);
    expect((await recording.load(1)).x).toEqual((await (await read(bytes)).load(1)).x);
  });

  it("shows what is there of a recording that is cut", async () => {
    const start = join(preamble(), head(), firstFrame());
    const recording = await read(start, secondFrame().subarray(0, 30));
    expect(recording.count).toBe(1);
    expect(recording.torn).toBe(30);
    expect(recording.end).toBeUndefined();
    await recording.append(secondFrame().subarray(30));
    expect(recording.count).toBe(2);
  });

  it("forgets decoded frames beyond its budget and decodes them again", async () => {
    const parts = [preamble(), head(), firstFrame()];
    const key = firstFrame().subarray(8, -4);
    for (let k = 1; k < 4; ++k) {
      const content = key.slice();
      new DataView(content.buffer).setFloat64(0, k, true);
      new DataView(content.buffer).setUint32(8, k, true);
      parts.push(chunk("FRAM", content));
    }
    const recording = new Recording(100);
    for (const part of parts) await recording.append(part);
    for (let k = 0; k < 4; ++k) await recording.load(k);
    expect(recording.ready(0)).toBeUndefined();
    expect(recording.ready(3)).toBeDefined();
    expect([...(await recording.load(0)).x]).toEqual([0, 2, 4]);
  });
});

describe("a damaged recording", () => {
  it.each([
    [
      "other bytes",
      () => new TextEncoder().encode("PK nothing of ours"),
      "it does not start with the letters RETREPL",
    ],
    ["a newer format", () => preamble(2), "has format 2, this page reads format 1"],
    [
      "a flipped bit",
      () => tiny().map((b, k) => (k === 200 ? b ^ 1 : b)),
      "wrong checksum at byte 16",
    ],
    [
      "a frame before the header",
      () => join(preamble(), firstFrame()),
      "a frame comes before the header",
    ],
    ["a missing frame", () => join(preamble(), head(), secondFrame()), "frame 0 is missing"],
  ])("says so: %s", async (_, bytes, message) => {
    await expect(read(bytes())).rejects.toThrow(message);
  });

  it("says so when a frame is decoded", async () => {
    const empty = await read(preamble(), head(), frame(0, 0, 0, []));
    await expect(empty.load(0)).rejects.toThrow("a frame is cut");
    const line = await read(
      preamble(),
      head(),
      frame(0, 0, 0, [{ method: 2, residuals: [0, 0, 0] }]),
    );
    await expect(line.load(0)).rejects.toThrow("unknown method");
    const short = read(preamble(), head(), chunk("FRAM", firstFrame().subarray(8, 27)));
    await expect(short).rejects.toThrow("a frame is too short");
    const noStream = await read(preamble(), head(), chunk("FRAM", firstFrame().subarray(8, 40)));
    await expect(noStream.load(0)).rejects.toThrow("does not inflate");
  });
});
