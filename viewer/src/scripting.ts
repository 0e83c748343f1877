import type { Quantity } from "./scene/instant";
import { pick, project } from "./scene/picking";
import { placeInRange, scaleColour } from "./scene/colour";
import type { App } from "./ui/app";

/** What scripts and tests can ask of the page: window.retiarius. Runs are numbered from 0. */
export interface Scripting {
  app: App;
  /** Moves the slider; resolves when every picture shows that instant. */
  seek(time: number): Promise<void>;
  times(run?: number): number[];
  /** Position of a node as drawn, m. */
  node(node: number, run?: number): [number, number, number];
  /** Where a node is on its canvas, CSS pixels. */
  onScreen(node: number, run?: number): [number, number] | undefined;
  ends(segment: number, run?: number): [number, number];
  /** Value of a segment in the colours shown, and the colour that the legend gives it, 0 to 255. */
  segment(segment: number, run?: number): { value: number; colour: number[] };
  pick(x: number, y: number, run?: number): { kind: string; index: number } | undefined;
  colourBy(quantity: Quantity): void;
}

export function exposeForScripts(app: App): void {
  const view = (run = 0) => app.views[run]!;
  const scripting: Scripting = {
    app,
    async seek(time) {
      app.store.set({ time, playing: false });
      const shown = (): boolean =>
        app.views.every((v) => Math.abs(v.stage.instant.time - Math.min(time, v.run.end)) < 1e-9);
      while (!shown()) await new Promise((resolve) => setTimeout(resolve, 5));
      for (const v of app.views) v.stage.draw();
    },
    times: (run) => [...view(run).run.recording.times],
    node(node, run) {
      const { nodes } = view(run).stage.instant;
      return [nodes[4 * node]!, nodes[4 * node + 1]!, nodes[4 * node + 2]!];
    },
    onScreen(node, run) {
      const place = project(view(run).stage, ...this.node(node, run));
      return place && [place[0], place[1]];
    },
    ends(segment, run) {
      const { ends } = view(run).run.recording.header;
      return [ends[2 * segment]!, ends[2 * segment + 1]!];
    },
    segment(segment, run) {
      const value = view(run).stage.instant.values[segment]!;
      const { range, theme } = app.store.now;
      return {
        value,
        colour: scaleColour(placeInRange(value, range), theme).map((c) => Math.round(255 * c)),
      };
    },
    pick: (x, y, run) => pick(view(run).stage, x, y),
    colourBy: (quantity) => app.colourBy(quantity),
  };
  (window as unknown as { retiarius: Scripting }).retiarius = scripting;
}
