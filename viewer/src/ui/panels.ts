import type { Run } from "../data/run";
import { Chart, type ChartContent, type Line } from "./chart";
import { h } from "./dom";
import { type Plot, plotsOf } from "./plots";
import { Probe } from "./probe";
import type { Store } from "./state";
import { tables } from "./tables";

/** The plots beside the picture, the history of what was clicked, and the tables below. */
export class Panels {
  readonly plots: HTMLElement;
  readonly report = h("div", {});
  private readonly probe: Probe;
  private readonly holder = h("div", { class: "charts" });
  private charts: Chart[] = [];
  /** How many runs have told their end. */
  private told = -1;

  constructor(
    private readonly runs: Run[],
    private readonly store: Store,
    private readonly seek: (time: number) => void,
    failed: (error: unknown) => void,
  ) {
    this.probe = new Probe(seek, () => store.set({ selection: undefined }), failed);
    this.plots = h(
      "aside",
      { class: "right", "aria-label": "Plots" },
      this.probe.element,
      this.holder,
    );
    store.listen((state, changed) => {
      if (changed.has("time")) this.at(state.time);
      if (changed.has("selection")) void this.showProbe();
      if (changed.has("theme")) for (const chart of this.all()) chart.renew();
    });
  }

  /** Shows what the runs say now. */
  update(): void {
    const contents = plotsOf(this.runs.map((run) => run.history)).map((plot) => this.content(plot));
    const kept =
      contents.length === this.charts.length &&
      contents.every((content, k) => this.charts[k]!.update(content));
    if (!kept) {
      this.charts = contents.map((content) => new Chart(content, this.seek));
      this.holder.replaceChildren(...this.charts.map((chart) => chart.element));
    }
    const told = this.runs.filter((run) => run.summary).length;
    if (told !== this.told) this.report.replaceChildren(tables(this.runs));
    this.told = told;
    this.at(this.store.now.time);
  }

  private all(): Chart[] {
    return [...this.charts, ...this.probe.charts];
  }

  private at(time: number): void {
    for (const chart of this.all()) chart.at(time);
  }

  private async showProbe(): Promise<void> {
    const { selection, selectedRun } = this.store.now;
    await this.probe.show(this.runs[selectedRun]!, selection, this.runs.length > 1);
    this.at(this.store.now.time);
  }

  /** Of one run each curve has its colour; of several each run, and the dashes tell the curves. */
  private content(plot: Plot): ChartContent {
    const several = this.runs.length > 1;
    const name = (run: Run, curve: string): string => {
      if (!several) return curve;
      return plot.curves.length > 1 ? `${run.label}: ${curve}` : run.label;
    };
    const lines = this.runs.flatMap((run, r) =>
      plot.curves.flatMap((curve, c): Line[] => {
        const y = curve.values(run.history);
        const x = run.history.column("time");
        if (!x || !y) return [];
        return [{ label: name(run, curve.label), x, y, colour: (several ? r : c) % 7, dash: c }];
      }),
    );
    const starts = this.runs[0]!.phases().map((phase) => phase.start);
    return {
      title: plot.title,
      unit: plot.unit,
      lines,
      marks: several ? [] : starts.slice(1),
      zeroBased: plot.zeroBased ?? false,
    };
  }
}
