// Puts the page together: node web/build.mjs BUILD OUT makes OUT/sightline.html, one file with everything in it, and
// OUT/web/, the same as files to host.
// SPDX-License-Identifier: GPL-3.0-or-later
import { build, transform } from "esbuild";
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
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
      if (statSync(file).isFile() && /\.(json|geojson|obj)$/.test(name)) files.push([`/examples/${folder}/${name}`, read(file)]);
    }
  return files.map(([name, bytes]) => [name, name.endsWith("json") ? Buffer.from(JSON.stringify(JSON.parse(bytes))) : bytes]);
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
      if (lump.name === "SIDEDEFS") data = textureless(data);
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
/// Offsets and names of textures say nothing about walls.
function textureless(sides) {
  for (let at = 0; at + 30 <= sides.length; at += 30) sides.fill(0, at, at + 28);
  return sides;
}

const doom = "/usr/share/games/doom";
const files = examples();
for (const [game, wanted] of [["freedoom1", ["E1M2"]], ["freedoom2", ["MAP07"]]])
  if (existsSync(`${doom}/${game}.wad`)) files.push([`${doom}/${game}.wad`, levels(`${doom}/${game}.wad`, wanted)]);

const wasm = read(join(buildFolder, "sightline.wasm"));
const parts = [["core", wasm], ...files];
const table = Buffer.from(JSON.stringify(parts.map(([name, bytes]) => ({ name, size: bytes.length }))));
const length = Buffer.alloc(4);
length.writeUInt32LE(table.length);
const payload = gzipSync(Buffer.concat([length, table, ...parts.map(([, bytes]) => bytes)]), { level: 9 });

const licence = `Sightline, a visual lab for occlusion culling. Free software under the GNU General Public License, ` +
  `version 3 or later, without any warranty. This page holds the program itself; its source comes with it from where ` +
  `you got it, as the licence asks.\n\nIt contains CGAL (GPL-3.0-or-later and LGPL-3.0-or-later), Boost (BSL-1.0), ` +
  `GLM and nlohmann/json (MIT), and the run-time library of Emscripten (MIT and NCSA).` +
  (files.some(([name]) => name.startsWith(doom)) ? `\n\nThe levels are from Freedoom, copyright its contributors ` +
    `(BSD licence: redistribution with or without modification is permitted with this notice, without warranty).` : "");

const bundle = await build({
  entryPoints: [join(here, "page/main.ts")], bundle: true, minify: true, format: "iife", target: "es2020", write: false,
  legalComments: "none", define: { licence: JSON.stringify(licence) },
});
const glue = (await transform(read(join(buildFolder, "sightline.js")).toString(), { minify: true })).code;
const style = (await transform(read(join(here, "page/style.css")).toString(), { loader: "css", minify: true })).code;
const script = (glue + "\n" + bundle.outputFiles[0].text);
const page = read(join(here, "page/index.html")).toString();
const put = (text, mark, value) => text.replace(`<!--${mark}-->`, () => value);
const inline = text => text.replaceAll("</script", "<\\/script");

let single = put(page, "style", `<style>${style}</style>`);
single = put(single, "payload", `<script type="application/octet-stream" id="payload">${payload.toString("base64")}</script>`);
single = put(single, "script", `<script>${inline(script)}</script>`);
let hosted = put(page, "style", `<link rel="stylesheet" href="page.css">`);
hosted = put(hosted, "payload", "");
hosted = put(hosted, "script", `<script src="page.js" defer></script>`);
mkdirSync(join(outFolder, "web"), { recursive: true });
writeFileSync(join(outFolder, "sightline.html"), single);
for (const [name, content] of [["index.html", hosted], ["page.css", style], ["page.js", script], ["payload.gz", payload]])
  writeFileSync(join(outFolder, "web", name), content);
const kb = bytes => `${Math.round(bytes / 1024)} KiB`;
console.log(`${join(outFolder, "sightline.html")}: ${kb(single.length)} (core ${kb(wasm.length)}, packed with ` +
            `${files.length} files to ${kb(payload.length)}); ${join(outFolder, "web")}/: the same as files to host`);
await writeArticle({ outFolder, glue, payload, licence });
