// The core in node: the same bits as natively, exact predicates, and nonsense that leaves it alive.
// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { built, goldenHashes, loadPage, root } from "./load.mjs";

const soak = Number(process.env.SIGHTLINE_SOAK ?? 1);
/// Emscripten 3.1.6 knows no node that has `fetch`.
const program = (name, ...words) =>
  spawnSync(process.execPath, ["--no-experimental-fetch", join(built, name), ...words], { encoding: "utf8" });

test("every scene, tessellation, method and setting of the list of hashes has the bits that it has natively", () => {
  const { stdout, stderr, status } = program("web_golden_hashes.js", join(root, "tests/files/golden_hashes.txt"));
  assert.equal(stdout + stderr, "");
  assert.equal(status, 0);
});

test("predicates agree with exact rationals where inputs are next to degenerate", () => {
  const { stdout, status } = program("web_predicates.js", String(100_000 * Math.min(soak, 10)));
  assert.match(stdout, /: 0 wrong, 0 not rounded to nearest\n$/);
  assert.equal(status, 0);
});

const page = await loadPage();

test("the page tests its predicates when it starts", () => {
  assert.equal(page.text("self_test", 2000), "");
});

test("runs on the page end in the states of the list of hashes", () => {
  let seen = 0, met = 0;
  for (const [key, { state, steps }] of goldenHashes()) {
    const [dimension, scene, cells, method, ...more] = key.split(" ");
    if (dimension !== "2d" || cells === "boxes" || more.length > 0 || ["jungle", "fog"].includes(scene)) continue;
    if (met++ % 5 && soak === 1) continue;
    page.json("open", scene);
    page.json("do", `set tessellation=${cells}; method ${method}; budget unlimited; run`);
    const look = page.json("look");
    if (look.method !== method) continue;
    assert.deepEqual({ state: page.text("hash"), steps: look.position }, { state, steps }, key);
    ++seen;
  }
  assert.ok(seen > 20, `only ${seen} runs`);
});

test("steps go forward and back, and words are those of the core", () => {
  page.json("open", "bottleneck");
  const start = page.text("hash");
  page.json("do", "set penalty=none; step 7");
  assert.match(page.json("look").step, /^Step 7 took cell 26 \(0\.274\)\. Next was 13 \(0\.301\)\./);
  const there = page.text("hash");
  page.json("do", "back 7");
  assert.equal(page.json("look").position, 0);
  page.json("do", "step 7");
  assert.equal(page.text("hash"), there);
  page.json("do", "seek start");
  assert.equal(page.text("hash"), start);
});

test("a state opens what was shown", () => {
  page.json("open", "streets");
  page.json("do", "step 40; select 12");
  const state = page.text("state"), hash = page.text("hash");
  page.json("open", "bottleneck");
  page.json("open_state", state);
  assert.equal(page.text("hash"), hash);
  assert.equal(page.json("look").selected, 12);
});

test("dragging the eye keeps the step, and taking it back leaves no trace", () => {
  page.json("open", "bottleneck");
  page.json("do", "step 5");
  const before = page.text("hash"), [x, y] = page.json("look").eye;
  page.text("picture", 0, 800, 600, 1);
  assert.equal(page.call("take", x, y, 0.5), 1);
  page.json("drag", x + 1, y + 0.5);
  assert.notEqual(page.text("hash"), before);
  assert.equal(page.json("look").position, 5);
  page.json("let_go", 1);
  assert.equal(page.text("hash"), before);
});

test("lists lie in memory as the page reads them", () => {
  page.json("open", "bottleneck");
  page.json("do", "step 3");
  const picture = page.json("picture", 0, 800, 600, 1);
  const { buffer } = page.module.HEAPU8;
  const kinds = new Set();
  for (const list of picture.lists) {
    const points = new Float64Array(buffer, list.points, 2 * list.pointCount);
    assert.ok(points.every(Number.isFinite));
    const words = new Uint32Array(buffer, list.shapes, list.shapeCount * 6);
    const bytes = new Uint8Array(buffer, list.shapes);
    let next = 0;
    for (let i = 0; i < list.shapeCount; ++i) {
      kinds.add(bytes[24 * i]);
      assert.equal(words[6 * i + 1], next);
      next += words[6 * i + 2];
    }
    assert.equal(next, list.pointCount);
  }
  assert.ok(kinds.has(0) && kinds.has(1));
});

