/** The columns of history.csv. */
export class Table {
  private readonly columns = new Map<string, Float64Array>();
  readonly names: string[];
  readonly rows: number;

  constructor(csv: string) {
    const lines = csv.split("\n");
    // A row is whole when it ends with a line feed; what follows the last one is being written.
    lines.pop();
    this.names = lines.length > 0 ? lines[0]!.trim().split(",") : [];
    this.rows = Math.max(0, lines.length - 1);
    for (const name of this.names) this.columns.set(name, new Float64Array(this.rows));
    for (let row = 0; row < this.rows; ++row) {
      const cells = lines[row + 1]!.split(",");
      this.names.forEach((name, k) => {
        const cell = cells[k]?.trim();
        this.columns.get(name)![row] = cell ? Number(cell) : NaN;
      });
    }
  }

  /** Undefined where there is no such column. */
  column(name: string): Float64Array | undefined {
    return this.columns.get(name);
  }
}
