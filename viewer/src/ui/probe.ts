import type { Run } from "../data/run";
import { numberText } from "../format/number";
import { positionAt, type Quantity, valueAt } from "../scene/instant";
import type { Selection } from "../scene/stage";
import { Chart, type Line } from "./chart";
import { h } from "./dom";

interface Wanted {
  title: string;
  unit: string;
  labels: string[];
}
const ofSegment: Wanted[] = [
  { title: "Tension", unit: "N", labels: ["tension"] },
  { title: "Strain", unit: "1", labels: ["strain"] },
];
const ofNode: Wanted[] = [
  { title: "Speed", unit: "m/s", labels: ["speed"] },
  { title: "Curvature", unit: "1/m", labels: ["curvature"] },
  { title: "Position", unit: "m", labels: ["x", "y", "z"] },
];

/** Recorded values of one segment or node in every frame: a list for each curve. */
export async function readHistory(
  run: Run,
  selection: NonNullable<Selection>,
  progress: (share: number) => void,
  cancelled: () => boolean,
): Promise<Float64Array[] | undefined> {
  const { recording } = run;
  const { count, header } = recording;
  const names: Quantity[] =
    selection.kind === "segment" ? ["tension", "strain"] : ["speed", "curvature"];
  const lists = Array.from(
    { length: names.length + (selection.kind === "node" ? 3 : 0) },
    () => new Float64Array(count),
  );
  for (let k = 0; k < count; ++k) {
    const frame = recording.ready(k) ?? (await recording.load(k));
    if (cancelled()) return undefined;
    names.forEach((name, i) => (lists[i]![k] = valueAt(header, frame, name, selection.index)));
    if (selection.kind === "node")
      positionAt(header, frame, selection.index).forEach(
        (x, i) => (lists[names.length + i]![k] = x),
      );
    if (k % 16 === 0) progress(k / count);
  }
  return lists;
}

/** The card about what was clicked: what it is, and its history. */
export class Probe {
  readonly element = h("section", { class: "probe", hidden: true, "aria-live": "polite" });
  charts: Chart[] = [];
  private turn = 0;

  constructor(
    private readonly seek: (time: number) => void,
    private readonly close: () => void,
    private readonly failed: (error: unknown) => void,
  ) {}

  async show(run: Run, selection: Selection, named: boolean): Promise<void> {
    const turn = ++this.turn;
    this.element.hidden = !selection;
    this.charts = [];
    if (!selection) return;
    const state = h("span", { class: "note" }, "reading the recording\u2026");
    const title = `${selection.kind === "segment" ? "Segment" : "Node"} ${selection.index}`;
    const head = h(
      "header",
      {},
      h("h3", {}, title, named ? h("small", {}, ` of ${run.label}`) : undefined),
      h(
        "button",
        { title: "Close (Escape)", "aria-label": "Close", click: () => this.close() },
        "\u00d7",
      ),
    );
    this.element.replaceChildren(head, h("p", { class: "note" }, describe(run, selection)), state);
    try {
      const lists = await readHistory(
        run,
        selection,
        (share) => (state.textContent = `reading the recording\u2026 ${Math.round(100 * share)} %`),
        () => turn !== this.turn,
      );
      if (lists) this.plot(run, selection, lists);
      if (lists) state.remove();
    } catch (error) {
      this.failed(error);
    }
  }

  private plot(run: Run, selection: NonNullable<Selection>, lists: Float64Array[]): void {
    const marks = run
      .phases()
      .slice(1)
      .map((phase) => phase.start);
    let next = 0;
    for (const { title, unit, labels } of selection.kind === "segment" ? ofSegment : ofNode) {
      const lines: Line[] = labels.map((label, k) => ({
        label,
        x: run.recording.times,
        y: lists[next++]!,
        colour: k,
      }));
      const chart = new Chart({ title, unit, lines, marks }, this.seek);
      this.charts.push(chart);
      this.element.append(chart.element);
    }
  }
}

function describe(run: Run, { kind, index }: NonNullable<Selection>): string {
  const { header } = run.recording;
  if (kind === "segment")
    return (
      `between nodes ${header.ends[2 * index]} and ${header.ends[2 * index + 1]}, rest length ` +
      `${numberText(header.restLength[index]!)}\u00a0m, thread radius ${numberText(1000 * header.radius[index]!)}\u00a0mm`
    );
  const corner = header.corners.indexOf(index);
  const parts = [`mass ${numberText(1000 * header.mass[index]!)}\u00a0g`];
  if (corner >= 0) parts.unshift(`corner ${corner}`);
  return parts.join(", ");
}
