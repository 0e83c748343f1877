import type { Run } from "../data/run";
import { steppedTime } from "../data/timeline";
import { numberText } from "../format/number";
import { h, icon } from "./dom";
import type { Store } from "./state";

const speeds = [0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];

/** The speed at which a run of this duration takes about a dozen seconds. */
export function fittingSpeed(duration: number): number {
  return speeds.reduce((a, b) =>
    Math.abs(Math.log(duration / b / 12)) < Math.abs(Math.log(duration / a / 12)) ? b : a,
  );
}

/** Play, steps, speed, and the slider with the phases marked on it. */
export class Transport {
  readonly element: HTMLElement;
  private readonly play: HTMLButtonElement;
  private readonly slider: HTMLInputElement;
  private readonly clock = h("output", { class: "clock", "aria-live": "off" });
  private readonly phases = h("div", { class: "phases", "aria-hidden": "true" });
  private readonly speed: HTMLSelectElement;
  private before = 0;

  constructor(
    private readonly runs: Run[],
    private readonly store: Store,
  ) {
    this.play = h("button", {
      class: "play",
      title: "Play or pause (space)",
      click: () => this.toggle(),
    });
    this.slider = h("input", {
      type: "range",
      step: "any",
      "aria-label": "Time in seconds",
      input: () => store.set({ time: Number(this.slider.value), playing: false }),
    });
    this.speed = h("select", {
      "aria-label": "Speed",
      title: "Speed",
      change: () => store.set({ speed: Number(this.speed.value) }),
    });
    for (const s of speeds) this.speed.append(h("option", { value: s }, `${numberText(s)}\u00d7`));
    const back = h(
      "button",
      { title: "One frame back (,)", "aria-label": "One frame back", click: () => this.step(-1) },
      icon("back"),
    );
    const forward = h(
      "button",
      { title: "One frame on (.)", "aria-label": "One frame on", click: () => this.step(1) },
      icon("forward"),
    );
    this.element = h(
      "div",
      { class: "transport" },
      h("div", { class: "buttons" }, back, this.play, forward),
      h("div", { class: "track" }, this.phases, this.slider),
      this.clock,
      this.speed,
    );
    this.speed.value = String(store.now.speed);
    this.renew();
    this.show();
    store.listen((_, changed) => {
      if (changed.has("time") || changed.has("playing") || changed.has("speed")) this.show();
    });
  }

  get start(): number {
    return Math.min(...this.runs.map((run) => run.start));
  }
  get end(): number {
    return Math.max(...this.runs.map((run) => run.end));
  }

  /** Where the slider ends: the runs may have grown since. */
  get shownEnd(): number {
    return Number(this.slider.max);
  }

  /** After runs have grown. */
  renew(): void {
    this.slider.min = String(this.start);
    this.slider.max = String(this.end);
    const span = this.end - this.start || 1;
    const longest = this.runs.reduce((a, b) => (b.end > a.end ? b : a));
    const phases = longest.phases();
    this.phases.replaceChildren(
      ...phases
        .filter((p) => p.end > p.start)
        .map((phase) => {
          const at = (100 * (phase.start - this.start)) / span;
          const width = (100 * (Math.min(phase.end, this.end) - phase.start)) / span;
          return h(
            "span",
            {
              style: `left:${at}%;width:${width}%`,
              title: `${phase.name}: ${numberText(phase.start)} to ${numberText(phase.end)} s`,
            },
            h("i", {}, phase.name),
          );
        }),
    );
  }

  toggle(): void {
    const { playing, time } = this.store.now;
    if (!playing && time >= this.end) this.store.set({ time: this.start });
    this.store.set({ playing: !playing });
  }

  step(frames: number): void {
    const times = this.runs[0]!.recording.times;
    this.store.set({ time: steppedTime(times, this.store.now.time, frames), playing: false });
  }

  /** Moves time on while playing; `now` in milliseconds. */
  tick(now: number): void {
    const passed = Math.min(0.1, (now - this.before) / 1000);
    this.before = now;
    const { playing, time, speed } = this.store.now;
    if (!playing) return;
    const next = Math.min(this.end, time + passed * speed);
    this.store.set(
      next >= this.end && !this.runs.some((run) => run.live)
        ? { time: next, playing: false }
        : { time: next },
    );
  }

  private show(): void {
    const { time, playing, speed } = this.store.now;
    const span = this.end - this.start || 1;
    this.slider.value = String(time);
    this.slider.style.setProperty("--done", `${(100 * (time - this.start)) / span}%`);
    const text = `${time.toFixed(span < 20 ? 3 : 2)}\u00a0s`;
    this.slider.setAttribute("aria-valuetext", text);
    this.clock.textContent = text;
    const label = playing ? "pause" : "play";
    if (this.play.dataset["shows"] !== label) {
      this.play.dataset["shows"] = label;
      this.play.setAttribute("aria-label", playing ? "Pause" : "Play");
      this.play.replaceChildren(icon(label));
    }
    this.speed.value = String(speed);
  }
}
