import * as THREE from "three";
import { mergeVertices, toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Header } from "../format/header";
import type { Theme } from "./colour";

/** The bodies' surfaces, lit, with their sharp edges drawn thinly. */
export class Bodies {
  readonly group = new THREE.Group();
  private readonly surface = new THREE.MeshStandardMaterial({
    roughness: 0.62,
    metalness: 0.08,
    side: THREE.DoubleSide,
  });
  private readonly edge = new THREE.LineBasicMaterial({ transparent: true });

  constructor(header: Header) {
    for (const body of header.bodies) {
      let geometry: THREE.BufferGeometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(body.vertices, 3));
      geometry.setIndex(new THREE.BufferAttribute(body.triangles, 1));
      geometry = toCreasedNormals(mergeVertices(geometry), 0.6);
      const mesh = new THREE.Mesh(geometry, this.surface);
      mesh.add(new THREE.LineSegments(new THREE.EdgesGeometry(geometry, 25), this.edge));
      this.group.add(mesh);
    }
  }

  pose(poses: Float32Array): void {
    this.group.children.forEach((mesh, k) => {
      mesh.position.fromArray(poses, 7 * k);
      mesh.quaternion.fromArray(poses, 7 * k + 3);
    });
  }

  colours(theme: Theme): void {
    this.surface.color.set(theme === "dark" ? "#a9b5c4" : "#c3cbd5");
    this.edge.color.set(theme === "dark" ? "#e9eef5" : "#4d5867");
    this.edge.opacity = theme === "dark" ? 0.28 : 0.55;
  }
}
