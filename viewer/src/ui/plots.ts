import type { Table } from "../data/table";

/** One curve: what the key calls it, and its values from a run's history. */
export interface Curve {
  label: string;
  values: (history: Table) => Float64Array | undefined;
}

export interface Plot {
  title: string;
  unit: string;
  curves: Curve[];
  zeroBased?: boolean;
}

function column(name: string): (history: Table) => Float64Array | undefined {
  return (history) => history.column(name);
}

function curves(...pairs: [name: string, label: string][]): Curve[] {
  return pairs.map(([name, label]) => ({ label, values: column(name) }));
}

/** What has changed since the first row. */
function changes(...pairs: [name: string, label: string][]): Curve[] {
  return pairs.map(([name, label]) => ({
    label,
    values: (history) => history.column(name)?.map((y, _, all) => y - all[0]!),
  }));
}

function newtonPerStep(history: Table): Float64Array | undefined {
  const [total, steps] = [history.column("newton_iterations"), history.column("step")];
  if (!total || !steps) return undefined;
  return total.map((n, k) =>
    k > 0 && steps[k]! > steps[k - 1]! ? (n - total[k - 1]!) / (steps[k]! - steps[k - 1]!) : NaN,
  );
}

const fixed: Plot[] = [
  {
    title: "Mouth area",
    unit: "m2",
    zeroBased: true,
    curves: curves(
      ["mouth_area", "projected"],
      ["mouth_vector_area", "vector area"],
      ["perimeter_area", "perimeter"],
    ),
  },
  {
    title: "Peak tension",
    unit: "N",
    zeroBased: true,
    curves: curves(["peak_tension", "peak tension"]),
  },
  {
    title: "Captured share",
    unit: "1",
    zeroBased: true,
    curves: curves(["captured_share", "captured share"]),
  },
  {
    title: "Energies",
    unit: "J",
    curves: curves(
      ["kinetic_energy", "kinetic"],
      ["stretching_energy", "stretching"],
      ["bending_energy", "bending"],
      ["gravity_energy", "gravity"],
    ),
  },
  {
    title: "Energy account",
    unit: "J",
    curves: curves(
      ["prescribed_work", "prescribed work"],
      ["material_loss", "material"],
      ["environment_loss", "environment"],
      ["friction_loss", "friction"],
      ["impact_loss", "impact"],
      ["integrator_loss", "integrator"],
    ),
  },
  {
    title: "Change of momentum",
    unit: "kg m/s",
    curves: changes(["momentum_x", "x"], ["momentum_y", "y"], ["momentum_z", "z"]),
  },
  {
    title: "Change of angular momentum",
    unit: "kg m2/s",
    curves: changes(
      ["angular_momentum_x", "x"],
      ["angular_momentum_y", "y"],
      ["angular_momentum_z", "z"],
    ),
  },
  {
    title: "Mouth width",
    unit: "m",
    zeroBased: true,
    curves: curves(["mouth_width", "between corners"]),
  },
  {
    title: "Smallest distance",
    unit: "m",
    curves: curves(["smallest_distance", "thread to body"]),
  },
  { title: "Nodes in contact", unit: "1", zeroBased: true, curves: curves(["contacts", "nodes"]) },
  {
    title: "Peak strain",
    unit: "1",
    zeroBased: true,
    curves: curves(["peak_strain", "peak strain"]),
  },
  {
    title: "Newton iterations per step",
    unit: "1",
    zeroBased: true,
    curves: [{ label: "iterations", values: newtonPerStep }],
  },
];

function probePlots(names: readonly string[]): Plot[] {
  return names
    .filter((name) => name.endsWith(".x"))
    .flatMap((name) => {
      const probe = name.slice(0, -2);
      return [
        {
          title: `Probe ${probe}: position`,
          unit: "m",
          curves: curves([`${probe}.x`, "x"], [`${probe}.y`, "y"], [`${probe}.z`, "z"]),
        },
        {
          title: `Probe ${probe}: support force`,
          unit: "N",
          curves: curves([`${probe}.fx`, "x"], [`${probe}.fy`, "y"], [`${probe}.fz`, "z"]),
        },
      ];
    });
}

function says(values: Float64Array | undefined): boolean {
  return values !== undefined && values.some((y) => Number.isFinite(y) && y !== 0);
}

/** The plots that say something about these runs; curves that are zero throughout are left out. */
export function plotsOf(histories: readonly Table[]): Plot[] {
  const names = [...new Set(histories.flatMap((history) => history.names))];
  return [...fixed, ...probePlots(names)]
    .map((plot) => ({
      ...plot,
      curves: plot.curves.filter((curve) =>
        histories.some((history) => says(curve.values(history))),
      ),
    }))
    .filter((plot) => plot.curves.length > 0);
}
