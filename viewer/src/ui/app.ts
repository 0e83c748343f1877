import type { Run } from "../data/run";
import type { Preset } from "../scene/camera";
import type { Quantity } from "../scene/instant";
import { commands } from "./commands";
import { h } from "./dom";
import { listenToKeys } from "./keys";
import { Legend } from "./legend";
import { Panels } from "./panels";
import { Settings } from "./settings";
import { Store } from "./state";
import { applyTheme, initialTheme, keepTheme } from "./theme";
import { fittingSpeed, Transport } from "./transport";
import { View } from "./view";

/** The page below its heading: pictures, controls, plots and tables of one run or of several. */
export class App {
  readonly store: Store;
  readonly views: View[];
  private readonly transport: Transport;
  private readonly panels: Panels;
  /** Frames that there were when colours and extent were last looked for. */
  private surveyed = 0;

  constructor(
    private readonly runs: Run[],
    private readonly place: HTMLElement,
    private readonly failed: (error: unknown) => void,
  ) {
    const end = Math.max(...runs.map((run) => run.end));
    const theme = initialTheme();
    applyTheme(theme);
    this.store = new Store({
      time: runs[0]!.start,
      playing: false,
      speed: fittingSpeed(end - runs[0]!.start || 1),
      quantity: "tension",
      range: { low: 0, high: 1, logarithmic: false },
      follow: "nothing",
      knots: false,
      bullets: true,
      grid: false,
      theme,
      selection: undefined,
      selectedRun: 0,
    });
    this.views = runs.map((run, k) => new View(run, k, this.store, runs.length > 1, failed));
    this.transport = new Transport(runs, this.store);
    this.panels = new Panels(runs, this.store, (time) => this.seek(time), failed);
  }

  async start(): Promise<void> {
    for (const view of this.views) await view.prepare();
    this.build();
    this.store.set({
      range: this.usual("tension"),
      follow: this.views.some((view) => !view.whole) ? "net" : "nothing",
    });
    for (const view of this.views) {
      const { theme, quantity, range, time } = this.store.now;
      view.stage.colours(theme, quantity, range);
      view.stage.show(time);
      view.show();
      view.stage.resize(view.element.clientWidth, view.element.clientHeight);
    }
    this.look("oblique");
    this.linkCameras();
    this.panels.update();
    requestAnimationFrame((now) => this.frame(now));
  }

  /** After runs have grown; a slider at the end stays there. */
  async grow(): Promise<void> {
    const atEnd = this.store.now.time >= this.transport.shownEnd;
    this.transport.renew();
    this.panels.update();
    if (atEnd) this.store.set({ time: this.transport.end });
    const frames = this.runs.reduce((n, run) => n + run.recording.count, 0);
    if (frames < 1.3 * this.surveyed && this.runs.some((run) => run.live)) return;
    this.surveyed = frames;
    const { quantity, range } = this.store.now;
    const before = this.usual(quantity);
    for (const view of this.views) await view.survey();
    // A range that the reader has chosen stays.
    if (
      range.low === before.low &&
      range.high === before.high &&
      !range.logarithmic &&
      quantity === this.store.now.quantity
    )
      this.store.set({ range: this.usual(quantity) });
  }

  look(preset: Preset): void {
    const all = this.store.now.follow === "nothing";
    for (const { stage, whole } of this.views) stage.view(preset, all ? whole : undefined);
    // Pictures beside each other are seen from the same place, from where all of them fit.
    const far = (view: View): number => view.stage.controls.getDistance();
    const farthest = this.views.reduce((a, b) => (far(b) > far(a) ? b : a));
    for (const view of this.views) if (view !== farthest) this.copyCamera(farthest, view);
  }

  colourBy(quantity: Quantity): void {
    this.store.set({ quantity, range: this.usual(quantity) });
  }

  /** The range that serves all runs. */
  private usual(quantity: Quantity): { low: number; high: number; logarithmic: boolean } {
    const ranges = this.views.map((view) => view.ranges[quantity]);
    return {
      low: Math.min(...ranges.map((r) => r.low)),
      high: Math.max(...ranges.map((r) => r.high)),
      logarithmic: false,
    };
  }

  private build(): void {
    const header = this.runs[0]!.recording.header;
    const legend = new Legend(header, this.store, () => this.usual(this.store.now.quantity));
    const settings = new Settings(
      this.store,
      header.bodies.length > 0,
      (q) => this.colourBy(q),
      (p) => this.look(p),
    );
    const { help, open } = listenToKeys(commands(this.store, this.transport, this));
    const corner = h(
      "div",
      { class: "corner" },
      h(
        "button",
        {
          title: "Light or dark (t)",
          "aria-label": "Light or dark",
          click: () => this.turnTheme(),
        },
        "\u25d0",
      ),
      h("button", { title: "Keys (?)", "aria-label": "Keys", click: open }, "?"),
    );
    const stages = h(
      "div",
      { class: "stages", "data-count": this.views.length },
      ...this.views.map((view) => view.element),
      legend.element,
      corner,
    );
    this.place.replaceChildren(
      h(
        "section",
        { class: "viewer", "aria-label": "Replay" },
        h("div", { class: "left" }, stages, this.transport.element, settings.element),
        this.panels.plots,
      ),
      this.panels.report,
      help,
    );
  }

  private seek(time: number): void {
    const { start, end } = this.transport;
    this.store.set({ time: Math.max(start, Math.min(end, time)), playing: false });
  }

  turnTheme(): void {
    const theme = this.store.now.theme === "dark" ? "light" : "dark";
    applyTheme(theme);
    keepTheme(theme);
    this.store.set({ theme });
  }

  private copyCamera(from: View, to: View): void {
    to.stage.camera.position.copy(from.stage.camera.position);
    to.stage.controls.target.copy(from.stage.controls.target);
    to.stage.controls.update();
    to.stage.touch();
  }

  /** Turning one picture turns all. */
  private linkCameras(): void {
    let copying = false;
    for (const view of this.views)
      view.stage.controls.addEventListener("change", () => {
        if (copying) return;
        copying = true;
        for (const other of this.views) if (other !== view) this.copyCamera(view, other);
        copying = false;
      });
  }

  private frame(now: number): void {
    try {
      this.transport.tick(now);
      for (const view of this.views) view.stage.draw();
    } catch (error) {
      this.failed(error);
      return;
    }
    requestAnimationFrame((next) => this.frame(next));
  }
}
