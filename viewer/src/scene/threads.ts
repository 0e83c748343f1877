import * as THREE from "three";
import type { Header } from "../format/header";
import { type Range, scaleBytes, scaleSteps, type Theme } from "./colour";
import type { Instant } from "./instant";
import { ballFragment, ballVertex, threadFragment, threadVertex } from "./shaders";

/** Uniforms that threads and balls share. */
export interface Shared {
  nodes: THREE.IUniform<THREE.DataTexture>;
  texels: THREE.IUniform<number>;
  view: THREE.IUniform<THREE.Matrix4>;
  projection: THREE.IUniform<THREE.Matrix4>;
  pixel: THREE.IUniform<number>;
  range: THREE.IUniform<THREE.Vector4>;
  [name: string]: THREE.IUniform;
}

export function sharedUniforms(instant: Instant): Shared {
  const rows = instant.nodes.length / (4 * instant.texels);
  const nodes = new THREE.DataTexture(
    instant.nodes,
    instant.texels,
    rows,
    THREE.RGBAFormat,
    THREE.FloatType,
  );
  return {
    nodes: { value: nodes },
    texels: { value: instant.texels },
    view: { value: new THREE.Matrix4() },
    projection: { value: new THREE.Matrix4() },
    pixel: { value: 0.001 },
    range: { value: new THREE.Vector4(0, 1, 0, 0) },
  };
}

function quads(along: boolean, count: number): THREE.InstancedBufferGeometry {
  const geometry = new THREE.InstancedBufferGeometry();
  const low = along ? 0 : -1;
  const corners = new Float32Array([-1, low, 1, low, 1, 1, -1, 1]);
  geometry.setAttribute("corner", new THREE.BufferAttribute(corners, 2));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  geometry.instanceCount = count;
  return geometry;
}

function mesh(
  geometry: THREE.BufferGeometry,
  vertex: string,
  fragment: string,
  uniforms: Shared,
): THREE.Mesh {
  const material = new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader: vertex,
    fragmentShader: fragment,
    uniforms,
    side: THREE.DoubleSide,
  });
  const result = new THREE.Mesh(geometry, material);
  // What is seen is decided by the texture, which the renderer's own test does not know.
  result.frustumCulled = false;
  return result;
}

/** All segments of a net in one draw call. */
export class Threads {
  readonly mesh: THREE.Mesh;
  private readonly values: THREE.InstancedBufferAttribute;
  private readonly scale: THREE.DataTexture;
  private readonly uniforms: Shared;

  constructor(header: Header, instant: Instant, shared: Shared) {
    const geometry = quads(true, header.segments);
    const ends = new THREE.InstancedBufferAttribute(Float32Array.from(header.ends), 2);
    this.values = new THREE.InstancedBufferAttribute(instant.values, 1);
    this.values.setUsage(THREE.DynamicDrawUsage);
    geometry.setAttribute("ends", ends);
    geometry.setAttribute("radius", new THREE.InstancedBufferAttribute(header.radius, 1));
    geometry.setAttribute("value", this.values);
    this.scale = new THREE.DataTexture(new Uint8Array(4 * scaleSteps), scaleSteps, 1);
    this.uniforms = {
      ...shared,
      scale: { value: this.scale },
      least: { value: 0.6 },
      onNodes: { value: false },
      chosen: { value: -1 },
      mark: { value: new THREE.Vector3(1, 0, 0) },
    };
    this.mesh = mesh(geometry, threadVertex, threadFragment, this.uniforms);
  }

  /** After the instant's arrays were filled. */
  update(onNodes: boolean): void {
    this.uniforms.nodes.value.needsUpdate = true;
    this.values.needsUpdate = true;
    this.uniforms["onNodes"]!.value = onNodes;
  }

  colours(theme: Theme, contact: boolean, range: Range): void {
    this.scale.image.data!.set(scaleBytes(theme, contact));
    this.scale.needsUpdate = true;
    const { low, high, logarithmic } = range;
    const span = logarithmic ? Math.log(high / low) : high - low;
    this.uniforms.range.value.set(low, span > 0 ? 1 / span : 1e30, logarithmic ? 1 : 0, 0);
    (this.uniforms["mark"]!.value as THREE.Vector3).set(
      ...((theme === "dark" ? [1, 0.35, 0.3] : [0.85, 0.1, 0.1]) as [number, number, number]),
    );
  }

  choose(segment: number): void {
    this.uniforms["chosen"]!.value = segment;
  }

  set least(pixels: number) {
    this.uniforms["least"]!.value = pixels;
  }
}

/** Balls at nodes: corner masses, knots, or the node that was clicked. */
export class Balls {
  readonly mesh: THREE.Mesh;
  private readonly index: THREE.InstancedBufferAttribute;
  private readonly tint = new THREE.Vector3();

  constructor(nodes: ArrayLike<number>, radius: ArrayLike<number>, least: number, shared: Shared) {
    const geometry = quads(false, nodes.length);
    this.index = new THREE.InstancedBufferAttribute(Float32Array.from(nodes), 1);
    geometry.setAttribute("index", this.index);
    geometry.setAttribute(
      "radius",
      new THREE.InstancedBufferAttribute(Float32Array.from(radius), 1),
    );
    const uniforms = { ...shared, least: { value: least }, tint: { value: this.tint } };
    this.mesh = mesh(geometry, ballVertex, ballFragment, uniforms);
  }

  colour(r: number, g: number, b: number): void {
    this.tint.set(r, g, b);
  }

  /** Moves the first ball to another node. */
  place(node: number): void {
    this.index.setX(0, node);
    this.index.needsUpdate = true;
  }
}
