// Exported scenes checked by Khronos's validator, of which no error and no warning is accepted.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { test } from "node:test";
import { runs } from "./setting.mjs";

const require = createRequire(join(process.env.RETIARIUS_VIEWER_SOURCE, "package.json"));
const { validateBytes } = require("gltf-validator");

for (const run of ["drop", "shot-45"])
  test(`${run}.glb is valid glTF with an animation`, async () => {
    const bytes = new Uint8Array(readFileSync(join(runs, `${run}.glb`)));
    const { issues, info } = await validateBytes(bytes, { maxIssues: 20 });
    const text = JSON.stringify(issues.messages, null, 1);
    assert.equal(issues.numErrors, 0, text);
    assert.equal(issues.numWarnings, 0, text);
    assert.equal(info.version, "2.0");
    assert.equal(info.animationCount, 1);
    assert.ok(info.hasSkins);
  });

test("the validator finds what is wrong", async () => {
  const bytes = new Uint8Array(readFileSync(join(runs, "drop.glb"))).slice(0, -8);
  const { issues } = await validateBytes(bytes);
  assert.ok(issues.numErrors > 0);
});
