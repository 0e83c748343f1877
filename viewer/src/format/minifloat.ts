/**
 * Numbers as integer codes: steps of `quantum` below steps * quantum, above that `steps` codes for
 * each doubling. The error is at most quantum / 2 below, and value / (2 steps) above.
 */
export class Minifloat {
  constructor(
    readonly quantum: number,
    readonly steps: number,
  ) {}

  code(value: number): number {
    let scaled = Math.abs(value) / this.quantum;
    let octave = 0;
    while (scaled >= 2 * this.steps) {
      scaled *= 0.5;
      ++octave;
    }
    const size = Math.floor(scaled + 0.5) + octave * this.steps;
    return value < 0 ? -size : size;
  }

  value(code: number): number {
    const size = Math.abs(code);
    const octave = size < this.steps ? 0 : Math.floor(size / this.steps) - 1;
    const scaled = (size - octave * this.steps) * 2 ** octave * this.quantum;
    return code < 0 ? -scaled : scaled;
  }
}
