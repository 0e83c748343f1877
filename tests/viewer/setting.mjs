// What the tests of the viewer share: where things are, the runs, and tables of their run.h5.
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

/** Folder made by prepare.cmake: runs, their pages, their tables. */
export const runs = process.env.RETIARIUS_TEST_RUNS;
/** Screenshots are kept here. */
export const pictures = join(runs, "pictures");
mkdirSync(pictures, { recursive: true });

export function pageOf(name) {
  return pathToFileURL(join(runs, name)).href;
}

/** A table of `retiarius export --to csv`, as columns of numbers. */
export function table(run, file) {
  const [head, ...lines] = readFileSync(join(runs, `${run}-csv`, file), "utf8")
    .trim()
    .split("\n");
  const columns = Object.fromEntries(head.split(",").map((name) => [name, []]));
  const names = Object.keys(columns);
  for (const line of lines)
    line.split(",").forEach((cell, k) => columns[names[k]].push(Number(cell)));
  return columns;
}

/** Rows of one frame of a table of nodes or segments. */
export function ofFrame(columns, frame) {
  const first = columns.frame.indexOf(frame);
  const last = columns.frame.lastIndexOf(frame);
  return Object.fromEntries(
    Object.entries(columns).map(([name, list]) => [name, list.slice(first, last + 1)]),
  );
}

/** Moves the page's own slider, as a reader does, and waits for the picture. */
export async function slide(page, time) {
  await page.evaluate(async (t) => {
    const slider = document.querySelector(".track input");
    slider.value = String(t);
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    await window.retiarius.seek(window.retiarius.app.store.now.time);
  }, time);
}

/** Shares of different colours in the picture of a run: [number of colours, share of the most frequent]. */
export function variety(page, run = 0) {
  return page.evaluate((k) => {
    const canvas = document.querySelectorAll(".stage canvas")[k];
    const copy = document.createElement("canvas");
    copy.width = canvas.width;
    copy.height = canvas.height;
    const context = copy.getContext("2d", { willReadFrequently: true });
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    const seen = new Map();
    for (let i = 0; i < data.length; i += 4) {
      const colour =
        (data[i] << 16) | (data[i + 1] << 8) | data[i + 2] | (data[i + 3] < 128 ? 1 << 24 : 0);
      seen.set(colour, (seen.get(colour) ?? 0) + 1);
    }
    return [seen.size, Math.max(...seen.values()) / (data.length / 4)];
  }, run);
}
