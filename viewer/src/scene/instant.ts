import type { Frame } from "../format/frames";
import type { Header } from "../format/header";
import type { Minifloat } from "../format/minifloat";

/** What the net can be coloured by. */
export type Quantity = "tension" | "strain" | "curvature" | "speed" | "contact";
export const quantities: readonly Quantity[] = [
  "tension",
  "strain",
  "curvature",
  "speed",
  "contact",
];
const channelOf = { tension: 0, strain: 1, curvature: 2, speed: 3 } as const;

export function isOnNodes(quantity: Quantity): boolean {
  return quantity !== "tension" && quantity !== "strain";
}

/** The recorded value of one segment or node. */
export function valueAt(header: Header, frame: Frame, quantity: Quantity, index: number): number {
  if (quantity === "contact") return frame.touch[index]!;
  const channel = channelOf[quantity];
  return header.channels[channel]!.scale.value(frame.channels[channel]![index]!);
}

export function positionAt(header: Header, frame: Frame, node: number): [number, number, number] {
  const q = header.quantum;
  return [frame.x[node]! * q, frame.y[node]! * q, frame.z[node]! * q];
}

/**
 * What is drawn at one instant, between two frames if need be. Its arrays are made once and filled
 * again for each picture.
 */
export class Instant {
  time = 0;
  phase = 0;
  /** x, y, z (m) and the value of each node. */
  readonly nodes: Float32Array<ArrayBuffer>;
  /** Value of each segment. */
  readonly values: Float32Array;
  /** Seven numbers a body, as in Frame. */
  readonly poses: Float32Array;
  readonly centre = new Float64Array(3);

  constructor(
    readonly header: Header,
    readonly texels: number,
  ) {
    this.nodes = new Float32Array(4 * texels * Math.max(1, Math.ceil(header.nodes / texels)));
    this.values = new Float32Array(header.segments);
    this.poses = new Float32Array(7 * header.bodies.length);
  }

  fill(a: Frame, b: Frame, fraction: number, quantity: Quantity): void {
    this.time = a.time + fraction * (b.time - a.time);
    this.phase = a.phase;
    this.fillPositions(a, b, fraction);
    if (isOnNodes(quantity)) this.fillNodes(a, b, fraction, quantity);
    else this.fillSegments(a, b, fraction, quantity);
    for (let k = 0; k < this.header.bodies.length; ++k) this.fillPose(a, b, fraction, 7 * k);
  }

  private fillPositions(a: Frame, b: Frame, f: number): void {
    const { quantum, nodes } = this.header;
    let [sx, sy, sz] = [0, 0, 0];
    for (let k = 0; k < nodes; ++k) {
      const x = (a.x[k]! + f * (b.x[k]! - a.x[k]!)) * quantum;
      const y = (a.y[k]! + f * (b.y[k]! - a.y[k]!)) * quantum;
      const z = (a.z[k]! + f * (b.z[k]! - a.z[k]!)) * quantum;
      this.nodes[4 * k] = x;
      this.nodes[4 * k + 1] = y;
      this.nodes[4 * k + 2] = z;
      sx += x;
      sy += y;
      sz += z;
    }
    this.centre[0] = sx / nodes;
    this.centre[1] = sy / nodes;
    this.centre[2] = sz / nodes;
  }

  private fillNodes(a: Frame, b: Frame, f: number, quantity: Quantity): void {
    const { nodes } = this.header;
    if (quantity === "contact") {
      for (let k = 0; k < nodes; ++k) this.nodes[4 * k + 3] = a.touch[k]!;
      return;
    }
    const channel = channelOf[quantity];
    const scale = this.header.channels[channel]!.scale;
    const [p, q] = [a.channels[channel]!, b.channels[channel]!];
    for (let k = 0; k < nodes; ++k) this.nodes[4 * k + 3] = between(scale, p[k]!, q[k]!, f);
  }

  private fillSegments(a: Frame, b: Frame, f: number, quantity: Quantity): void {
    const channel = quantity === "strain" ? 1 : 0;
    const scale = this.header.channels[channel]!.scale;
    const [p, q] = [a.channels[channel]!, b.channels[channel]!];
    for (let k = 0; k < this.values.length; ++k) this.values[k] = between(scale, p[k]!, q[k]!, f);
  }

  private fillPose(a: Frame, b: Frame, f: number, at: number): void {
    let dot = 0;
    for (let k = 3; k < 7; ++k) dot += a.poses[at + k]! * b.poses[at + k]!;
    const sign = dot < 0 ? -1 : 1;
    let norm = 0;
    for (let k = 0; k < 7; ++k) {
      const other = b.poses[at + k]! * (k < 3 ? 1 : sign);
      const value = a.poses[at + k]! + f * (other - a.poses[at + k]!);
      this.poses[at + k] = value;
      if (k >= 3) norm += value * value;
    }
    for (let k = 3; k < 7; ++k) this.poses[at + k]! /= Math.sqrt(norm);
  }
}

function between(scale: Minifloat, a: number, b: number, f: number): number {
  const x = scale.value(a);
  return f === 0 || a === b ? x : x + f * (scale.value(b) - x);
}
