// Puts the page together: node web/build.mjs BUILD OUT makes OUT/sightline.html, one file with everything in it, and
// OUT/web/, the same as files to host.
// SPDX-License-Identifier: GPL-3.0-or-later
import { spawnSync } from "node:child_process";
import { build, transform } from "esbuild";
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { writeArticle } from "./article/build.mjs";

const [buildFolder, outFolder] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url)), root = dirname(here);
const read = file => readFileSync(file);

/// Lessons and what they open, as the core looks for them.
function examples() {
  const files = [["/examples/lessons.json", read(join(root, "examples/lessons.json"))]];
  for (const folder of ["lesson", "scenes", "states", "states/coorg-teller"])
    for (const name of readdirSync(join(root, "examples", folder)).sort()) {
      const file = join(root, "examples", folder, name);
      if (statSync(file).isFile() && /\.(json|geojson|obj)$/.test(name))
        files.push([`/examples/${folder}/${name}`, read(file)]);
    }
  const small = bytes => Buffer.from(JSON.stringify(JSON.parse(bytes)));
  return files.map(([name, bytes]) => [name, name.endsWith("json") ? small(bytes) : bytes]);
}

/// Of a WAD file no more than the walls of these levels and where the player stands.
function levels(wad, wanted) {
  const bytes = read(wad), count = bytes.readUInt32LE(4), start = bytes.readUInt32LE(8);
  const lumps = Array.from({ length: count }, (_, i) => ({
    at: bytes.readUInt32LE(start + 16 * i), size: bytes.readUInt32LE(start + 16 * i + 4),
    name: bytes.toString("latin1", start + 16 * i + 8, start + 16 * i + 16).replace(/\0.*$/, ""),
  }));
  const kept = [];
  for (const level of wanted) {
    const first = lumps.findIndex(lump => lump.name === level);
    if (first < 0) throw new Error(`${wad} has no level ${level}`);
    kept.push({ name: level, data: Buffer.alloc(0) });
    for (const lump of lumps.slice(first + 1, first + 5)) {
      let data = Buffer.from(bytes.subarray(lump.at, lump.at + lump.size));
      if (lump.name === "THINGS") data = records(data, 10, thing => thing.readUInt16LE(6) === 1);
      if (lump.name === "LINEDEFS") data = records(data, 14, line => line.fill(0, 6, 10));
      if (lump.name === "SIDEDEFS") data = records(data, 30, side => side.fill(0, 0, 28));
      kept.push({ name: lump.name, data });
    }
  }
  const header = Buffer.alloc(12), directory = Buffer.alloc(16 * kept.length);
  header.write("PWAD");
  header.writeUInt32LE(kept.length, 4);
  let at = 12;
  kept.forEach((lump, i) => {
    directory.writeUInt32LE(at, 16 * i);
    directory.writeUInt32LE(lump.data.length, 16 * i + 4);
    directory.write(lump.name, 16 * i + 8, "latin1");
    at += lump.data.length;
  });
  header.writeUInt32LE(at, 8);
  return Buffer.concat([header, ...kept.map(lump => lump.data), directory]);
}
/// Those of which `keep` says so; it also blots out what says nothing about walls.
function records(lump, size, keep) {
  const all = Array.from({ length: lump.length / size }, (_, i) => lump.subarray(i * size, (i + 1) * size));
  return Buffer.concat(all.filter(keep));
}

const doom = "/usr/share/games/doom";
const files = examples();
for (const [game, wanted] of [["freedoom1", ["E1M2"]], ["freedoom2", ["MAP07"]]])
  if (existsSync(`${doom}/${game}.wad`)) files.push([`${doom}/${game}.wad`, levels(`${doom}/${game}.wad`, wanted)]);

/// Where the source is for those who have the page alone: what SIGHTLINE_SOURCE says, or where the checkout came from.
function source() {
  const asked = process.env.SIGHTLINE_SOURCE;
  if (asked) return asked;
  const { stdout } = spawnSync("git", ["-C", root, "remote", "get-url", "origin"], { encoding: "utf8" });
  return /^https:\/\/[^@\s]+$/.test(stdout?.trim() ?? "") ? stdout.trim() : "";
}

