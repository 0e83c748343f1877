import { DataError } from "./errors";
import type { Header } from "./header";
import type { Minifloat } from "./minifloat";

type Codes = Int16Array | Int32Array;

/** One instant as recorded: integers, with what turns them into numbers in the header. */
export interface Frame {
  time: number;
  phase: number;
  /** x, y, z in quanta. */
  x: Int32Array;
  y: Int32Array;
  z: Int32Array;
  /** Codes of tension, strain, curvature, speed, in this order. */
  channels: Codes[];
  touch: Uint8Array;
  /** Of each body: position, then the quaternion x, y, z, w. */
  poses: Float32Array;
}

export interface FrameHead {
  time: number;
  number: number;
  phase: number;
  key: boolean;
}

const fixedBytes = 20;
const [tension, strain, speed, sequences] = [3, 4, 6, 7];

/** What a FRAM chunk says before its compressed part. */
export function readFrameHead(content: Uint8Array): FrameHead {
  if (content.length < fixedBytes)
    throw new DataError("the recording is damaged: a frame is too short");
  const view = new DataView(content.buffer, content.byteOffset, content.byteLength);
  return {
    time: view.getFloat64(0, true),
    number: view.getUint32(8, true),
    phase: view.getInt32(12, true),
    key: view.getUint32(16, true) === 0,
  };
}

/** The compressed part of a FRAM chunk. */
export function compressedPart(header: Header, content: Uint8Array): Uint8Array {
  return content.subarray(fixedBytes + 28 * header.bodies.length);
}

/** Fewer bytes where the codes allow it. */
function compact(codes: Int32Array): Codes {
  for (let k = 0; k < codes.length; ++k) if (codes[k] !== (codes[k]! << 16) >> 16) return codes;
  return Int16Array.from(codes);
}

/** Decodes frames one after another from a key frame on. */
export class FrameDecoder {
  private last: Int32Array[] = [];
  private before: Int32Array[] = [];
  private touch = new Uint8Array(0);
  private time = 0;
  private next = -1;
  private since = 0;

  constructor(private readonly header: Header) {}

  /** `stream` is the inflated compressed part of `content`. Throws DataError. */
  decode(content: Uint8Array, stream: Uint8Array): Frame {
    const head = readFrameHead(content);
    if (head.key) this.since = 0;
    else if (head.number !== this.next || this.since === 0)
      throw new DataError(`the recording is damaged: frame ${head.number} lacks the one before it`);
    const bodies = fixedBytes + 28 * this.header.bodies.length;
    const poses = new Float32Array(content.slice(fixedBytes, bodies).buffer);
    const codes: Int32Array[] = [];
    let place = 0;
    const need = (count: number): Uint8Array => {
      if (place + count > stream.length)
        throw new DataError("the recording is damaged: a frame is cut");
      place += count;
      return stream.subarray(place - count, place);
    };
    for (let s = 0; s < sequences; ++s) {
      const [method, planes] = need(2) as unknown as [number, number];
      if (planes > 4 || (method & ~11) !== 0)
        throw new DataError("the recording is damaged: a frame uses an unknown method");
      const count = this.count(s);
      const residuals = new Int32Array(count);
      for (let p = 0; p < planes; ++p) {
        const plane = need(count);
        for (let k = 0; k < count; ++k) residuals[k]! |= plane[k]! << (8 * p);
      }
      codes.push(this.restored(s, method, residuals, codes, head.time));
    }
    const touch = need(this.header.nodes).slice();
    if (!head.key) for (let k = 0; k < touch.length; ++k) touch[k]! ^= this.touch[k]!;
    this.before = this.last;
    this.last = codes;
    this.touch = touch;
    this.time = head.time;
    this.next = head.number + 1;
    ++this.since;
    return {
      time: head.time,
      phase: head.phase,
      x: codes[0]!,
      y: codes[1]!,
      z: codes[2]!,
      channels: codes.slice(3).map(compact),
      touch,
      poses,
    };
  }

  private count(sequence: number): number {
    return sequence === tension || sequence === strain ? this.header.segments : this.header.nodes;
  }

  /** Codes from folded residuals, in place. */
  private restored(
    s: number,
    method: number,
    r: Int32Array,
    codes: Int32Array[],
    time: number,
  ): Int32Array {
    const kind = method & 3;
    const needed = kind === 1 ? 1 : kind === 2 ? 2 : kind === 3 && s === speed ? 1 : 0;
    if (this.since < needed || (kind === 3 && s !== strain && s !== speed))
      throw new DataError("the recording is damaged: a frame uses an unknown method");
    const neighbour = (method & 8) !== 0;
    const last = this.last[s];
    const line = this.before[s];
    const base = kind === 3 ? this.derived(s, codes, time) : undefined;
    let sum = 0;
    for (let k = 0; k < r.length; ++k) {
      const residual = (r[k]! >>> 1) ^ -(r[k]! & 1);
      sum = neighbour ? (sum + residual) | 0 : residual;
      let guess = 0;
      if (kind === 1) guess = last![k]!;
      else if (kind === 2) guess = 2 * last![k]! - line![k]!;
      else if (base) guess = base[k]!;
      r[k] = (guess + sum) | 0;
    }
    return r;
  }

  private derived(s: number, codes: Int32Array[], time: number): Int32Array {
    const guess = new Int32Array(this.count(s));
    const last = this.last[s];
    const scale = this.header.channels[s - 3]!.scale;
    if (s === strain) this.strainGuess(guess, codes, scale, last);
    else if (time > this.time) {
      const step = this.header.quantum / (time - this.time);
      for (let k = 0; k < guess.length; ++k) {
        let square = 0;
        for (let axis = 0; axis < 3; ++axis) {
          const d = (codes[axis]![k]! - this.last[axis]![k]!) | 0;
          square += d * d;
        }
        guess[k] = scale.code(Math.max(0, 2 * (Math.sqrt(square) * step) - scale.value(last![k]!)));
      }
    }
    return guess;
  }

  private strainGuess(
    guess: Int32Array,
    codes: Int32Array[],
    scale: Minifloat,
    last?: Int32Array,
  ): void {
    const force = this.header.channels[0]!.scale;
    const tensions = codes[tension]!;
    const before = this.last[tension];
    for (let k = 0; k < guess.length; ++k) {
      const stiffness = this.header.stiffness[k]!;
      if (tensions[k] !== 0 && stiffness > 0)
        guess[k] = scale.code(force.value(tensions[k]!) / stiffness);
      else if (this.since > 0 && before![k] === 0) guess[k] = last![k]!;
      else guess[k] = this.slackStrain(k, codes, scale);
    }
  }

  /** Of the segment's length in the decoded positions. */
  private slackStrain(segment: number, codes: Int32Array[], scale: Minifloat): number {
    const { ends, quantum, restLength } = this.header;
    let square = 0;
    for (let axis = 0; axis < 3; ++axis) {
      const d = (codes[axis]![ends[2 * segment + 1]!]! - codes[axis]![ends[2 * segment]!]!) | 0;
      square += d * d;
    }
    return scale.code((Math.sqrt(square) * quantum) / restLength[segment]! - 1);
  }
}
