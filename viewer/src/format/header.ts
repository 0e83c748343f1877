import { DataError } from "./errors";
import { inflate } from "./inflate";
import { Minifloat } from "./minifloat";

export interface Channel {
  name: string;
  unit: string;
  on: "segment" | "node";
  scale: Minifloat;
}
export interface Bullet {
  node: number;
  mass: number;
  radius: number;
}
export interface Body {
  name: string;
  vertices: Float32Array;
  triangles: Uint32Array;
}
export interface NamedPhase {
  name: string;
  kind: string;
}

/** What a recording says once, before its frames. */
export interface Header {
  title: string;
  program: string;
  nodes: number;
  segments: number;
  size: number;
  quantum: number;
  error: number;
  /** Frames from one key frame to the next. */
  key_interval: number;
  channels: Channel[];
  corners: number[];
  bullets: Bullet[];
  phases: NamedPhase[];
  bodies: Body[];
  /** Two nodes of each segment. */
  ends: Uint32Array;
  restLength: Float64Array;
  radius: Float32Array;
  stiffness: Float64Array;
  mass: Float64Array;
  knots: Uint32Array;
}

interface ArrayEntry {
  name: string;
  type: "u32" | "f32" | "f64";
  shape: number[];
}
type Numbers = Uint32Array | Float32Array | Float64Array;

function numbers(type: string, bytes: Uint8Array): Numbers {
  const copy = bytes.slice().buffer;
  if (type === "u32") return new Uint32Array(copy);
  if (type === "f32") return new Float32Array(copy);
  if (type === "f64") return new Float64Array(copy);
  throw new DataError(`the recording has an array of unknown type ${type}`);
}

function readArrays(list: ArrayEntry[], bytes: Uint8Array): Map<string, Numbers> {
  const arrays = new Map<string, Numbers>();
  let place = 0;
  for (const { name, type, shape } of list) {
    const size = shape.reduce((a, b) => a * b, 1) * (type === "f64" ? 8 : 4);
    if (place + size > bytes.length)
      throw new DataError(`the recording is damaged: its array ${name} is cut`);
    arrays.set(name, numbers(type, bytes.subarray(place, place + size)));
    place += size;
  }
  return arrays;
}

/** Reads the content of a HEAD chunk. Throws DataError. */
export async function readHeader(content: Uint8Array): Promise<Header> {
  const view = new DataView(content.buffer, content.byteOffset, content.byteLength);
  const size = content.length < 4 ? 0 : view.getUint32(0, true);
  let head;
  try {
    head = JSON.parse(new TextDecoder().decode(content.subarray(4, 4 + size)));
  } catch {
    throw new DataError("the recording is damaged: its header cannot be read");
  }
  const arrays = readArrays(
    head.arrays ?? [],
    await inflate(content.subarray(4 + size), "deflate"),
  );
  const take = <T extends Numbers>(name: string): T => {
    const array = arrays.get(name);
    if (!array) throw new DataError(`the recording is damaged: its header lacks ${name}`);
    return array as T;
  };
  const materials = head.materials as { radius: number; axial_stiffness: number }[];
  const material = take<Uint32Array>("material");
  return {
    ...head,
    channels: head.channels.map((c: { quantum: number; steps: number }) => ({
      ...c,
      scale: new Minifloat(c.quantum, c.steps),
    })),
    ends: take("segments"),
    restLength: take("rest_length"),
    radius: Float32Array.from(material, (m) => materials[m]!.radius),
    stiffness: Float64Array.from(material, (m) => materials[m]!.axial_stiffness),
    mass: take("mass"),
    knots: take("knots"),
    bodies: head.bodies.map((body: { name: string }, k: number) => ({
      name: body.name,
      vertices: take(`body${k}.vertices`),
      triangles: take(`body${k}.triangles`),
    })),
  };
}
