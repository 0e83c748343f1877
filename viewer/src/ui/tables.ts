import type { MeasureValue, Run } from "../data/run";
import { numberText, spaced, unitText } from "../format/number";
import { h } from "./dom";

/** A measure as text with its unit; a dash where it does not apply. */
export function measureCell(value: MeasureValue | undefined, unit: string): HTMLElement {
  if (value === null || value === undefined) return h("td", { class: "num" }, "\u2013");
  if (typeof value === "boolean") return h("td", { class: "num" }, value ? "yes" : "no");
  const shown = unitText(unit);
  return h(
    "td",
    { class: "num" },
    numberText(value),
    shown ? h("small", {}, `\u00a0${shown}`) : undefined,
  );
}

function section(title: string, ...content: HTMLElement[]): HTMLElement {
  return h("section", {}, h("h2", {}, title), ...content);
}

function table(head: (string | HTMLElement)[], rows: HTMLElement[]): HTMLElement {
  const heading =
    head.length > 0 &&
    h("thead", {}, h("tr", {}, ...head.map((c) => (typeof c === "string" ? h("th", {}, c) : c))));
  return h("div", { class: "table" }, h("table", {}, heading, h("tbody", {}, ...rows)));
}

function measures(runs: Run[]): HTMLElement | undefined {
  const names = [...new Set(runs.flatMap((run) => Object.keys(run.summary?.measures ?? {})))];
  if (names.length === 0) return undefined;
  const row = (name: string): HTMLElement =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, spaced(name)),
      ...runs.map((run) =>
        measureCell(run.summary?.measures[name], run.summary?.units[name] ?? ""),
      ),
    );
  if (runs.length > 1)
    return section(
      "Measures",
      table(
        ["Measure", ...runs.map((run) => h("th", { class: "num" }, run.label))],
        names.map(row),
      ),
    );
  const half = Math.ceil(names.length / 2);
  return section(
    "Measures of the whole run",
    h(
      "div",
      { class: "columns" },
      table([], names.slice(0, half).map(row)),
      table([], names.slice(half).map(row)),
    ),
  );
}

function phases(run: Run): HTMLElement | undefined {
  const list = run.summary?.phases ?? [];
  if (list.length === 0) return undefined;
  const rows = list.map((phase) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, phase.name),
      h("td", {}, phase.kind),
      h("td", { class: "num" }, numberText(phase.start, 6)),
      h("td", { class: "num" }, numberText(phase.end, 6)),
      h("td", {}, h("code", {}, phase.trigger)),
    ),
  );
  const num = (text: string): HTMLElement => h("th", { class: "num" }, text);
  const details = list
    .filter((phase) => Object.keys(phase.measures).length > 0)
    .map((phase) =>
      h(
        "details",
        {},
        h("summary", {}, `Measures of phase ${phase.name}`),
        table(
          [],
          Object.entries(phase.measures).map(([name, value]) =>
            h(
              "tr",
              {},
              h("th", { scope: "row" }, spaced(name)),
              measureCell(value, run.summary!.units[name] ?? ""),
            ),
          ),
        ),
      ),
    );
  return section(
    "Phases",
    table(["Phase", "Kind", num("Start / s"), num("End / s"), "Ended by"], rows),
    ...details,
  );
}

function text(title: string, content: string): HTMLElement | undefined {
  return content ? h("details", {}, h("summary", {}, title), h("pre", {}, content)) : undefined;
}

function mission(run: Run): HTMLElement | undefined {
  const parts = [
    text("What was chosen at the start", run.summary?.start_report ?? ""),
    text("The mission file as it was given", run.mission),
    text("The mission with every default filled in", run.resolved),
  ].filter((part) => part !== undefined);
  return parts.length > 0 ? section("Mission", ...parts) : undefined;
}

function versions(run: Run): HTMLElement | undefined {
  const s = run.summary;
  if (!s) return undefined;
  const pair = ([name, value]: [string, unknown]): HTMLElement =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, name),
      h("td", { class: "num" }, String(value ?? "") || "\u2013"),
    );
  const program: [string, unknown][] = [
    ["Retiarius", s.versions.retiarius],
    ["Revision", s.versions.revision],
    ["Compiler", s.versions.compiler],
    ["Build type", s.options["build_type"]],
    ["Kernels", s.kernels],
    ["Seed", s.seed],
  ];
  const parts: [string, unknown][] = [
    ...Object.entries(s.options)
      .filter(([name]) => name !== "build_type")
      .map(([name, value]): [string, unknown] => [`Option ${name}`, value]),
    ...Object.entries(s.versions.libraries),
  ];
  return section(
    "Versions",
    h(
      "div",
      { class: "columns" },
      table([], program.filter(([, value]) => value !== undefined && value !== "").map(pair)),
      table([], parts.map(pair)),
    ),
  );
}

/** All tables and texts of the runs. */
export function tables(runs: Run[]): HTMLElement {
  const parts: (HTMLElement | undefined)[] = [measures(runs)];
  for (const run of runs) {
    const own = [phases(run), mission(run), versions(run)].filter((part) => part !== undefined);
    if (runs.length > 1 && own.length > 0) parts.push(h("h2", { class: "run" }, run.label));
    parts.push(...own);
  }
  return h("div", { class: "tables" }, ...parts.filter((part) => part !== undefined));
}
