/**
 * Where the page takes a run from. The page asks again while a run is live; a source hands on what
 * is new since the last call.
 */
export interface Source {
  /** How the run is called where several are shown. */
  readonly label: string;
  /** Bytes of replay.bin from `from` on; empty where there is nothing new. */
  replay(from: number): Promise<Uint8Array>;
  /** The texts of a run's other files, as far as they are there. */
  texts(): Promise<Texts>;
  /** Whether more may come. */
  readonly live: boolean;
}

export interface Texts {
  /** history.csv */
  history?: string | undefined;
  /** summary.json */
  summary?: string | undefined;
  /** mission.toml, as the run was given it */
  mission?: string | undefined;
  /** resolved.toml, with every default */
  resolved?: string | undefined;
}

export const textFiles = {
  history: "history.csv",
  summary: "summary.json",
  mission: "mission.toml",
  resolved: "resolved.toml",
} as const;
