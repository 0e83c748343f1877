// The page that compares two runs.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { openBrowser, openPage } from "./browser.mjs";
import { pageOf, pictures, slide, table, ofFrame, variety } from "./setting.mjs";

test("runs are replayed side by side at the same instant, with curves on common axes", async () => {
  const browser = await openBrowser();
  try {
    const url = pageOf("comparison.html");
    const { page, complaints, requests } = await openPage(browser, url, { theme: "light" });
    assert.equal(await page.locator(".stage canvas").count(), 2);
    assert.match(await page.innerText("header.top"), /shot-30[\s\S]*shot-45/);
    const times = await page.evaluate(() => window.retiarius.times(0));
    const frame = 20;
    await slide(page, times[frame]);
    for (const [k, run] of ["shot-30", "shot-45"].entries()) {
      const there = ofFrame(table(run, "nodes.csv"), frame);
      assert.equal(there.time[0], times[frame]);
      const error = await page.evaluate(
        (i) => window.retiarius.app.views[i].run.recording.header.error,
        k,
      );
      const seen = await page.evaluate((i) => window.retiarius.node(11, i), k);
      assert.ok(
        Math.abs(seen[0] - there.x[11]) <= error * 1.01,
        `${run}: ${seen[0]} for ${there.x[11]}`,
      );
      const [colours, most] = await variety(page, k);
      assert.ok(colours > 100 && most < 0.995, `${run}: ${colours} colours, ${most}`);
    }
    // These threads go slack: their strains are predicted from tensions, earlier frames and positions.
    await page.evaluate(() => window.retiarius.colourBy("strain"));
    for (const frame of [0, 1, 7, 20, 40]) {
      await slide(page, times[frame]);
      const there = ofFrame(table("shot-30", "segments.csv"), frame);
      const seen = await page.evaluate(
        (n) => Array.from({ length: n }, (_, s) => window.retiarius.segment(s).value),
        there.segment.length,
      );
      seen.forEach((value, s) =>
        assert.ok(
          Math.abs(value - there.strain[s]) <=
            Math.max(5e-8, Math.abs(there.strain[s]) / 128) * 1.0001,
          `strain ${s} at frame ${frame}: ${value} for ${there.strain[s]}`,
        ),
      );
    }
    const key = await page.innerText(".chart:first-of-type .key");
    assert.match(key, /shot-30: projected[\s\S]*shot-45: projected/);
    assert.equal(await page.locator(".tables thead th").nth(1).innerText(), "shot-30");
    // Turning one picture turns the other.
    const box = await page.locator(".stage canvas").first().boundingBox();
    await page.mouse.move(box.x + 200, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 260, box.y + 230);
    await page.mouse.up();
    const cameras = await page.evaluate(() =>
      window.retiarius.app.views.map((v) => v.stage.camera.position.toArray()),
    );
    cameras[0].forEach((c, i) => assert.ok(Math.abs(c - cameras[1][i]) < 1e-9));
    await page.screenshot({ path: join(pictures, "compare-desktop-light.png") });
    assert.deepEqual(complaints, []);
    assert.deepEqual(requests, [url]);
  } finally {
    await browser.close();
  }
});
