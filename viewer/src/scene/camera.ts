import * as THREE from "three";

/** Where a preset looks from, towards the centre; z is up. */
export const presets = {
  oblique: [0.62, -0.7, 0.38],
  side: [0, -1, 0],
  end: [1, 0, 0],
  top: [0, -0.0001, 1],
} as const;
export type Preset = keyof typeof presets;

/** The box around points of many instants. */
export class Extent {
  private readonly box = new THREE.Box3();
  private readonly point = new THREE.Vector3();

  /** Every `stride` numbers start with x, y, z. */
  add(numbers: ArrayLike<number>, stride: number, count: number): void {
    for (let k = 0; k < count; ++k)
      this.box.expandByPoint(
        this.point.set(numbers[stride * k]!, numbers[stride * k + 1]!, numbers[stride * k + 2]!),
      );
  }

  addBall(x: number, y: number, z: number, radius: number): void {
    this.box.expandByPoint(this.point.set(x - radius, y - radius, z - radius));
    this.box.expandByPoint(this.point.set(x + radius, y + radius, z + radius));
  }

  /** The longest way through the box, m. */
  get size(): number {
    return this.box.isEmpty() ? 0 : this.box.getSize(this.point).length();
  }

  get centre(): THREE.Vector3 {
    return this.box.isEmpty() ? new THREE.Vector3() : this.box.getCenter(new THREE.Vector3());
  }

  corners(): THREE.Vector3[] {
    const { min, max } = this.box;
    return Array.from(
      { length: 8 },
      (_, k) =>
        new THREE.Vector3(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z),
    );
  }
}

const margin = 1.08;

/** Sets the camera so that the box just fits the picture. */
export function lookAt(
  camera: THREE.PerspectiveCamera,
  target: THREE.Vector3,
  extent: Extent,
  preset: Preset,
): void {
  const up = Math.tan((camera.fov * Math.PI) / 360) / margin;
  target.copy(extent.centre);
  const back = new THREE.Vector3(...presets[preset]).normalize();
  camera.position.copy(target).add(back);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  const across = new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
  const upward = new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, 1);
  let distance = 1e-3;
  for (const corner of extent.size > 0 ? extent.corners() : []) {
    const from = corner.sub(target);
    const wide = Math.max(
      Math.abs(from.dot(upward)) / up,
      Math.abs(from.dot(across)) / (up * camera.aspect),
    );
    distance = Math.max(distance, wide + from.dot(back));
  }
  camera.position.copy(target).addScaledVector(back, distance);
  camera.lookAt(target);
}
