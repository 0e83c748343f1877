// report.html of real runs in a real browser.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { join } from "node:path";
import { openBrowser, openPage } from "./browser.mjs";
import { ofFrame, pageOf, pictures, slide, table, variety } from "./setting.mjs";

let browser;
let page, complaints, requests;
const url = pageOf("drop/report.html");

before(async () => {
  browser = await openBrowser();
  ({ page, complaints, requests } = await openPage(browser, url));
});
after(() => browser?.close());

test("opens from a file without complaint and asks nobody for anything", async () => {
  assert.equal(await page.getAttribute("html", "data-ready"), "yes");
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests, [url]);
  const blocked = await page.evaluate(() =>
    fetch("https://example.org").then(
      () => "let through",
      () => "blocked",
    ),
  );
  assert.equal(blocked, "blocked");
  while (complaints.length === 0) await page.waitForTimeout(20);
  for (const complaint of complaints.splice(0))
    assert.match(complaint, /Content Security Policy|Refused to connect|Fetch API cannot load/);
});

test("tells the outcome in words before anything else", async () => {
  const first = await page.evaluate(
    () => document.querySelector("main").firstElementChild.innerText,
  );
  assert.match(first, /Finished/);
  assert.match(first, /Peak tension/i);
  const tables = await page.innerText(".tables");
  for (const text of ["Measures of the whole run", "Phases", "Versions", "Compiler", "Seed"])
    assert.ok(tables.includes(text), text);
  assert.ok((await page.textContent(".tables")).includes('pattern = "'), "the mission's text");
});

test("the slider puts the nodes where run.h5 has them", async () => {
  const nodes = table("drop", "nodes.csv");
  const times = await page.evaluate(() => window.retiarius.times());
  const error = await page.evaluate(() => window.retiarius.app.views[0].run.recording.header.error);
  const size = await page.evaluate(() => window.retiarius.app.views[0].run.recording.header.size);
  assert.ok(error < 1e-4 * size, "the stated error");
  assert.equal(times.length, nodes.frame.at(-1) + 1);
  for (const frame of [0, 1, Math.floor(times.length / 2), times.length - 2, times.length - 1]) {
    await slide(page, times[frame]);
    const there = ofFrame(nodes, frame);
    assert.equal(there.time[0], times[frame]);
    for (let node = 0; node < there.node.length; node += 7) {
      const seen = await page.evaluate((n) => window.retiarius.node(n), node);
      // Positions reach the graphics card in single precision.
      const limit = error * (1 + 1e-6) + 2e-7 * Math.max(...seen.map(Math.abs));
      ["x", "y", "z"].forEach((axis, k) =>
        assert.ok(
          Math.abs(seen[k] - there[axis][node]) <= limit,
          `node ${node} at frame ${frame}: ${seen[k]} for ${there[axis][node]}`,
        ),
      );
    }
  }
  const [a, b] = [times[3], times[4]];
  await slide(page, 0.5 * (a + b));
  const between = await page.evaluate(() => window.retiarius.node(5)[2]);
  const [za, zb] = [ofFrame(nodes, 3).z[5], ofFrame(nodes, 4).z[5]];
  assert.ok(Math.abs(between - 0.5 * (za + zb)) <= error * 1.001, "half way between two frames");
});

