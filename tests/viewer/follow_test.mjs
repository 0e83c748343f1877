// `retiarius run --live` as a reader sees it: the page follows the simulation to its end.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { rmSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { openBrowser, openPage } from "./browser.mjs";
import { pictures, runs, variety } from "./setting.mjs";

/** Starts the program; resolves with the address that it prints. */
function start(...words) {
  const child = spawn(process.env.RETIARIUS_PROGRAM, words, { cwd: runs });
  const ended = new Promise((resolve) => child.on("exit", (code) => resolve(code)));
  const address = new Promise((resolve, reject) => {
    let text = "";
    child.stdout.on("data", (data) => {
      text += data;
      const found = /http:\/\/127\.0\.0\.1:\d+\//.exec(text);
      if (found) resolve(found[0]);
    });
    ended.then((code) => reject(new Error(`the program ended with ${code}: ${text}`)));
  });
  return { child, ended, address };
}

test("the page follows a running simulation to its end", async () => {
  rmSync(join(runs, "followed"), { recursive: true, force: true });
  const mission = join(process.env.RETIARIUS_MISSIONS, "hexagon-gravity.toml");
  const until = 'phase[0].until="time >= 100000"';
  const run = start("run", mission, "--out", "followed", "--threads", "1", "--live", "--set", until);
  const browser = await openBrowser();
  try {
    const { page, complaints, requests } = await openPage(browser, await run.address);
    assert.match(await page.innerText(".outcome"), /Running/);
    const count = () => page.evaluate(() => window.retiarius.times().length);
    const first = await count();
    await page.waitForFunction((n) => window.retiarius.times().length > n + 2, first);
    run.child.kill("SIGINT");
    await page.waitForFunction(
      () => document.querySelector(".outcome b").textContent === "Interrupted",
    );
    assert.equal(await run.ended, 4);
    assert.ok((await variety(page))[0] > 100);
    await page.screenshot({ path: join(pictures, "follow.png") });
    const host = new URL(await run.address).host;
    assert.deepEqual(requests.filter((url) => new URL(url).host !== host), []);
    assert.deepEqual(complaints.filter((text) => !/status of (404|416)/.test(text)), []);
  } finally {
    await browser.close();
    run.child.kill("SIGKILL");
  }
});

test("`retiarius view` shows a run that has ended", async () => {
  const view = start("view", "drop");
  const browser = await openBrowser();
  try {
    const { page } = await openPage(browser, await view.address);
    await page.waitForFunction(
      () => document.querySelector(".outcome b").textContent === "Finished",
    );
    assert.match(await page.innerText(".tables"), /Measures of the whole run/);
    view.child.kill("SIGINT");
    assert.equal(await view.ended, 0);
  } finally {
    await browser.close();
    view.child.kill("SIGKILL");
  }
});