/// Some bytes changed, a piece doubled, taken out or put elsewhere, a number made another, or the end cut off.
function mutated(good, random) {
  let bytes = Buffer.from(good);
  for (let k = 1 + random(3); k > 0 && bytes.length > 1; --k) {
    const at = random(bytes.length), size = Math.min(1 + random(40), bytes.length - at), to = random(bytes.length);
    const piece = Buffer.from(bytes.subarray(at, at + size)), rest = [bytes.subarray(0, at), bytes.subarray(at + size)];
    switch (random(6)) {
      case 0: bytes[at] = random(256); break;
      case 1: bytes = Buffer.concat([bytes.subarray(0, to), piece, bytes.subarray(to)]); break;
      case 2: bytes = Buffer.concat(rest); break;
      case 3: bytes = bytes.subarray(0, at); break;
      case 4: bytes[at] ^= 1 << random(8); break;
      default: {
        const numbers = ["-1", "1e999", "1e-320", "4294967296", "nan", "0", "9".repeat(20), "1e150", "null", "{}"];
        const digit = bytes.subarray(at).findIndex(c => c >= 48 && c <= 57);
        if (digit >= 0)
          bytes = Buffer.concat([bytes.subarray(0, at + digit), Buffer.from(numbers[random(numbers.length)]),
                                 bytes.subarray(at + digit + 1)]);
      }
    }
  }
  return bytes;
}

test("nonsense in files is refused in a line, and the page lives on", t => {
  const sources = ["examples/scenes/gallery.json", "examples/scenes/quarter.geojson", "examples/lesson/04-penalty.json",
                   "examples/states/gallery-transfer.json", "examples/states/coorg-teller/convex.obj"]
    .map(file => [file.replace(/^.*\./, "."), readFileSync(join(root, file))]);
  const buffer = Buffer.from(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]).buffer).toString("base64");
  sources.push([".gltf", Buffer.from(JSON.stringify({
    asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0, translation: [1, 2, 3] }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: "VEC3" }],
    bufferViews: [{ buffer: 0, byteLength: 36 }],
    buffers: [{ byteLength: 36, uri: `data:application/octet-stream;base64,${buffer}` }],
  }))]);
  const cube = ["solid a", "facet normal 0 0 1", "outer loop", "vertex 0 0 0", "vertex 1 0 0", "vertex 0 1 0",
                "endloop", "endfacet", "endsolid a", ""].join("\n");
  const ply = ["ply", "format ascii 1.0", "element vertex 3", "property float x", "property float y",
               "property float z", "element face 1", "property list uchar int vertex_indices", "end_header",
               "0 0 0", "1 0 0", "0 1 0", "3 0 1 2", ""].join("\n");
  const wad = Buffer.concat([Buffer.from("PWAD"), Buffer.from([5, 0, 0, 0, 12, 0, 0, 0]), Buffer.alloc(80, 7)]);
  sources.push([".stl", Buffer.from(cube)], [".off", Buffer.from("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")],
               [".ply", Buffer.from(ply)], [".wad", wad]);
  let seed = 1;
  const random = below => (seed = (seed * 48271) % 2147483647) % below;
  const count = Number(process.env.SIGHTLINE_MUTATIONS ?? 1000), kinds = new Map();
  let opened = 0, refused = 0;
  page.json("open", "bottleneck");
  for (let i = 0; i < count; ++i) {
    const [ending, good] = sources[i % sources.length], name = "dropped" + ending;
    page.FS.writeFile("/files/" + name, mutated(good, random));
    const answer = page.json("open", name);  // throws where the core traps
    const one = kinds.get(ending) ?? kinds.set(ending, { opened: 0, refused: 0 }).get(ending);
    if (answer.error) {
      ++refused;
      ++one.refused;
      assert.ok(answer.error.length < 1500 && !answer.error.includes("\n"), answer.error);
      assert.ok(answer.error.includes(name), answer.error);
    } else {
      ++opened;
      ++one.opened;
    }
  }
  t.diagnostic(`${opened} opened, ${refused} refused: ${JSON.stringify([...kinds])}`);
  assert.ok(opened > 0);
  for (const [ending, { refused }] of kinds) assert.ok(refused > 0, ending);
  page.json("open", "bottleneck");
  page.json("do", "step 7");
  assert.equal(page.json("look").position, 7);
});