test("values, colours and legend agree", async () => {
  const segments = table("drop", "segments.csv");
  const times = await page.evaluate(() => window.retiarius.times());
  const frame = times.length - 1;
  await slide(page, times[frame]);
  const there = ofFrame(segments, frame);
  for (const quantity of ["tension", "strain"]) {
    await page.evaluate((q) => window.retiarius.colourBy(q), quantity);
    const legend = await page.evaluate(() => ({
      title: document.querySelector(".legend .title").textContent,
      marks: [...document.querySelectorAll(".legend .marks span")].map((m) => m.textContent),
      stops: getComputedStyle(document.querySelector(".legend .bar"))
        .backgroundImage.match(/rgb\([^)]*\)/g)
        .map((c) => c.match(/\d+/g).map(Number)),
      range: window.retiarius.app.store.now.range,
    }));
    assert.match(legend.title, quantity === "tension" ? /^Tension \/ N$/ : /^Strain$/);
    assert.equal(Number(legend.marks[0]), legend.range.low);
    assert.equal(
      Number(legend.marks[2].replace(/·10⁻(.)/, (_, d) => `e-${"⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(d)}`)),
      legend.range.high,
    );
    const quantum = await page.evaluate(
      (q) =>
        window.retiarius.app.views[0].run.recording.header.channels.find((c) => c.name === q).scale
          .quantum,
      quantity,
    );
    for (let s = 0; s < there.segment.length; s += 5) {
      const seen = await page.evaluate((k) => window.retiarius.segment(k), s);
      const true_ = there[quantity][s];
      const share = quantity === "tension" ? 256 : 128; // the errors that docs/viewer.md states
      assert.ok(
        Math.abs(seen.value - true_) <= Math.max(0.5 * quantum, Math.abs(true_) / share) * 1.0001,
        `${quantity} ${s}`,
      );
      const t = Math.min(
        1,
        Math.max(0, (true_ - legend.range.low) / (legend.range.high - legend.range.low)),
      );
      const place = t * (legend.stops.length - 1);
      const [low, high] = [legend.stops[Math.floor(place)], legend.stops[Math.ceil(place)]];
      seen.colour.forEach((c, k) => {
        const shown = low[k] + (place % 1) * (high[k] - low[k]);
        assert.ok(Math.abs(c - shown) <= 6, `colour of ${quantity} ${s}: ${c} for ${shown}`);
      });
    }
  }
  await page.evaluate(() => window.retiarius.colourBy("tension"));
});

test("threads are drawn in the colour of their value", async () => {
  const found = await page.evaluate(async () => {
    const r = window.retiarius;
    await r.seek(r.times().at(-1));
    r.app.store.set({ follow: "net" });
    r.app.look("oblique");
    r.app.store.set({ follow: "nothing" });
    await r.seek(r.times().at(-1));
    const canvas = document.querySelector(".stage canvas");
    const copy = document.createElement("canvas");
    copy.width = canvas.width;
    copy.height = canvas.height;
    const context = copy.getContext("2d", { willReadFrequently: true });
    context.drawImage(canvas, 0, 0);
    const ratio = canvas.width / canvas.getBoundingClientRect().width;
    const results = [];
    const count = r.app.views[0].run.recording.header.segments;
    for (let s = 0; s < count; s += 3) {
      const [a, b] = r.ends(s).map((n) => r.onScreen(n));
      if (!a || !b || Math.hypot(a[0] - b[0], a[1] - b[1]) < 8) continue;
      const picked = r.pick(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]));
      if (picked?.kind !== "segment" || picked.index !== s) continue;
      const x = Math.round(0.5 * (a[0] + b[0]) * ratio) - 2;
      const y = Math.round(0.5 * (a[1] + b[1]) * ratio) - 2;
      const { data } = context.getImageData(x, y, 5, 5);
      const { colour } = r.segment(s);
      let best = Infinity;
      for (let k = 0; k < data.length; k += 4) {
        if (data[k + 3] < 250) continue;
        // Light darkens all three alike, to no less than 0.75.
        const light = Math.min(
          1,
          Math.max(
            0.75,
            (data[k] + data[k + 1] + data[k + 2]) / (colour[0] + colour[1] + colour[2]),
          ),
        );
        best = Math.min(best, Math.max(...colour.map((c, i) => Math.abs(data[k + i] - light * c))));
      }
      results.push(best);
    }
    return results;
  });
  assert.ok(found.length > 20, `only ${found.length} segments to look at`);
  const good = found.filter((d) => d <= 14).length;
  assert.ok(good / found.length > 0.9, `${good} of ${found.length} in the right colour`);
});

