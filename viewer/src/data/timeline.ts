export interface Place {
  frame: number;
  /** From `frame` to the next, 0 to 1. */
  fraction: number;
}

/** Where an instant lies between frames; times before the first and after the last are clamped. */
export function placeOf(times: readonly number[], time: number): Place {
  const last = times.length - 1;
  if (last < 0 || !(time > times[0]!)) return { frame: 0, fraction: 0 };
  if (time >= times[last]!) return { frame: last, fraction: 0 };
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= time) low = middle;
    else high = middle;
  }
  return { frame: low, fraction: (time - times[low]!) / (times[high]! - times[low]!) };
}

/** The frame whose time is nearest, a tie going to the earlier. */
export function nearestFrame(times: readonly number[], time: number): number {
  const { frame, fraction } = placeOf(times, time);
  return fraction > 0.5 ? frame + 1 : frame;
}

/** The instant `steps` frames on; from between two frames, the first step goes to a frame. */
export function steppedTime(times: readonly number[], time: number, steps: number): number {
  const { frame, fraction } = placeOf(times, time);
  const start = fraction > 0 && steps < 0 ? frame + 1 : frame;
  return times[Math.max(0, Math.min(times.length - 1, start + steps))] ?? 0;
}

export interface PhaseSpan {
  name: string;
  kind: string;
  start: number;
  end: number;
}

/** Phases as the frames tell them, for a run that has no summary yet. */
export function phasesOfFrames(
  times: readonly number[],
  phases: readonly number[],
  names: readonly { name: string; kind: string }[],
): PhaseSpan[] {
  const spans: (PhaseSpan & { index: number })[] = [];
  times.forEach((time, k) => {
    const index = phases[k]!;
    const open = spans[spans.length - 1];
    if (open && open.index === index) {
      open.end = time;
      return;
    }
    // The frame at a phase's end still belongs to it: the next begins there.
    const start = open ? open.end : time;
    const named = names[index] ?? { name: `phase ${index}`, kind: "" };
    spans.push({ ...named, index, start, end: time });
  });
  return spans.map(({ name, kind, start, end }) => ({ name, kind, start, end }));
}
