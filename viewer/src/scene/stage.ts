import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { placeOf } from "../data/timeline";
import type { Recording } from "../format/recording";
import { Bodies } from "./bodies";
import { Extent, lookAt, type Preset } from "./camera";
import type { Range, Theme } from "./colour";
import { Instant, isOnNodes, type Quantity } from "./instant";
import { Balls, type Shared, sharedUniforms, Threads } from "./threads";

export type Follow = "nothing" | "net" | "target";
export type Selection = { kind: "segment" | "node"; index: number } | undefined;

const texels = 1024;

/** One run's picture: a canvas, what is drawn in it, and the camera. */
export class Stage {
  readonly camera = new THREE.PerspectiveCamera(38, 1, 0.01, 1000);
  readonly controls: OrbitControls;
  readonly instant: Instant;
  readonly bodies: Bodies;
  follow: Follow = "nothing";
  /** Called after each picture. */
  drawn: () => void = () => {};
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly shared: Shared;
  private readonly threads: Threads;
  private readonly bullets: Balls;
  private readonly knots: Balls;
  private readonly chosen: Balls;
  private readonly sun = new THREE.DirectionalLight("#ffffff", 2.2);
  private readonly sky = new THREE.HemisphereLight("#ffffff", "#7c8794", 1.3);
  private readonly grid: THREE.GridHelper;
  private readonly followed = new THREE.Vector3();
  private pursuing = false;
  private readonly spare = new THREE.Vector3();
  private quantity: Quantity = "tension";
  private time = 0;
  private wanted = -1;
  private dirty = true;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly recording: Recording,
    private readonly failed: (error: unknown) => void,
  ) {
    const { header } = recording;
    this.renderer = new THREE.WebGLRenderer({
      canvas,
      antialias: true,
      alpha: true,
      preserveDrawingBuffer: true,
    });
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", () => this.touch());
    this.instant = new Instant(header, texels);
    this.shared = sharedUniforms(this.instant);
    this.threads = new Threads(header, this.instant, this.shared);
    const nodes = header.bullets.map((b) => b.node);
    this.bullets = new Balls(
      nodes,
      header.bullets.map((b) => b.radius),
      3.2,
      this.shared,
    );
    const thick = header.radius.reduce((a, b) => Math.max(a, b), 0);
    this.knots = new Balls(
      header.knots,
      new Float32Array(header.knots.length).fill(1.7 * thick),
      1.5,
      this.shared,
    );
    this.chosen = new Balls([0], [2 * thick], 5, this.shared);
    this.bodies = new Bodies(header);
    this.grid = new THREE.GridHelper(4 * header.size, 40);
    this.grid.rotation.x = Math.PI / 2;
    this.knots.mesh.visible = this.chosen.mesh.visible = this.grid.visible = false;
    this.bullets.mesh.visible = nodes.length > 0;
    this.sun.position.set(-0.6, -1, 1.6);
    this.scene.add(this.threads.mesh, this.bullets.mesh, this.knots.mesh, this.chosen.mesh);
    this.scene.add(this.bodies.group, this.sky, this.sun, this.sun.target, this.grid);
  }

  get canvas(): HTMLCanvasElement {
    return this.renderer.domElement;
  }
  /** Draw calls of the last picture, for measuring. */
  get calls(): number {
    return this.renderer.info.render.calls;
  }

  /** Asks for a new picture. */
  touch(): void {
    this.dirty = true;
  }

  resize(width: number, height: number): void {
    if (width < 1 || height < 1) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.touch();
  }

  colours(theme: Theme, quantity: Quantity, range: Range): void {
    this.quantity = quantity;
    this.threads.colours(theme, quantity === "contact", range);
    this.bodies.colours(theme);
    const ink = theme === "dark" ? [0.9, 0.92, 0.95] : [0.2, 0.24, 0.3];
    this.bullets.colour(...(ink as [number, number, number]));
    this.knots.colour(
      ...((theme === "dark" ? [0.75, 0.78, 0.83] : [0.36, 0.41, 0.48]) as [number, number, number]),
    );
    this.chosen.colour(
      ...((theme === "dark" ? [1, 0.35, 0.3] : [0.85, 0.1, 0.1]) as [number, number, number]),
    );
    (this.grid.material as THREE.Material).opacity = 0.22;
    (this.grid.material as THREE.Material).transparent = true;
    this.wanted = -1;
    this.show(this.time);
  }

  parts(knots: boolean, bullets: boolean, grid: boolean): void {
    this.knots.mesh.visible = knots;
    this.bullets.mesh.visible = bullets && this.recording.header.bullets.length > 0;
    this.grid.visible = grid;
    this.touch();
  }

  select(selection: Selection): void {
    this.threads.choose(selection?.kind === "segment" ? selection.index : -1);
    this.chosen.mesh.visible = selection?.kind === "node";
    if (selection?.kind === "node") this.chosen.place(selection.index);
    this.touch();
  }

  /** Shows an instant, as soon as its frames are decoded. */
  show(time: number): void {
    this.time = time;
    const { frame, fraction } = placeOf(this.recording.times, time);
    const next = fraction > 0 ? frame + 1 : frame;
    const a = this.recording.ready(frame);
    const b = this.recording.ready(next);
    if (a && b) {
      this.instant.fill(a, b, fraction, this.quantity);
      this.threads.update(isOnNodes(this.quantity));
      this.bodies.pose(this.instant.poses);
      this.pursue();
      this.touch();
      this.prefetch(next);
      return;
    }
    void this.fetch(frame, next);
  }

  private async fetch(frame: number, next: number): Promise<void> {
    if (this.wanted === next) return;
    this.wanted = next;
    try {
      await this.recording.load(frame);
      await this.recording.load(next);
    } catch (error) {
      this.failed(error);
      return;
    }
    this.wanted = -1;
    this.show(this.time);
  }

  /** Decodes a few frames ahead of the picture, so that playing does not wait at key frames. */
  private prefetch(frame: number): void {
    const ahead = Math.min(frame + 12, this.recording.count - 1);
    if (!this.recording.ready(ahead)) this.recording.load(ahead).catch(this.failed);
  }

  /** Moves the camera along with what it follows. */
  private pursue(): void {
    const step = this.pointToFollow(this.spare);
    const before = this.pursuing;
    this.pursuing = step !== undefined;
    if (!step) return;
    step.sub(this.followed);
    this.followed.add(step);
    if (!before) return;
    this.camera.position.add(step);
    this.controls.target.add(step);
  }

  private pointToFollow(point: THREE.Vector3): THREE.Vector3 | undefined {
    if (this.follow === "net") return point.fromArray(this.instant.centre);
    if (this.follow === "target" && this.instant.poses.length >= 7)
      return point.fromArray(this.instant.poses, 0);
    return undefined;
  }

  setFollow(follow: Follow): void {
    this.follow = follow;
    this.pursuing = this.pointToFollow(this.followed) !== undefined;
  }

  /** Turns and places the camera so that net and bodies fill the picture as they are now. */
  view(preset: Preset, whole?: Extent): void {
    const extent = whole ?? this.present();
    lookAt(this.camera, this.controls.target, extent, preset);
    this.controls.update();
    this.touch();
  }

  present(): Extent {
    const extent = new Extent();
    extent.add(this.instant.nodes, 4, this.recording.header.nodes);
    this.addBodies(extent, this.instant.poses);
    return extent;
  }

  addBodies(extent: Extent, poses: Float32Array): void {
    const net = this.recording.header.size;
    this.bodies.group.children.forEach((mesh, k) => {
      const ball = (mesh as THREE.Mesh).geometry.boundingSphere ?? new THREE.Sphere();
      // A ground plane is drawn larger than what happens on it.
      extent.addBall(
        poses[7 * k]!,
        poses[7 * k + 1]!,
        poses[7 * k + 2]!,
        Math.min(ball.radius, 0.5 * net),
      );
    });
  }

  /** Draws if anything has changed. */
  draw(): void {
    if (!this.dirty) return;
    this.dirty = false;
    const far = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = Math.max(1e-4, 0.004 * far);
    this.camera.far = 200 * far + 10 * this.recording.header.size;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    this.shared.view.value.copy(this.camera.matrixWorldInverse);
    this.shared.projection.value.copy(this.camera.projectionMatrix);
    const height = this.renderer.domElement.height || 1;
    this.shared.pixel.value =
      (2 * Math.tan((this.camera.fov * Math.PI) / 360) * this.renderer.getPixelRatio()) / height;
    this.sun.position.copy(this.camera.position).add(this.spare.set(-0.4 * far, 0, 0.9 * far));
    this.sun.target.position.copy(this.controls.target);
    this.renderer.render(this.scene, this.camera);
    this.drawn();
  }
}