/// As page/unpack.ts takes it apart: the size unpacked, then what xz makes of it.
function packed(bytes) {
  const { stdout, status, error } = spawnSync("xz", ["--format=raw", "--stdout",
    "--lzma1=preset=9e,lc=4,lp=0,pb=0,nice=273,dict=64MiB"], { input: bytes, maxBuffer: 1 << 30 });
  if (status !== 0) throw error ?? new Error("xz could not pack the page");
  return Buffer.concat([wordOf(bytes.length), stdout]);
}
function wordOf(number) {
  const word = Buffer.alloc(4);
  word.writeUInt32LE(number);
  return word;
}
const bundle = async (entry, define = {}) => (await build({
  entryPoints: [join(here, entry)], bundle: true, minify: true, format: "iife", target: "es2022", write: false,
  legalComments: "none", define,
})).outputFiles[0].text;

const sourceLink = source();
const licence = `Sightline, a visual lab for occlusion culling. Free software under the GNU General Public License, ` +
  `version 3 or later, without any warranty. This page holds the program itself; ` +
  (sourceLink ? `its source is at ${sourceLink}.`
              : `its source comes with it from where you got it, as the licence asks.`) +
  `\n\nIt contains CGAL (GPL-3.0-or-later and LGPL-3.0-or-later), Boost (BSL-1.0), ` +
  `GLM and nlohmann/json (MIT), and the run-time library of Emscripten (MIT and NCSA).` +
  (files.some(([name]) => name.startsWith(doom)) ? `\n\nThe levels are from Freedoom, copyright its contributors ` +
    `(BSD licence: redistribution with or without modification is permitted with this notice, without warranty).` : "");
const notice = "Sightline is free software, GPL-3.0-or-later, without any warranty: " +
  (sourceLink ? `<a href="${sourceLink.replaceAll("&", "&amp;").replaceAll('"', "&quot;")}">source</a>.`
              : "its source is where you got it.");

const wasm = read(join(buildFolder, "sightline.wasm"));
const glue = (await transform(read(join(buildFolder, "sightline.js")).toString(), { minify: true })).code;
const script = glue + "\n" + await bundle("page/main.ts", { licence: JSON.stringify(licence) });
const style = (await transform(read(join(here, "page/style.css")).toString(), { loader: "css", minify: true })).code;
const parts = [["script", Buffer.from(script)], ["style", Buffer.from(style)], ["core", wasm], ...files];
const table = Buffer.from(JSON.stringify(parts.map(([name, bytes]) => ({ name, size: bytes.length }))));
const payload = packed(Buffer.concat([wordOf(table.length), table, ...parts.map(([, bytes]) => bytes)]));

const { textOfBytes } = await import("data:text/javascript," + encodeURIComponent(
  (await transform(read(join(here, "page/unpack.ts")).toString(), { loader: "ts" })).code));
const boot = await bundle("page/boot.ts");
const put = (text, mark, value) => text.replace(`<!--${mark}-->`, () => value);
const page = put(read(join(here, "page/index.html")).toString(), "notice", notice);

const inside =
  `<script type="text/plain" id="payload" data-size="${payload.length}">${textOfBytes(payload)}</script>`;
let single = put(page, "payload", inside);
single = put(single, "script", `<script>${boot.replaceAll("</script", "<\\/script")}</script>`);
let hosted = put(page, "payload", "");
hosted = put(hosted, "script", `<script src="page.js" defer></script>`);
rmSync(join(outFolder, "web"), { recursive: true, force: true });
mkdirSync(join(outFolder, "web"), { recursive: true });
writeFileSync(join(outFolder, "sightline.html"), single);
const beside = [["index.html", hosted], ["page.js", boot], ["payload.lzma", payload]];
for (const [name, content] of beside) writeFileSync(join(outFolder, "web", name), content);
const kilobytes = bytes => `${Math.round(bytes / 1000)} kB`;
console.log(`${join(outFolder, "sightline.html")}: ${kilobytes(Buffer.byteLength(single))} (core ` +
            `${kilobytes(wasm.length)}, packed with ${files.length} files to ${kilobytes(payload.length)}); ` +
            `${join(outFolder, "web")}/: the same as files to host`);
await writeArticle({ outFolder, glue, inside, licence });
