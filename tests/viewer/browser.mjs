// A browser without display for the tests, with WebGL in software.
import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const require = createRequire(join(process.env.RETIARIUS_VIEWER_SOURCE, "package.json"));
const { chromium } = require("playwright-core");

export function chromiumPath() {
  const path = process.env.RETIARIUS_CHROMIUM ?? "/usr/bin/chromium";
  if (!existsSync(path)) throw new Error(`there is no browser ${path}`);
  return path;
}

export async function openBrowser() {
  return chromium.launch({
    executablePath: chromiumPath(),
    args: [
      "--no-sandbox",
      "--headless=new",
      "--use-angle=swiftshader",
      "--enable-unsafe-swiftshader",
      "--ignore-gpu-blocklist",
      "--disable-background-networking",
      "--no-first-run",
    ],
  });
}

/** Opens a page and notes everything that it must not do. */
export async function openPage(browser, url, options = {}) {
  const context = await browser.newContext({
    viewport: options.viewport ?? { width: 1440, height: 900 },
    colorScheme: options.theme ?? "dark",
    hasTouch: options.touch ?? false,
    deviceScaleFactor: options.scale ?? 1,
  });
  const page = await context.newPage();
  const complaints = [];
  const requests = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("request", (request) => requests.push(request.url()));
  await page.goto(url);
  await page.waitForSelector("html[data-ready]", { timeout: options.timeout ?? 120000 });
  return { page, context, complaints, requests };
}
