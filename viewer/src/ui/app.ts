import type { Run } from "../data/run";
import type { Preset } from "../scene/camera";
import { presets } from "../scene/camera";
import { quantities, type Quantity } from "../scene/instant";
import { Chart, type ChartContent, type Line } from "./chart";
import { h } from "./dom";
import { listenToKeys } from "./keys";
import { Legend } from "./legend";
import { type Plot, plotsOf } from "./plots";
import { Probe } from "./probe";
import { Settings } from "./settings";
import { Store } from "./state";
import { tables } from "./tables";
import { applyTheme, initialTheme, keepTheme } from "./theme";
import { fittingSpeed, Transport } from "./transport";
import { View } from "./view";

/** The page below its heading: pictures, controls, plots and tables of one run or of several. */
export class App {
  readonly store: Store;
  readonly views: View[];
  private readonly transport: Transport;
  private readonly probe: Probe;
  private readonly charts = h("div", { class: "charts" });
  private readonly report = h("div", {});
  private all: Chart[] = [];
  /** How many runs have told their end. */
  private told = -1;
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
    this.probe = new Probe(
      (time) => this.seek(time),
      () => this.store.set({ selection: undefined }),
      failed,
    );
  }

  async start(): Promise<void> {
    for (const view of this.views) await view.prepare();
    this.build();
    this.store.listen((state, changed) => {
      if (changed.has("time")) this.chartsAt(state.time);
      if (changed.has("selection")) void this.showProbe();
      if (changed.has("theme")) this.recolour();
    });
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
    this.showRuns();
    requestAnimationFrame((now) => this.frame(now));
  }

  /** After runs have grown; a slider at the end stays there. */
  async grow(): Promise<void> {
    const atEnd = this.store.now.time >= this.transport.shownEnd;
    this.transport.renew();
    this.showRuns();
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
    const [first] = this.views;
    if (this.store.now.follow === "nothing")
      for (const view of this.views) view.stage.view(preset, view.whole);
    else for (const view of this.views) view.stage.view(preset);
    if (this.views.length > 1)
      for (const view of this.views.slice(1)) this.copyCamera(first!, view);
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
    const { help, open } = this.keys();
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
        h("aside", { class: "right", "aria-label": "Plots" }, this.probe.element, this.charts),
      ),
      this.report,
      help,
    );
  }

  private keys(): { help: HTMLDialogElement; open: () => void } {
    const step = (n: number) => () => this.transport.step(n);
    const speed = (factor: number) => () =>
      this.store.set({ speed: fittingSpeed(12 * this.store.now.speed * factor) });
    return listenToKeys([
      { keys: [" "], shown: "space", text: "play or pause", run: () => this.transport.toggle() },
      { keys: [",", "ArrowLeft"], shown: ",  \u2190", text: "one frame back", run: step(-1) },
      { keys: [".", "ArrowRight"], shown: ".  \u2192", text: "one frame on", run: step(1) },
      {
        keys: ["Home"],
        shown: "Home",
        text: "to the start",
        run: () => this.store.set({ time: this.transport.start }),
      },
      {
        keys: ["End"],
        shown: "End",
        text: "to the end",
        run: () => this.store.set({ time: this.transport.end }),
      },
      { keys: ["["], shown: "[", text: "slower", run: speed(0.5) },
      { keys: ["]"], shown: "]", text: "faster", run: speed(2) },
      ...Object.keys(presets).map((preset, k) => ({
        keys: [String(k + 1)],
        shown: String(k + 1),
        text: `view: ${preset}`,
        run: () => this.look(preset as Preset),
      })),
      {
        keys: ["c"],
        shown: "c",
        text: "colour by the next quantity",
        run: () =>
          this.colourBy(
            quantities[(quantities.indexOf(this.store.now.quantity) + 1) % quantities.length]!,
          ),
      },
      {
        keys: ["f"],
        shown: "f",
        text: "follow the net, or nothing",
        run: () => this.store.set({ follow: this.store.now.follow === "net" ? "nothing" : "net" }),
      },
      {
        keys: ["k"],
        shown: "k",
        text: "knots on or off",
        run: () => this.store.set({ knots: !this.store.now.knots }),
      },
      {
        keys: ["g"],
        shown: "g",
        text: "grid on or off",
        run: () => this.store.set({ grid: !this.store.now.grid }),
      },
      { keys: ["t"], shown: "t", text: "light or dark", run: () => this.turnTheme() },
      {
        keys: ["Escape"],
        shown: "Esc",
        text: "close the history of what was clicked",
        run: () => this.store.set({ selection: undefined }),
      },
    ]);
  }

  private seek(time: number): void {
    const { start, end } = this.transport;
    this.store.set({ time: Math.max(start, Math.min(end, time)), playing: false });
  }

  private turnTheme(): void {
    const theme = this.store.now.theme === "dark" ? "light" : "dark";
    applyTheme(theme);
    keepTheme(theme);
    this.store.set({ theme });
  }

  /** Plots and tables of what the runs say now. */
  private showRuns(): void {
    const histories = this.runs.map((run) => run.history);
    const contents = plotsOf(histories).map((plot) => this.chartContent(plot));
    const kept =
      contents.length === this.all.length &&
      contents.every((content, k) => this.all[k]!.update(content));
    if (!kept) {
      this.all = contents.map((content) => new Chart(content, (time) => this.seek(time)));
      this.charts.replaceChildren(...this.all.map((chart) => chart.element));
    }
    const told = this.runs.filter((run) => run.summary).length;
    if (told !== this.told) this.report.replaceChildren(tables(this.runs));
    this.told = told;
    this.chartsAt(this.store.now.time);
  }

  private chartContent(plot: Plot): ChartContent {
    const several = this.runs.length > 1;
    const lines = this.runs.flatMap((run, r) =>
      plot.curves.flatMap((curve, c): Line[] => {
        const y = curve.values(run.history);
        if (!y) return [];
        const label = !several
          ? curve.label
          : plot.curves.length > 1
            ? `${run.label}: ${curve.label}`
            : run.label;
        return [
          { label, x: run.history.column("time")!, y, colour: several ? r % 7 : c % 7, dash: c },
        ];
      }),
    );
    const marks = several
      ? []
      : this.runs[0]!.phases()
          .slice(1)
          .map((phase) => phase.start);
    return { title: plot.title, unit: plot.unit, lines, marks, zeroBased: plot.zeroBased ?? false };
  }

  private async showProbe(): Promise<void> {
    const { selection, selectedRun } = this.store.now;
    await this.probe.show(this.runs[selectedRun]!, selection, this.runs.length > 1);
    this.chartsAt(this.store.now.time);
  }

  private chartsAt(time: number): void {
    for (const chart of [...this.all, ...this.probe.charts]) chart.at(time);
  }

  private recolour(): void {
    for (const chart of [...this.all, ...this.probe.charts]) chart.renew();
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
