import * as THREE from "three";
import type { Selection, Stage } from "./stage";

const reach = 12; // CSS pixels
const nodeReach = 7;

/** A world point on the canvas in CSS pixels; undefined behind the camera. */
export function project(
  stage: Stage,
  x: number,
  y: number,
  z: number,
): [number, number, number] | undefined {
  const point = new THREE.Vector3(x, y, z).applyMatrix4(stage.camera.matrixWorldInverse);
  const depth = -point.z;
  if (depth <= stage.camera.near) return undefined;
  point.applyMatrix4(stage.camera.projectionMatrix);
  const box = stage.canvas.getBoundingClientRect();
  return [(0.5 + 0.5 * point.x) * box.width, (0.5 - 0.5 * point.y) * box.height, depth];
}

/** Depth of the bodies' surfaces under a point of the canvas; infinite beside them. */
function bodyDepth(stage: Stage, x: number, y: number): number {
  const box = stage.canvas.getBoundingClientRect();
  const ray = new THREE.Raycaster();
  ray.setFromCamera(
    new THREE.Vector2((2 * x) / box.width - 1, 1 - (2 * y) / box.height),
    stage.camera,
  );
  const hit = ray.intersectObjects(stage.bodies.group.children, false)[0];
  return hit ? -hit.point.applyMatrix4(stage.camera.matrixWorldInverse).z : Infinity;
}

/**
 * The node or segment under a point of the canvas (CSS pixels from its corner): of those within
 * reach and not behind a body the one nearest to the point; a node where the point is close to it,
 * measured by its segment, or within reach of a corner mass.
 */
export function pick(stage: Stage, x: number, y: number): Selection {
  const { header, nodes } = stage.instant;
  const limit = bodyDepth(stage, x, y) * 1.002 + 4 * (header.radius[0] ?? 0);
  const places = new Float64Array(3 * header.nodes).fill(NaN);
  for (let k = 0; k < header.nodes; ++k) {
    const p = project(stage, nodes[4 * k]!, nodes[4 * k + 1]!, nodes[4 * k + 2]!);
    if (p) places.set(p, 3 * k);
  }
  let best = reach * reach;
  let chosen = -1;
  let along = 0;
  for (let s = 0; s < header.segments; ++s) {
    const [a, b] = [3 * header.ends[2 * s]!, 3 * header.ends[2 * s + 1]!];
    const [ax, ay] = [places[a]!, places[a + 1]!];
    const [dx, dy] = [places[b]! - ax, places[b + 1]! - ay];
    const square = dx * dx + dy * dy;
    const t = square > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
    const distance = (x - ax - t * dx) ** 2 + (y - ay - t * dy) ** 2;
    const depth = places[a + 2]! + t * (places[b + 2]! - places[a + 2]!);
    if (!(distance < best) || !(depth < limit)) continue;
    best = distance;
    chosen = s;
    along = t;
  }
  if (chosen < 0) return undefined;
  const node = header.ends[2 * chosen + (along < 0.5 ? 0 : 1)]!;
  const other = header.ends[2 * chosen + (along < 0.5 ? 1 : 0)]!;
  const gap = Math.hypot(x - places[3 * node]!, y - places[3 * node + 1]!);
  const length = Math.hypot(
    places[3 * node]! - places[3 * other]!,
    places[3 * node + 1]! - places[3 * other + 1]!,
  );
  const drawn = header.bullets.some((bullet) => bullet.node === node);
  if (gap < (drawn ? nodeReach : Math.min(nodeReach, 0.22 * length)))
    return { kind: "node", index: node };
  return { kind: "segment", index: chosen };
}