test("a click shows the history of the right segment and node", async () => {
  const times = await page.evaluate(() => window.retiarius.times());
  await slide(page, times[0]);
  await page.click("button:text-is('top')");
  await page.evaluate(() => window.retiarius.seek(0));
  const box = await page.locator(".stage canvas").boundingBox();
  const segments = table("drop", "segments.csv");
  for (const segment of [10, 57, 101]) {
    const [x, y] = await page.evaluate((s) => {
      const [a, b] = window.retiarius.ends(s).map((n) => window.retiarius.onScreen(n));
      return [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
    }, segment);
    await page.mouse.click(box.x + x, box.y + y);
    await page.waitForSelector(".probe .chart");
    assert.equal(await page.innerText(".probe h3"), `Segment ${segment}`);
    const last = times.length - 1;
    await slide(page, times[last]);
    const shown = Number((await page.innerText(".probe .key b")).replace("\u2212", "-"));
    const true_ = ofFrame(segments, last).tension[segment];
    assert.ok(
      Math.abs(shown - true_) <= 0.005 * Math.abs(true_) + 1e-3,
      `tension ${shown} for ${true_}`,
    );
    await slide(page, times[0]);
  }
  const corner = await page.evaluate(
    () => window.retiarius.app.views[0].run.recording.header.corners[1],
  );
  const [x, y] = await page.evaluate((n) => window.retiarius.onScreen(n), corner);
  await page.mouse.click(box.x + x, box.y + y);
  await page.waitForFunction(
    (n) => document.querySelector(".probe h3")?.innerText === `Node ${n}`,
    corner,
  );
  assert.match(await page.innerText(".probe"), /corner 1/);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(".probe").isVisible(), false);
});

test("plays, steps and answers the keyboard", async () => {
  const times = await page.evaluate(() => window.retiarius.times());
  const now = () => page.evaluate(() => window.retiarius.app.store.now.time);
  await page.keyboard.press("Home");
  await page.keyboard.press(".");
  assert.equal(await now(), times[1]);
  await page.keyboard.press(",");
  assert.equal(await now(), times[0]);
  await page.keyboard.press(" ");
  await page.waitForFunction((t) => window.retiarius.app.store.now.time > t, times[1]);
  await page.keyboard.press(" ");
  await page.keyboard.press("End");
  assert.equal(await now(), times.at(-1));
  await page.keyboard.press("?");
  assert.match(await page.innerText("dialog[open]"), /one frame back/);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("dialog[open]").count(), 0);
});

test("one draw call shows all threads", async () => {
  const calls = await page.evaluate(() => {
    const { stage } = window.retiarius.app.views[0];
    stage.parts(false, false, false);
    stage.bodies.group.visible = false;
    stage.touch();
    stage.draw();
    const { calls } = stage;
    stage.bodies.group.visible = true;
    stage.parts(false, true, false);
    return calls;
  });
  assert.equal(calls, 1);
});

test("contact is shown where nodes touch", async () => {
  const times = await page.evaluate(() => window.retiarius.times());
  await page.evaluate(() => window.retiarius.colourBy("contact"));
  await slide(page, times.at(-1));
  const touching = await page.evaluate(() => {
    const { instant } = window.retiarius.app.views[0].stage;
    let count = 0;
    for (let n = 0; n < instant.header.nodes; ++n) if (instant.nodes[4 * n + 3] > 0) ++count;
    return count;
  });
  const contacts = table("drop", "history.csv").contacts;
  assert.equal(touching, contacts.at(-1));
  assert.ok(touching > 0);
  assert.match(await page.innerText(".legend"), /sticks/);
  await page.evaluate(() => window.retiarius.colourBy("tension"));
});

test("is readable at any size, in light and dark, and pictures are not blank", async () => {
  for (const [size, viewport] of Object.entries({
    desktop: { width: 1440, height: 900 },
    phone: { width: 390, height: 844 },
  }))
    for (const theme of ["light", "dark"]) {
      const opened = await openPage(browser, url, { viewport, theme, touch: size === "phone" });
      const times = await opened.page.evaluate(() => window.retiarius.times());
      await slide(opened.page, times.at(-1));
      assert.equal(await opened.page.getAttribute("html", "data-theme"), theme);
      const width = await opened.page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(width <= viewport.width, `${width} pixels wide on ${viewport.width}`);
      const [colours, most] = await variety(opened.page);
      assert.ok(colours > 200 && most < 0.99, `${size} ${theme}: ${colours} colours, ${most}`);
      await opened.page.screenshot({ path: join(pictures, `replay-${size}-${theme}.png`) });
      await opened.page.screenshot({
        path: join(pictures, `replay-${size}-${theme}-whole.png`),
        fullPage: true,
      });
      assert.deepEqual(opened.complaints, []);
      await opened.context.close();
    }
});

test("the switch turns light to dark", async () => {
  const before = await page.getAttribute("html", "data-theme");
  await page.click(".corner button:first-child");
  assert.notEqual(await page.getAttribute("html", "data-theme"), before);
  assert.deepEqual(complaints, []);
});
