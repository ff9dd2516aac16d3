// The core of the page in node, as the page has it: module and calls, without a browser.
// SPDX-License-Identifier: GPL-3.0-or-later
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

export const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
export const built = resolve(process.env.SIGHTLINE_WEB_BUILD ?? join(root, "build/web"));

export async function loadPage() {
  const wasmBinary = readFileSync(join(built, "sightline.wasm"));
  const make = createRequire(import.meta.url)(join(built, "sightline.js"));
  const module = await make({ wasmBinary, print() {}, printErr() {} });
  const { FS } = module;
  FS.mkdirTree("/examples");
  FS.writeFile("/examples/lessons.json", readFileSync(join(root, "examples/lessons.json")));
  FS.mkdirTree("/files");
  FS.chdir("/files");
  const page = module._page_new();
  const call = (name, ...values) => {
    const taken = [];
    const given = values.map(value => {
      if (typeof value !== "string") return value;
      const size = module.lengthBytesUTF8(value) + 1, at = module._malloc(size);
      module.stringToUTF8(value, at, size);
      taken.push(at);
      return at;
    });
    const result = module[`_page_${name}`](page, ...given);
    taken.forEach(module._free);
    return result;
  };
  const text = (name, ...values) => module.UTF8ToString(call(name, ...values));
  const json = (name, ...values) => JSON.parse(text(name, ...values));
  return { module, FS, call, text, json };
}

/// What the list of hashes says: "2d bottleneck delaunay published" -> { state, steps } of the unlimited run.
export function goldenHashes() {
  const all = new Map();
  for (const line of readFileSync(join(root, "tests/files/golden_hashes.txt"), "utf8").split("\n")) {
    const found = /^(.*): 5% \w+ after \d+, unlimited (\w+) after (\d+)$/.exec(line);
    if (found) all.set(found[1], { state: found[2], steps: Number(found[3]) });
  }
  return all;
}
