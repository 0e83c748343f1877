// The same page fed by a server that hands out the files of a run which goes on.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { test } from "node:test";
import { openBrowser, openPage } from "./browser.mjs";
import { pictures, runs, variety } from "./setting.mjs";

const replay = readFileSync(join(runs, "drop", "replay.bin"));
const history = readFileSync(join(runs, "drop", "history.csv"));
const summary = readFileSync(join(runs, "drop", "summary.json"), "utf8");
const template = readFileSync(process.env.RETIARIUS_VIEWER_TEMPLATE, "utf8");

/** Shows `shown` of the files; `.asked` lists the ranges that were asked for. */
function serve() {
  const state = { bytes: 0, rows: 0, ended: false, asked: [] };
  const growing = {
    "/replay.bin": () => replay.subarray(0, state.bytes),
    "/history.csv": () => history.subarray(0, Math.floor(history.length * state.rows)),
  };
  const answers = {
    "/": () => ["text/html", template.replace("retiarius-connect", "'self'")],
    "/summary.json": () => state.ended && ["application/json", summary],
  };
  const server = createServer((request, response) => {
    const path = request.url.split("?")[0];
    if (growing[path]) {
      const from = Number(/bytes=(\d+)-/.exec(request.headers.range ?? "")?.[1] ?? 0);
      const there = growing[path]();
      if (path === "/replay.bin") state.asked.push(from);
      if (from >= there.length) return response.writeHead(416).end();
      return response.writeHead(206).end(there.subarray(from));
    }
    const answer = answers[path]?.();
    if (!answer) return response.writeHead(path === "/favicon.ico" ? 204 : 404).end();
    return response.writeHead(200, { "content-type": answer[0] }).end(answer[1]);
  });
  return new Promise((resolve) =>
    server.listen(0, "127.0.0.1", () =>
      resolve({ server, state, url: `http://127.0.0.1:${server.address().port}/` }),
    ),
  );
}

test("the page follows a run that grows, from before its first frame to its end", async () => {
  const { server, state, url } = await serve();
  const browser = await openBrowser();
  try {
    const opening = openPage(browser, url);
    await new Promise((resolve) => setTimeout(resolve, 1500));
    state.bytes = Math.floor(replay.length * 0.5); // within a chunk
    state.rows = 0.5;
    const { page, complaints } = await opening;
    assert.match(await page.innerText(".outcome"), /Running/);
    const count = () => page.evaluate(() => window.retiarius.times().length);
    const first = await count();
    assert.ok(first > 1);
    await page.keyboard.press("End");
    state.bytes = Math.floor(replay.length * 0.8);
    state.rows = 0.8;
    await page.waitForFunction((n) => window.retiarius.times().length > n, first);
    // Who looks at the newest frame keeps looking at the newest.
    await page.waitForFunction(
      () => window.retiarius.app.store.now.time === window.retiarius.times().at(-1),
    );
    assert.ok(
      state.asked.includes(Math.floor(replay.length * 0.5)),
      "only the new part is asked for",
    );
    assert.equal(await page.locator(".tables h2").count(), 0);
    state.bytes = replay.length;
    state.rows = 1;
    state.ended = true;
    await page.waitForFunction(
      () => document.querySelector(".outcome b").textContent === "Finished",
    );
    assert.match(await page.innerText(".tables"), /Measures of the whole run/);
    const rows = await page.evaluate(() => window.retiarius.app.views[0].run.history.rows);
    assert.equal(rows, history.toString().trim().split("\n").length - 1);
    const [colours] = await variety(page);
    assert.ok(colours > 200);
    await page.screenshot({ path: join(pictures, "live.png") });
    const asked = state.asked.length;
    await new Promise((resolve) => setTimeout(resolve, 1800));
    assert.equal(state.asked.length, asked, "a run that has ended is not asked again");
    // Files that are not there yet are answered with 404 and 416, which the browser itself notes.
    assert.deepEqual(
      complaints.filter((text) => !/status of (404|416)/.test(text)),
      [],
    );
  } finally {
    await browser.close();
    server.close();
  }
});

test("a server that stops answering is told", async () => {
  const { server, state, url } = await serve();
  state.bytes = Math.floor(replay.length * 0.5);
  const browser = await openBrowser();
  try {
    const { page } = await openPage(browser, url);
    server.close();
    server.closeAllConnections?.();
    await page.waitForSelector(".failure, .data-note:has-text('does not answer')");
    assert.match(await page.innerText("main"), /the server does not answer/i);
    assert.ok((await variety(page))[0] > 100, "the picture stays");
  } finally {
    await browser.close();
  }
});
