import * as THREE from "three";

/** Where a preset looks from, towards the centre; z is up. */
export const presets = {
  oblique: [0.62, -0.7, 0.38],
  side: [0, -1, 0],
  end: [1, 0, 0],
  top: [0, -0.0001, 1],
} as const;
export type Preset = keyof typeof presets;

export interface Ball {
  centre: THREE.Vector3;
  radius: number;
}

/** The ball around points of many instants, given as boxes. */
export class Extent {
  private readonly box = new THREE.Box3();
  private readonly point = new THREE.Vector3();

  /** Every `stride` numbers start with x, y, z. */
  add(numbers: ArrayLike<number>, stride: number, count: number): void {
    for (let k = 0; k < count; ++k)
      this.box.expandByPoint(this.point.set(numbers[stride * k]!, numbers[stride * k + 1]!, numbers[stride * k + 2]!));
  }

  addBall(x: number, y: number, z: number, radius: number): void {
    this.box.expandByPoint(this.point.set(x - radius, y - radius, z - radius));
    this.box.expandByPoint(this.point.set(x + radius, y + radius, z + radius));
  }

  ball(): Ball {
    const centre = this.box.getCenter(new THREE.Vector3());
    const radius = this.box.isEmpty() ? 1 : 0.5 * this.box.getSize(this.point).length();
    return { centre, radius: Math.max(radius, 1e-3) };
  }
}

/** Sets the camera so that the ball fills the picture. */
export function lookAt(camera: THREE.PerspectiveCamera, target: THREE.Vector3, ball: Ball, preset: Preset): void {
  const vertical = (camera.fov * Math.PI) / 360;
  const horizontal = Math.atan(Math.tan(vertical) * camera.aspect);
  const distance = (0.92 * ball.radius) / Math.sin(Math.min(vertical, horizontal));
  target.copy(ball.centre);
  camera.position.copy(ball.centre).addScaledVector(new THREE.Vector3(...presets[preset]).normalize(), distance);
  camera.lookAt(target);
}
