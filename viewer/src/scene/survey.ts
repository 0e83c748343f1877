import type { Frame } from "../format/frames";
import type { Recording } from "../format/recording";
import type { Range } from "./colour";
import { isOnNodes, type Quantity, quantities, valueAt } from "./instant";

/** Frames spread over the run: cheap to decode, enough to know its extent and its values. */
export async function sampleFrames(recording: Recording): Promise<Frame[]> {
  const { count } = recording;
  const numbers = new Set<number>();
  const spread = count <= 256 ? 16 : Math.ceil(count / recording.header.key_interval);
  // In a long recording key frames only, which need no other to be decoded.
  const interval = recording.header.key_interval;
  const align = (n: number): number => (count <= 256 ? n : interval * Math.floor(n / interval));
  for (let k = 0; k < spread; ++k)
    numbers.add(align(Math.round((k * (count - 1)) / Math.max(1, spread - 1))));
  const frames: Frame[] = [];
  for (const number of [...numbers].sort((a, b) => a - b))
    frames.push(await recording.load(number));
  return frames;
}

/**
 * For each quantity the range within which nearly all sampled values lie, from 0 to a round number.
 */
export function usualRanges(recording: Recording, frames: Frame[]): Record<Quantity, Range> {
  const { header } = recording;
  const ranges = {} as Record<Quantity, Range>;
  for (const quantity of quantities) {
    const count = isOnNodes(quantity) ? header.nodes : header.segments;
    const stride = Math.max(1, Math.ceil((count * frames.length) / 40000));
    const values: number[] = [];
    for (const frame of frames)
      for (let k = 0; k < count; k += stride) {
        const value = valueAt(header, frame, quantity, k);
        if (value > 0) values.push(value);
      }
    values.sort((a, b) => a - b);
    const high = values[Math.floor(0.98 * (values.length - 1))] ?? 0;
    ranges[quantity] = { low: 0, high: high > 0 ? roundUp(high) : 1, logarithmic: false };
  }
  ranges.contact = { low: 0, high: 2, logarithmic: false };
  return ranges;
}

/** The next of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten. */
export function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const step = [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((s) => s * power >= value * (1 - 1e-9)) ?? 10;
  return Number((step * power).toPrecision(3));
}
