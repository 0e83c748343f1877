import type { Run } from "../data/run";
import { DataError } from "../format/errors";
import { numberText, spaced } from "../format/number";
import { h } from "./dom";

/**
 * The heading that a page made by the program has already: where the page asks a server, or runs
 * go on, it is written here. It says what is torn or missing, too.
 */
export function showHeading(runs: Run[], waiting?: string): void {
  const notes = runs.flatMap((run) => notesOf(run, runs.length > 1));
  const place = document.querySelector("header.top") ?? newHeading();
  place.querySelectorAll(".data-note").forEach((note) => note.remove());
  if (waiting) notes.push(waiting);
  for (const note of notes) place.append(h("p", { class: "note data-note", role: "status" }, note));
  if (place.hasAttribute("data-made")) {
    const run = runs[0]!;
    place.querySelector("h1")!.textContent = run.title;
    document.title = `${run.title} \u00b7 Retiarius`;
    place.querySelector(".outcome")!.replaceWith(outcome(run));
  }
}

function newHeading(): Element {
  const made = h(
    "header",
    { class: "top", "data-made": true },
    h("p", { class: "brand" }, "Retiarius"),
    h("h1", {}),
    h("p", { class: "outcome" }),
  );
  document.querySelector("main")!.prepend(made);
  return made;
}

function outcome(run: Run): HTMLElement {
  const { summary } = run;
  if (!summary)
    return h(
      "p",
      { class: "outcome running" },
      h("b", {}, "Running"),
      h(
        "span",
        {},
        run.recording.count > 0
          ? `${numberText(run.end, 4)} s of mission time so far`
          : "no frame yet",
      ),
    );
  const reason =
    summary.reason ||
    `${summary.phases.length} phases, ${numberText(run.end, 6)} s of mission time`;
  return h(
    "p",
    { class: `outcome ${summary.outcome}` },
    h("b", {}, spaced(summary.outcome)),
    h("span", {}, reason),
  );
}

function notesOf(run: Run, named: boolean): string[] {
  const { recording } = run;
  const notes: string[] = [];
  if (!run.live && recording.torn > 0)
    notes.push(
      `The recording ends in a frame that is not complete; it is shown up to ${numberText(run.end)} s.`,
    );
  if (!run.live && recording.torn === 0 && recording.header && !recording.end)
    notes.push(
      `The run was cut off; it is shown up to its last recorded frame at ${numberText(run.end)} s.`,
    );
  return notes.map((note) => (named ? `${run.label}: ${note}` : note));
}

/** Says what went wrong, above what can still be shown. */
export function fail(error: unknown, what = "This run cannot be shown in 3D."): void {
  const known = error instanceof DataError;
  const text = error instanceof Error ? error.message : String(error);
  const place = document.getElementById("app")!;
  if (!document.documentElement.dataset["ready"])
    document.documentElement.dataset["ready"] = "failed";
  place.querySelector(".failure")?.remove();
  place.prepend(
    h(
      "div",
      { class: "failure", role: "alert" },
      h("b", {}, what),
      h("p", {}, `${text.charAt(0).toUpperCase()}${text.slice(1)}.`),
      !known &&
        h(
          "p",
          { class: "note" },
          "The pictures need a browser with WebGL 2; the tables below do not.",
        ),
    ),
  );
  if (!known) console.error(error);
}
