// node build.mjs OUT: installs the packages of package-lock.json where that has changed, builds the
// page, and writes OUT/viewer_bundle.cpp, which holds it compressed. Called by CMake.
import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { deflateSync } from "node:zlib";
import { templateOf } from "./template.mjs";

const viewer = dirname(dirname(fileURLToPath(import.meta.url)));
const out = resolve(process.argv[2] ?? join(viewer, "dist"));

function fail(...lines) {
  for (const line of lines) process.stderr.write(`viewer: ${line}\n`);
  process.exit(1);
}

function run(command, args) {
  const result = spawnSync(command, args, { cwd: viewer, encoding: "utf8" });
  return {
    ok: result.status === 0,
    text: `${result.stdout ?? ""}${result.stderr ?? ""}${result.error ?? ""}`,
  };
}

function install() {
  const lock = createHash("sha256")
    .update(readFileSync(join(viewer, "package-lock.json")))
    .digest("hex");
  const stamp = join(viewer, "node_modules", ".retiarius-lock");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === lock) return;
  const { ok, text } = run("npm", ["ci", "--no-audit", "--no-fund"]);
  if (!ok)
    fail(
      text.trim(),
      "npm ci could not install the packages of viewer/package-lock.json; its messages are above.",
      "Where no npm registry can be reached, configure with -DRETIARIUS_VIEWER=OFF: reports are then without the 3D replay.",
    );
  writeFileSync(stamp, lock);
}

function build() {
  const vite = join(viewer, "node_modules", "vite", "bin", "vite.js");
  const { ok, text } = run(process.execPath, [
    vite,
    "build",
    "--outDir",
    join(out, "page"),
    "--logLevel",
    "warn",
  ]);
  if (!ok) fail(text.trim(), "the viewer could not be built; the messages are above");
}

function embed() {
  const page = Buffer.from(templateOf(readFileSync(join(out, "page", "index.html"), "utf8")));
  const bytes = deflateSync(page, { level: 9 });
  const lines = [];
  for (let k = 0; k < bytes.length; k += 24)
    lines.push(`${[...bytes.subarray(k, k + 24)].join(",")},`);
  writeFileSync(join(out, "page", "template.html"), page);
  writeFileSync(
    join(out, "viewer_bundle.cpp"),
    `// Made by viewer/scripts/build.mjs.\n#include "retiarius/report/viewer_bundle.hpp"\n\nnamespace retiarius {\n\n` +
      `const unsigned char kViewerBundle[] = {\n${lines.join("\n")}\n};\n` +
      `const std::size_t kViewerBundleSize = ${bytes.length};\n\n}  // namespace retiarius\n`,
  );
}

install();
build();
embed();
