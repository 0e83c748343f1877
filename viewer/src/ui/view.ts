import type { Run } from "../data/run";
import { numberText } from "../format/number";
import { Extent } from "../scene/camera";
import type { Range } from "../scene/colour";
import type { Quantity } from "../scene/instant";
import { pick } from "../scene/picking";
import { Stage } from "../scene/stage";
import { sampleFrames, usualRanges } from "../scene/survey";
import { h } from "./dom";
import type { Store } from "./state";

/** One run's picture with what is written on it. */
export class View {
  readonly element: HTMLElement;
  readonly stage: Stage;
  ranges!: Record<Quantity, Range>;
  private readonly note = h("div", { class: "note-on-stage" });
  private readonly extent = new Extent();

  constructor(
    readonly run: Run,
    readonly index: number,
    private readonly store: Store,
    named: boolean,
    failed: (error: unknown) => void,
  ) {
    const canvas = h("canvas", {
      tabindex: 0,
      role: "img",
      "aria-label": `Moving picture of the run ${run.title}; the outcome above says it in words`,
    });
    this.element = h("figure", { class: "stage" }, canvas, this.note);
    if (named) this.element.append(h("figcaption", {}, run.label));
    this.stage = new Stage(canvas, run.recording, failed);
    new ResizeObserver(() =>
      this.stage.resize(this.element.clientWidth, this.element.clientHeight),
    ).observe(this.element);
    this.listenToClicks(canvas);
    store.listen((state, changed) => {
      if (changed.has("time")) this.show();
      if (changed.has("quantity") || changed.has("range") || changed.has("theme"))
        this.stage.colours(state.theme, state.quantity, state.range);
      if (changed.has("knots") || changed.has("bullets") || changed.has("grid"))
        this.stage.parts(state.knots, state.bullets, state.grid);
      if (changed.has("follow")) this.stage.setFollow(state.follow);
      if (changed.has("selection"))
        this.stage.select(state.selectedRun === index ? state.selection : undefined);
    });
  }

  /** Decodes the first frame and what survey() looks at. */
  async prepare(): Promise<void> {
    await this.survey();
    await this.run.recording.load(0);
  }

  /** Looks at a few frames, from which come colours and camera. */
  async survey(): Promise<void> {
    const { recording } = this.run;
    const frames = await sampleFrames(recording);
    this.ranges = usualRanges(recording, frames);
    const q = recording.header.quantum;
    for (const frame of frames) {
      const points = new Float64Array(3 * recording.header.nodes);
      for (let k = 0; k < recording.header.nodes; ++k)
        points.set([frame.x[k]! * q, frame.y[k]! * q, frame.z[k]! * q], 3 * k);
      this.extent.add(points, 3, recording.header.nodes);
      this.stage.addBodies(this.extent, frame.poses);
    }
  }

  /** Everything that happens, seen at once, or only what is there now where the way is long. */
  get whole(): Extent | undefined {
    return this.extent.size < 5 * this.run.recording.header.size ? this.extent : undefined;
  }

  show(): void {
    const { time } = this.store.now;
    const { recording } = this.run;
    this.stage.show(Math.min(time, this.run.end));
    const phase = this.run.phases().findLast((p) => p.start <= time);
    const late = time > this.run.end ? ", ended" : "";
    this.note.textContent = `${phase?.name ?? ""}${late}`;
    if (recording.count > 0) this.note.title = `phase at ${numberText(time)} s`;
  }

  private listenToClicks(canvas: HTMLCanvasElement): void {
    let start: { x: number; y: number } | undefined;
    canvas.addEventListener(
      "pointerdown",
      (event) => (start = { x: event.clientX, y: event.clientY }),
    );
    canvas.addEventListener("pointerup", (event) => {
      if (
        !start ||
        event.button !== 0 ||
        Math.hypot(event.clientX - start.x, event.clientY - start.y) > 5
      )
        return;
      const box = canvas.getBoundingClientRect();
      const selection = pick(this.stage, event.clientX - box.left, event.clientY - box.top);
      this.store.set({ selection, selectedRun: this.index });
    });
  }
}
