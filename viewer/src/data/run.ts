import { Recording } from "../format/recording";
import type { Source } from "./source";
import { Table } from "./table";
import { type PhaseSpan, phasesOfFrames } from "./timeline";

export type MeasureValue = number | boolean | null;

export interface Summary {
  title: string | null;
  outcome: string;
  reason: string;
  phases: (PhaseSpan & { trigger: string; measures: Record<string, MeasureValue> })[];
  measures: Record<string, MeasureValue>;
  units: Record<string, string>;
  seed: number | null;
  start_report: string;
  versions: {
    retiarius: string;
    revision?: string;
    compiler: string;
    libraries: Record<string, string>;
  };
  options: Record<string, string>;
  kernels: string;
}

/** One run with all that the page shows of it. */
export class Run {
  readonly recording = new Recording();
  history = new Table("");
  summary: Summary | undefined;
  mission = "";
  resolved = "";

  constructor(private readonly source: Source) {}

  get label(): string {
    return this.source.label;
  }
  get title(): string {
    return this.summary?.title || this.recording.header?.title || "Mission";
  }
  get live(): boolean {
    return this.source.live;
  }
  get start(): number {
    return this.recording.times[0] ?? 0;
  }
  get end(): number {
    return this.recording.times[this.recording.count - 1] ?? 0;
  }

  /** Takes what is new; true where there was anything. Throws DataError. */
  async update(): Promise<boolean> {
    const texts = await this.source.texts();
    const rows = this.history.rows;
    if (texts.history) this.history = new Table(texts.history);
    const ended = !this.summary && texts.summary !== undefined;
    if (texts.summary) this.summary = JSON.parse(texts.summary) as Summary;
    this.mission = texts.mission ?? this.mission;
    this.resolved = texts.resolved ?? this.resolved;
    // Last, so that a damaged recording leaves the texts to be read.
    const bytes = await this.source.replay(this.recording.bytes);
    if (bytes.length > 0) await this.recording.append(bytes);
    return bytes.length > 0 || rows !== this.history.rows || ended;
  }

  phases(): PhaseSpan[] {
    if (this.summary) return this.summary.phases;
    if (this.recording.end) return this.recording.end.phases;
    const { times, header } = this.recording;
    const numbers = times.map((_, k) => this.recording.phase(k));
    return phasesOfFrames(times, numbers, header?.phases ?? []);
  }
}
