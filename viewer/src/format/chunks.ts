import { crc32 } from "./crc32";
import { DataError } from "./errors";

export interface Chunk {
  name: string;
  content: Uint8Array;
}

const magic = "RETREPL\n";
const preamble = 16;
const before = 8;
const after = 4;

function text(bytes: Uint8Array): string {
  return String.fromCharCode(...bytes);
}

/**
 * Takes a recording's bytes as they arrive and gives its whole chunks. What is behind the last
 * whole chunk is kept until the rest of it arrives.
 */
export class ChunkReader {
  private rest = new Uint8Array(0);
  private started = false;
  /** Bytes taken so far, and those of them that belong to whole chunks. */
  taken = 0;
  whole = 0;

  /** Throws DataError for what is no recording, has another format or fails a checksum. */
  append(bytes: Uint8Array): Chunk[] {
    const all = this.rest.length === 0 ? bytes : joined(this.rest, bytes);
    this.taken += bytes.length;
    let place = 0;
    if (!this.started) {
      checkStart(all);
      if (all.length < preamble) {
        this.rest = all.slice();
        return [];
      }
      this.started = true;
      place = preamble;
    }
    const view = new DataView(all.buffer, all.byteOffset, all.byteLength);
    const chunks: Chunk[] = [];
    while (all.length - place >= before + after) {
      const size = view.getUint32(place + 4, true);
      const end = place + before + size;
      if (end + after > all.length) break;
      if (crc32(all.subarray(place, end)) !== view.getUint32(end, true))
        throw new DataError(
          `the recording is damaged: wrong checksum at byte ${this.taken - all.length + place}`,
        );
      chunks.push({
        name: text(all.subarray(place, place + 4)),
        content: all.subarray(place + before, end),
      });
      place = end + after;
    }
    this.whole = this.taken - (all.length - place);
    this.rest = all.slice(place);
    return chunks;
  }
}

function joined(a: Uint8Array, b: Uint8Array): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(a.length + b.length);
  all.set(a);
  all.set(b, a.length);
  return all;
}

function checkStart(bytes: Uint8Array): void {
  const start = text(bytes.subarray(0, magic.length));
  if (!magic.startsWith(start))
    throw new DataError("this is no recording: it does not start with the letters RETREPL");
  if (bytes.length < 12) return;
  const format = new DataView(bytes.buffer, bytes.byteOffset).getUint32(8, true);
  if (format !== 1)
    throw new DataError(`the recording has format ${format}, this page reads format 1`);
}
