import type { Range, Theme } from "../scene/colour";
import type { Quantity } from "../scene/instant";
import type { Follow, Selection } from "../scene/stage";

/** Everything about the page that the reader can change. */
export interface State {
  time: number;
  playing: boolean;
  /** Seconds of the mission in one second. */
  speed: number;
  quantity: Quantity;
  range: Range;
  follow: Follow;
  knots: boolean;
  bullets: boolean;
  grid: boolean;
  theme: Theme;
  /** What was clicked, and in which of the runs. */
  selection: Selection;
  selectedRun: number;
}

type Listener = (state: Readonly<State>, changed: ReadonlySet<keyof State>) => void;

/** Holds the state and tells listeners what has changed. */
export class Store {
  private readonly listeners: Listener[] = [];

  constructor(private state: State) {}

  get now(): Readonly<State> {
    return this.state;
  }

  set(change: Partial<State>): void {
    const changed = new Set<keyof State>();
    for (const key of Object.keys(change) as (keyof State)[])
      if (this.state[key] !== change[key]) changed.add(key);
    if (changed.size === 0) return;
    this.state = { ...this.state, ...change };
    for (const listener of this.listeners) listener(this.state, changed);
  }

  listen(listener: Listener): void {
    this.listeners.push(listener);
  }
}
