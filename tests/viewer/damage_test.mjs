// Pages with a recording that is damaged, cut or missing: a clear message, and what can be shown.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { openBrowser, openPage } from "./browser.mjs";
import { pageOf, pictures, runs } from "./setting.mjs";

const page0 = readFileSync(join(runs, "drop", "report.html"), "utf8");
const block = /(data-file="replay\.bin">)([^<]*)(<)/;
let browser;
before(async () => (browser = await openBrowser()));
after(() => browser?.close());

/** Opens the report with its recording changed by `change`. */
async function open(name, change) {
  const bytes = Buffer.from(block.exec(page0)[2], "base64");
  const changed = change(bytes);
  const text = typeof changed === "string" ? changed : changed.toString("base64");
  writeFileSync(
    join(runs, name),
    page0.replace(block, (_, start, __, end) => start + text + end),
  );
  return openPage(browser, pageOf(name));
}

const cases = {
  "a flipped bit": [
    (b) => {
      b[Math.floor(b.length / 2)] ^= 4;
      return b;
    },
    /recording is damaged: wrong checksum at byte \d+/i,
  ],
  "other bytes": [
    () => Buffer.from("something else entirely"),
    /does not start with the letters RETREPL/,
  ],
  "a newer format": [
    (b) => {
      b[8] = 7;
      return b;
    },
    /has format 7, this page reads format 1/,
  ],
  nothing: [() => Buffer.alloc(0), /cut off before its header/],
  "a cut in the header": [(b) => b.subarray(0, 300), /cut off before its header/],
  "no base64": [() => "#### \u00e4\u00f6", /no base64 text/],
};
for (const [name, [change, message]] of Object.entries(cases))
  test(`${name} is told, and the tables are shown`, async () => {
    const { page, context, complaints } = await open("damaged.html", change);
    assert.equal(await page.getAttribute("html", "data-ready"), "failed");
    assert.match(await page.innerText(".failure"), message);
    assert.match(await page.innerText("header.top"), /Finished/);
    assert.match(await page.innerText(".tables"), /Measures of the whole run/);
    assert.deepEqual(complaints, []);
    if (name === "a flipped bit") await page.screenshot({ path: join(pictures, "damaged.png") });
    await context.close();
  });

test("a recording that is cut is shown up to its last whole frame", async () => {
  const { page, complaints } = await open("cut.html", (b) =>
    b.subarray(0, Math.floor(0.7 * b.length)),
  );
  assert.equal(await page.getAttribute("html", "data-ready"), "yes");
  assert.match(
    await page.innerText("header.top"),
    /ends in a frame that is not complete; it is shown up to [\d.]+ s/,
  );
  assert.ok((await page.evaluate(() => window.retiarius.times().length)) > 3);
  assert.deepEqual(complaints, []);
});
