import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { numberText, unitText } from "../format/number";
import { h } from "./dom";

export interface Line {
  label: string;
  x: ArrayLike<number>;
  y: ArrayLike<number>;
  /** Number of the colour, 0 to 6, and of the dash pattern. */
  colour: number;
  dash?: number;
}

export interface ChartContent {
  title: string;
  unit: string;
  lines: Line[];
  zeroBased?: boolean;
  /** Instants at which phases start. */
  marks: number[];
}

const dashes = [[], [7, 3], [2.5, 3], [9, 3, 2, 3], [4, 3], [12, 4], [1.5, 4]];

/** Ticks of the time axis, the last with the unit. */
function inSeconds(ticks: number[]): string[] {
  return ticks.map((t, k) => numberText(t) + (k + 1 === ticks.length ? "\u00a0s" : ""));
}

function shown(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** The value of a line at an instant: linear between rows, NaN outside. */
export function valueAt(line: Pick<Line, "x" | "y">, time: number): number {
  const { x, y } = line;
  let [low, high] = [0, x.length - 1];
  if (high < 0 || !(time >= x[0]!) || !(time <= x[high]!)) return NaN;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (x[middle]! <= time) low = middle;
    else high = middle;
  }
  if (low === high || time === x[low]) return y[low]!;
  return y[low]! + ((time - x[low]!) / (x[high]! - x[low]!)) * (y[high]! - y[low]!);
}

/** Lines on a common time axis, joined so that each has a value or a gap at every instant. */
export function joined(lines: readonly Line[]): [number[], ...(number | null)[][]] {
  const times = [...new Set(lines.flatMap((line) => Array.from(line.x)))].sort((a, b) => a - b);
  const place = new Map(times.map((t, k) => [t, k]));
  const columns = lines.map((line) => {
    const column: (number | null)[] = new Array<number | null>(times.length).fill(null);
    Array.from(line.x).forEach(
      (t, k) => (column[place.get(t)!] = Number.isFinite(line.y[k]) ? line.y[k]! : null),
    );
    return column;
  });
  return [times, ...columns];
}

/** One plot over time with a cursor at the slider's instant; a click moves the slider. */
export class Chart {
  readonly element: HTMLElement;
  private plot: uPlot | undefined;
  private readonly values: HTMLElement[];
  private readonly holder = h("div", { class: "canvas" });
  private readonly cursor = h("div", { class: "cursor" });
  private time = 0;

  constructor(
    private content: ChartContent,
    private readonly seek: (time: number) => void,
  ) {
    const unit = unitText(content.unit);
    this.values = content.lines.map(() => h("b", {}));
    const key = content.lines.map((line, k) =>
      h(
        "span",
        {},
        h("i", { style: `--c:var(--c${line.colour})`, "data-dash": line.dash ?? line.colour }),
        line.label,
        " ",
        this.values[k],
      ),
    );
    this.element = h(
      "figure",
      { class: "chart" },
      h("figcaption", {}, content.title, unit ? h("small", {}, ` / ${unit}`) : undefined),
      h("div", { class: "key" }, ...key),
      this.holder,
    );
    new ResizeObserver(() => this.resize()).observe(this.holder);
  }

  /** Takes longer lines of the same plot; false where it is another one. */
  update(content: ChartContent): boolean {
    const names = (c: ChartContent): string =>
      JSON.stringify([c.title, c.unit, c.lines.map((line) => line.label)]);
    if (names(content) !== names(this.content)) return false;
    this.content = content;
    this.plot?.setData(joined(content.lines) as uPlot.AlignedData);
    return true;
  }

  /** Makes the plot anew, as when colours have changed. */
  renew(): void {
    this.plot?.destroy();
    this.plot = undefined;
    this.resize();
  }

  at(time: number): void {
    this.time = time;
    this.content.lines.forEach((line, k) => {
      const value = valueAt(line, time);
      this.values[k]!.textContent = Number.isFinite(value) ? numberText(value, 4) : "";
    });
    if (!this.plot) return;
    const left = this.plot.valToPos(time, "x");
    const width = this.plot.over.clientWidth;
    this.cursor.style.transform = `translateX(${left}px)`;
    this.cursor.hidden = !(left >= 0 && left <= width);
  }

  private resize(): void {
    const width = this.holder.clientWidth;
    if (width < 10) return;
    const height = 132;
    if (this.plot) this.plot.setSize({ width, height });
    else this.make(width, height);
    this.at(this.time);
  }

  private make(width: number, height: number): void {
    const axis: uPlot.Axis = {
      stroke: shown("--soft"),
      font: "11px system-ui, sans-serif",
      gap: 4,
      grid: { stroke: shown("--grid"), width: 1 },
      ticks: { show: false },
    };
    this.plot = new uPlot(
      {
        width,
        height,
        legend: { show: false },
        padding: [8, 18, 0, 0],
        cursor: { y: false, points: { show: false }, drag: { x: false, y: false } },
        scales: { x: { time: false }, y: { range: (_, low, high) => this.range(low, high) } },
        axes: [
          { ...axis, size: 22, values: (_, ticks) => inSeconds(ticks) },
          { ...axis, size: 52, values: (_, ticks) => ticks.map((t) => numberText(t, 3)) },
        ],
        series: [
          {},
          ...this.content.lines.map((line) => ({
            stroke: shown(`--c${line.colour}`),
            width: 1.6,
            dash: dashes[(line.dash ?? line.colour) % dashes.length]!,
            points: { show: false },
            spanGaps: true,
          })),
        ],
        // The scales are known when it draws, not before.
        hooks: { drawClear: [(plot) => this.drawMarks(plot)], draw: [() => this.at(this.time)] },
      },
      joined(this.content.lines) as uPlot.AlignedData,
      this.holder,
    );
    this.plot.over.append(this.cursor);
    this.plot.over.addEventListener("click", (event) =>
      this.seek(this.plot!.posToVal(event.offsetX, "x")),
    );
  }

  private range(low: number, high: number): uPlot.Range.MinMax {
    if (!Number.isFinite(low) || !Number.isFinite(high)) return [0, 1];
    if (low === high) return low === 0 ? [-1, 1] : [Math.min(0, 1.1 * low), Math.max(0, 1.1 * low)];
    const margin = 0.06 * (high - low);
    return this.content.zeroBased && low >= 0 ? [0, high + margin] : [low - margin, high + margin];
  }

  private drawMarks(plot: uPlot): void {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.strokeStyle = shown("--soft");
    ctx.globalAlpha = 0.6;
    ctx.lineWidth = devicePixelRatio;
    ctx.setLineDash([1.5 * devicePixelRatio, 3.5 * devicePixelRatio]);
    for (const time of this.content.marks) {
      const x = Math.round(plot.valToPos(time, "x", true));
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
    }
    ctx.restore();
  }
}
