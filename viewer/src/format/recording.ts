import { ChunkReader } from "./chunks";
import { DataError } from "./errors";
import { compressedPart, type Frame, FrameDecoder, type FrameHead, readFrameHead } from "./frames";
import { type Header, readHeader } from "./header";
import { inflate } from "./inflate";

export interface RecordedEnd {
  outcome: string;
  reason: string;
  phases: { name: string; kind: string; start: number; end: number }[];
}

interface StoredFrame extends FrameHead {
  content: Uint8Array;
}

/** Frames from a key frame to before the next, decoded as far as asked for. */
interface Group {
  first: number;
  decoder: FrameDecoder;
  frames: Frame[];
  work: Promise<void>;
  used: number;
}

/** A recording that may still grow. Frames are decoded when asked for; old ones are forgotten. */
export class Recording {
  header!: Header;
  end: RecordedEnd | undefined;
  /** Time of each frame, s. */
  readonly times: number[] = [];
  private readonly reader = new ChunkReader();
  private readonly stored: StoredFrame[] = [];
  private readonly groups = new Map<number, Group>();
  private clock = 0;

  /** At most about this many bytes of decoded frames are kept. */
  constructor(private readonly budget = 320e6) {}

  get count(): number {
    return this.stored.length;
  }
  /** Bytes of whole chunks so far: where the next request for more begins. */
  get bytes(): number {
    return this.reader.taken;
  }
  /** Bytes behind the last whole chunk: of a frame that was cut, or is being written. */
  get torn(): number {
    return this.reader.taken - this.reader.whole;
  }
  phase(frame: number): number {
    return this.stored[frame]!.phase;
  }

  /** Takes more of the file. Throws DataError. */
  async append(bytes: Uint8Array): Promise<void> {
    for (const { name, content } of this.reader.append(bytes)) {
      if (name === "HEAD") this.header = await readHeader(content);
      if (name === "FRAM") this.add(content);
      if (name === "ENDS") this.end = JSON.parse(new TextDecoder().decode(content)) as RecordedEnd;
    }
  }

  /** The frame if it is decoded already. */
  ready(number: number): Frame | undefined {
    const group = this.groups.get(this.keyOf(number));
    if (group) group.used = ++this.clock;
    return group?.frames[number - (group?.first ?? 0)];
  }

  /** Decodes a frame, and with it those of its group before it. Throws DataError. */
  async load(number: number): Promise<Frame> {
    const first = this.keyOf(number);
    let group = this.groups.get(first);
    if (!group) {
      group = {
        first,
        decoder: new FrameDecoder(this.header),
        frames: [],
        work: Promise.resolve(),
        used: 0,
      };
      this.groups.set(first, group);
    }
    group.used = ++this.clock;
    const target = group;
    if (target.frames.length <= number - first) {
      target.work = target.work.then(() => this.extend(target, number));
      await target.work;
    }
    this.forget(target);
    return target.frames[number - first]!;
  }

  private add(content: Uint8Array): void {
    const head = readFrameHead(content);
    if (!this.header)
      throw new DataError("the recording is damaged: a frame comes before the header");
    if (head.number !== this.stored.length)
      throw new DataError(`the recording is damaged: frame ${this.stored.length} is missing`);
    this.stored.push({ ...head, content });
    this.times.push(head.time);
  }

  private keyOf(number: number): number {
    let first = Math.min(number, this.stored.length - 1);
    while (first > 0 && !this.stored[first]!.key) --first;
    return first;
  }

  private async extend(group: Group, number: number): Promise<void> {
    for (let k = group.first + group.frames.length; k <= number; ++k) {
      const { content } = this.stored[k]!;
      const stream = await inflate(compressedPart(this.header, content), "deflate");
      group.frames.push(group.decoder.decode(content, stream));
    }
  }

  private forget(kept: Group): void {
    const size = 18 * this.header.nodes + 4 * this.header.segments;
    let total = 0;
    for (const group of this.groups.values()) total += group.frames.length * size;
    const oldest = [...this.groups.values()].sort((a, b) => a.used - b.used);
    for (const group of oldest) {
      if (total <= this.budget) return;
      if (group === kept) continue;
      total -= group.frames.length * size;
      this.groups.delete(group.first);
    }
  }
}
