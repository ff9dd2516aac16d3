// The page as people use it, in Chromium, offline from a file: keys, mouse and touch at two sizes.
// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { chromium } from "playwright-core";
import { goldenHashes, root } from "./load.mjs";

const executablePath = process.env.SIGHTLINE_CHROMIUM ?? "/usr/bin/chromium";
const page_file = join(root, "out/sightline.html"), pictures = join(root, "out/web-tests");
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const sizes = [{ width: 1280, height: 800, hasTouch: false }, { width: 390, height: 844, hasTouch: true }];

let browser;
before(async () => {
  assert.ok(existsSync(page_file), `${page_file} is missing: ./run web makes it`);
  mkdirSync(pictures, { recursive: true });
  browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
});
after(() => browser?.close());

async function open({ width, height, hasTouch }, hash = "",
                    { file = page_file, url = "file://" + file, ...more } = {}) {
  const context = await browser.newContext({
    viewport: { width, height }, hasTouch, offline: true, acceptDownloads: true, ...more });
  const page = await context.newPage();
  page.errors = [];
  page.on("pageerror", error => page.errors.push(error.message));
  page.on("console", line => { if (line.type() === "error") page.errors.push(line.text()); });
  page.on("request", request => {
    if (!/^(file|blob|data):/.test(request.url()) && !request.url().startsWith(url)) page.errors.push(request.url());
  });
  await page.goto(url + hash);
  await page.waitForSelector("body[data-ready]", { timeout: 60_000 });
  return page;
}
const words = page => page.locator("#step").textContent();
const step = async page => Number(/step (\d+) of/.exec(await page.locator(".where").textContent())[1]);
async function close(page) {
  assert.deepEqual(page.errors, []);
  await page.context().close();
}
const settled = page => page.waitForTimeout(120);
/// Where a point of the scene lies on the screen.
const place = (page, x, y) => page.evaluate(([x, y]) => {
  const box = document.querySelector("#panes canvas").getBoundingClientRect();
  const { world } = window.core.picture(0, Math.round(box.width), Math.round(box.height), 1);
  const scale = box.width / (world[2] - world[0]);
  return [box.left + (x - world[0]) * scale, box.bottom - (y - world[1]) * scale];
}, [x, y]);
const centre = (page, cell) => page.evaluate(cell => {
  const corners = window.core.corners(cell);
  return [0, 1].map(i => corners.reduce((sum, p) => sum + p[i], 0) / corners.length);
}, cell);

for (const size of sizes) {
  const at = `${size.width}x${size.height}`;

  test(`keys walk through the bottleneck at ${at}`, async () => {
    const page = await open(size);
    assert.equal(await step(page), 0);
    for (let i = 0; i < 7; ++i) await page.keyboard.press("ArrowRight");
    await settled(page);
    assert.match(await words(page), /^Step 7 took cell 26 \(0\.274\)\. Next was 13 \(0\.301\)\./);
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("2");
    await settled(page);
    assert.equal(await step(page), 6);
    assert.equal(await page.locator("#tabs [aria-current=true]").textContent(), "Code");
    await page.keyboard.press("End");
    await settled(page);
    assert.equal(await step(page), 16);
    await page.screenshot({ path: join(pictures, `keys-${at}.png`) });
    await close(page);
  });

  test(`buttons, slider and picture by ${size.hasTouch ? "touch" : "mouse"} at ${at}`, async () => {
    const page = await open(size);
    const button = name => page.getByRole("button", { name });
    const press = name => size.hasTouch ? button(name).tap() : button(name).click();
    await press("One step forward");
    await press("One step forward");
    await press("One step back");
    await settled(page);
    assert.equal(await step(page), 1);
    await page.getByRole("slider", { name: "Step of the run" }).fill("7");
    await settled(page);
    assert.match(await words(page), /^Step 7 took cell 26/);
    const [x, y] = await place(page, ...await centre(page, 30));
    size.hasTouch ? await page.touchscreen.tap(x, y) : await page.mouse.click(x, y);
    await settled(page);
    assert.match(await page.locator("#panel").textContent(), /Selected: cell 30, enqueued|Selected segment/);
    await page.screenshot({ path: join(pictures, `pointer-${at}.png`) });
    await close(page);
  });

  test(`the eye is dragged at ${at}`, async () => {
    const page = await open(size);
    for (let i = 0; i < 7; ++i) await page.keyboard.press("ArrowRight");
    const before = await page.evaluate(() => window.core.hash());
    const [x, y] = await place(page, ...await page.evaluate(() => window.core.look().eye));
    if (size.hasTouch) {
      const session = await page.context().newCDPSession(page);
      const touch = (type, at) => session.send("Input.dispatchTouchEvent",
                                               { type, touchPoints: at ? [{ x: at[0], y: at[1] }] : [] });
      await touch("touchStart", [x, y]);
      for (let i = 1; i <= 6; ++i) await touch("touchMove", [x + 3 * i, y + i]);
      await touch("touchEnd");
    } else {
      await page.mouse.move(x, y);
      await page.mouse.down();
      for (let i = 1; i <= 6; ++i) await page.mouse.move(x + 5 * i, y + i);
      await page.mouse.up();
    }
    await settled(page);
    assert.notEqual(await page.evaluate(() => window.core.hash()), before);
    assert.equal(await step(page), 7);
    await close(page);
  });

  test(`the whole first lesson at ${at}`, async () => {
    const page = await open(size);
    const lessons = JSON.parse(readFileSync(join(root, "examples/lessons.json"))).lessons;
    const presses = lessons[0].parts.map(part => part.beats.reduce((sum, beat) => sum + (beat.times ?? 1), 0));
    await page.getByRole("button", { name: "Lessons" }).click();
    await page.locator("dialog .choices button").first().click();
    await page.waitForSelector("#lesson:not([hidden])");
    for (const [part, count] of presses.entries()) {
      const shows = lessons[0].parts[part].beats.at(-1)?.shows ?? [];
      for (let i = 0; i < count; ++i) {
        if (i % 2) await page.keyboard.press("PageDown");
        else await page.getByRole("button", { name: /^Next/ }).click();
      }
      await settled(page);
      const teaching = await page.evaluate(() => window.core.look().teaching);
      assert.equal(teaching.part, part);
      const text = await page.evaluate(() => document.body.textContent + JSON.stringify(window.core.panel("why")));
      for (const words of shows) assert.ok(text.includes(words), `part ${part + 1} does not show "${words}"`);
      if (part === 3) await page.screenshot({ path: join(pictures, `lesson-${at}.png`) });
      if (part + 1 < presses.length) await page.keyboard.press("PageDown");
    }
    assert.doesNotMatch(await page.locator("#said").innerHTML(), /class="bad"/);
    await close(page);
  });

  test(`nothing is cut off or hard to reach at ${at}`, async () => {
    const page = await open(size);
    await page.keyboard.press("ArrowRight");
    await settled(page);
    const wide = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
    const [end, begin] = await page.evaluate(() => [document.querySelector("main").getBoundingClientRect().bottom,
                                                    document.querySelector("footer").getBoundingClientRect().top]);
    assert.ok(begin >= end - 1, `what is said begins at ${begin}, above the end of the page's body at ${end}`);
    assert.ok(await page.evaluate(() => document.querySelector("main").clientHeight) > 300);
    assert.ok(wide[0] <= wide[1], `the page is ${wide[0]} wide in ${wide[1]}`);
    for (const scheme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme: scheme });
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => window.axe.run());
      assert.deepEqual(violations.map(v => `${v.id}: ${v.nodes.map(n => n.html).slice(0, 3).join(" ")}`), [], scheme);
      await page.screenshot({ path: join(pictures, `${scheme}-${at}.png`) });
    }
    await close(page);
  });
}

test("pinching magnifies", async () => {
  const page = await open(sizes[1]);
  const world = () => page.evaluate(() => window.core.picture(0, 300, 300, 1).world);
  const [x0, , x1] = await world();
  const box = await page.locator("#panes canvas").first().boundingBox();
  const session = await page.context().newCDPSession(page), middle = [box.x + box.width / 2, box.y + box.height / 2];
  const touch = (type, apart) => session.send("Input.dispatchTouchEvent", {
    type, touchPoints: apart ? [-1, 1].map((side, id) => ({ x: middle[0] + side * apart, y: middle[1], id })) : [] });
  await touch("touchStart", 20);
  for (let apart = 25; apart <= 80; apart += 5) await touch("touchMove", apart);
  await touch("touchEnd");
  await settled(page);
  const [z0, , z1] = await world();
  assert.ok((z1 - z0) * 2.5 < x1 - x0, `${x1 - x0} became ${z1 - z0}`);
  await close(page);
});

test("a link opens the state that it was made of", async () => {
  const page = await open(sizes[0], "#open=streets&do=step 40; set penalty=none; step 3");
  await page.waitForTimeout(900);
  const state = await page.evaluate(() => [window.core.hash(), window.core.look().position, location.hash]);
  const again = await open(sizes[0], state[2]);
  assert.deepEqual(await again.evaluate(() => [window.core.hash(), window.core.look().position]), state.slice(0, 2));
  await close(again);
  await close(page);
});

/// Presses what saves the page, and opens that file in a browser of its own.
async function exported(page, name) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.evaluate(() => window.app.run("page"))]);
  assert.match(download.suggestedFilename(), /\.html$/);
  const file = join(pictures, name);
  await download.saveAs(file);
  const text = readFileSync(file, "utf8");
  assert.match(text, /GPL-3\.0-or-later/);
  return open(sizes[0], "", { file });
}

test("an exported page opens at exactly what was shown, a comparison with a note, and exports itself", async () => {
  const page = await open(sizes[0]);
  await page.evaluate(() => {
    window.app.run('compare penalty=none; step 7; note text 1,1 "a </script> <b>"; select 12; show code');
  });
  const shown = () => {
    const { position, panes, selected, desk } = window.core.look();
    return [window.core.hash(), position, panes, selected, desk.right,
            JSON.parse(window.core.state()).notes.map(note => note.text)];
  };
  const before = await page.evaluate(shown);
  const first = await exported(page, "handout.html");
  assert.deepEqual(await first.evaluate(shown), before);
  await first.keyboard.press("ArrowRight");
  await settled(first);
  const again = await exported(first, "handout-again.html");
  assert.equal(await again.evaluate(() => window.core.look().position), 8);
  await again.screenshot({ path: join(pictures, "handout.png") });
  for (const one of [again, first, page]) await close(one);
});

test("a dropped scene and a lesson go along in an exported page", async () => {
  const page = await open(sizes[0]);
  await page.evaluate(async text => {
    await window.app.openFiles([new File([text], "quarter.geojson")]);
    window.app.run("step 5");
  }, readFileSync(join(root, "examples/scenes/quarter.geojson"), "utf8"));
  const hash = await page.evaluate(() => window.core.hash());
  const map = await exported(page, "handout-map.html");
  assert.equal(await map.evaluate(() => window.core.hash()), hash);
  assert.equal(await map.evaluate(() => window.core.look().position), 5);
  await close(map);
  await page.evaluate(() => window.app.run("lesson plp 2; next; next"));
  const lesson = await exported(page, "handout-lesson.html");
  const taught = () => [window.core.look().teaching, window.core.look().lesson];
  assert.deepEqual(await lesson.evaluate(taught), await page.evaluate(taught));
  await close(lesson);
  await page.evaluate(async () => {
    const cube = ["v 0 0 0", "v 1 0 0", "v 1 1 0", "v 0 1 0", "v 0 0 1", "v 1 0 1", "v 1 1 1", "v 0 1 1", "f 4 3 2 1",
                  "f 5 6 7 8", "f 1 2 6 5", "f 2 3 7 6", "f 3 4 8 7", "f 4 1 5 8"].join("\n");
    await window.app.openFiles([new File([cube], "cube.obj")]);
  });
  const cube = await page.evaluate(() => [window.core.look().dimension, window.core.hash()]);
  assert.equal(cube[0], 3);
  const solid = await exported(page, "handout-cube.html");
  assert.deepEqual(await solid.evaluate(() => [window.core.look().dimension, window.core.hash()]), cube);
  await close(solid);
  await close(page);
});

const viewer = join(root, "build/release/viewer2d");
test("a page that a viewer exports opens at what that showed", { skip: !existsSync(viewer) }, async () => {
  const file = join(pictures, "handout-desk.html"), commands = `step 40; page ${file}`;
  const words = ["streets", "--headless", "--do", commands];
  const { status, stderr, stdout } = spawnSync(viewer, words, { encoding: "utf8" });
  assert.equal(status, 0, stderr);
  const page = await open(sizes[0], "", { file });
  assert.equal(await page.evaluate(() => window.core.look().position), 40);
  assert.ok(stdout.includes(await page.evaluate(() => window.core.hash())), stdout);
  await close(page);
});

test("on a server the page is files, and still exports itself as one", async () => {
  const folder = join(root, "out/web");
  const types = { html: "text/html; charset=utf-8", js: "text/javascript", lzma: "application/octet-stream" };
  const server = createServer((request, answer) => {
    const name = request.url === "/" ? "index.html" : request.url.slice(1);
    if (!existsSync(join(folder, name))) return answer.writeHead(404).end();
    answer.writeHead(200, { "content-type": types[name.replace(/^.*\./, "")] }).end(readFileSync(join(folder, name)));
  });
  await new Promise(done => server.listen(0, "127.0.0.1", done));
  const url = `http://127.0.0.1:${server.address().port}/`;
  const page = await open(sizes[0], "#open=bottleneck&do=step 7", { url, offline: false });
  const alone = await exported(page, "handout-hosted.html");
  assert.equal(await alone.evaluate(() => window.core.look().position), 7);
  await close(alone);
  await close(page);
  server.close();
});

test("a formula is followed as it is typed, and errors stand under it", async () => {
  const page = await open(sizes[0], "#open=bottleneck&do=method formula; run");
  const field = page.getByLabel("key =");
  const before = await page.evaluate(() => window.core.hash());
  await field.fill("distance +");
  assert.match(await page.locator("#formula-error").textContent(), /\S/);
  assert.equal(await page.evaluate(() => window.core.hash()), before);
  await field.fill("distance + hops");
  await settled(page);
  assert.equal(await page.locator("#formula-error").textContent(), "");
  assert.notEqual(await page.evaluate(() => window.core.hash()), before);
  assert.match(await page.evaluate(() => JSON.stringify(window.core.settings())), /"distance \+ hops"/);
  await field.fill("no_such_term");
  assert.match(await page.locator("#formula-error").textContent(), /no_such_term/);
  await page.screenshot({ path: join(pictures, "formula.png") });
  await page.evaluate(() => window.app.run("method published"));
  await settled(page);
  assert.ok(await page.locator("#formula").isHidden());
  await close(page);
});

test("the trade-off is measured and drawn while one looks; a dot sets its method and budget", async () => {
  const page = await open(sizes[0]);
  await page.evaluate(() => window.app.run("show trade-off"));
  await page.waitForFunction(() => document.querySelectorAll(".chart [data-dot]").length > 20, null,
                             { timeout: 60_000 });
  assert.match(await page.locator(".chart svg").textContent(), /ms per frame, in this browser/);
  await page.screenshot({ path: join(pictures, "trade-off.png") });
  const command = await page.evaluate(() => window.core.tradeOff().dots.find(dot => !dot.now).command);
  await page.evaluate(wanted => {
    const at = window.core.tradeOff().dots.findIndex(dot => dot.command === wanted);
    document.querySelector(`[data-dot="${at}"]`).dispatchEvent(new MouseEvent("click", { bubbles: true }));
  }, command);
  assert.equal(await page.evaluate(() => window.core.tradeOff().dots.find(dot => dot.now)?.command), command);
  await close(page);
});

test("the timeline shows the run, and a press on it goes there", async () => {
  const page = await open(sizes[0], "#open=streets&do=run; seek 30");
  await page.evaluate(() => window.app.run("show timeline"));
  const box = await page.locator("#timeline canvas").boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + 20);
  await settled(page);
  const { position, recorded } = await page.evaluate(() => window.core.look());
  assert.ok(Math.abs(position - recorded / 2) < 2, `${position} of ${recorded}`);
  await page.screenshot({ path: join(pictures, "timeline.png") });
  await close(page);
});

test("a wall is dragged in the edit mode, and only there", async () => {
  const page = await open(sizes[0]);
  const wall = () => page.evaluate(() => { window.app.run("select primitive:0"); return window.core.hash(); });
  const before = await wall();
  const ends = await page.evaluate(() => {
    const { embedded } = JSON.parse(window.core.state()).scene;
    return embedded.segments[0];
  });
  const [x, y] = await place(page, (ends[0] + ends[2]) / 2, (ends[1] + ends[3]) / 2);
  const drag = async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 5; ++i) await page.mouse.move(x + 6 * i, y - 3 * i);
    await page.mouse.up();
    await settled(page);
  };
  const source = () => page.evaluate(() => window.core.look().source);
  await page.evaluate(() => window.app.run("edit"));
  await drag();
  assert.equal(await source(), "edited");
  const moved = await page.evaluate(() => JSON.parse(window.core.state()).scene.embedded.segments[0]);
  assert.notDeepEqual(moved, ends);
  await page.evaluate(() => window.app.run("undo"));
  assert.equal(await wall(), before);
  await page.evaluate(() => window.app.run("edit"));
  await drag();
  assert.equal(await source(), "generated");
  await close(page);
});

test("in three dimensions a tap selects, and keys fly before the view is frozen", async () => {
  const page = await open(sizes[0], "#open=city:20000");
  const box = await page.locator("#panes canvas").last().boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height * 0.6);
  await settled(page);
  assert.match(await page.locator("#panel").textContent(), /Selected/);
  const state = () => page.evaluate(() => JSON.parse(window.core.state()).view.eye);
  const before = await state();
  await page.evaluate(() => window.app.run("fly"));
  await page.keyboard.down("w");
  await page.waitForTimeout(700);
  await page.keyboard.up("w");
  await settled(page);
  await page.evaluate(() => window.app.run("fly off"));
  const after = await state();
  assert.ok(Math.hypot(...after.map((value, i) => value - before[i])) > 0, "the eye has moved");
  assert.ok(await page.evaluate(() => window.core.look().recorded) > 0, "the frame is recorded where it lands");
  await page.keyboard.press("f");
  await settled(page);
  assert.equal(await page.evaluate(() => window.core.look().frozen), true);
  await page.screenshot({ path: join(pictures, "flight.png") });
  await close(page);
});

test("files are dropped: a map opens, nonsense is refused in a line", async () => {
  const page = await open(sizes[0]);
  const drop = (name, text) => page.evaluate(async ([name, text]) => {
    const data = new DataTransfer();
    data.items.add(new File([text], name));
    window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, [name, text]);
  await drop("quarter.geojson", readFileSync(join(root, "examples/scenes/quarter.geojson"), "utf8"));
  await page.waitForFunction(() => document.getElementById("headline").textContent.includes("quarter"));
  await drop("x.json", "{ nonsense");
  await page.waitForSelector("#said .bad");
  assert.match(await page.locator("#said .bad").textContent(), /x\.json/);
  assert.match(await page.locator("#headline").textContent(), /quarter/);
  await page.keyboard.press("ArrowRight");
  await settled(page);
  assert.equal(await step(page), 1);
  await close(page);
});

test("a Doom level, a comparison, settings, SVG and PNG", async () => {
  const page = await open(sizes[0]);
  if (await page.evaluate(() => window.core.scenes().some(scene => scene.command === "open freedoom1#E1M2"))) {
    await page.evaluate(() => window.app.run("open freedoom1#E1M2"));
    await settled(page);
    assert.match(await page.locator("#headline").textContent(), /E1M2/);
    await page.keyboard.press("Shift+ArrowRight");
    await settled(page);
    await page.screenshot({ path: join(pictures, "doom.png") });
  }
  await page.evaluate(() => window.app.run("open bottleneck; compare penalty=none; step 7"));
  await page.waitForFunction(() => document.querySelectorAll(".pane").length === 2);
  await settled(page);
  await page.getByRole("button", { name: "Settings", exact: true }).click();
  await page.getByLabel(/^penalty:/).selectOption("none");
  await settled(page);
  await page.screenshot({ path: join(pictures, "compare.png") });
  for (const kind of ["SVG", "PNG"]) {
    const button = page.getByRole("button", { name: kind, exact: true });
    const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
    const bytes = readFileSync(await download.path());
    if (kind === "SVG") assert.match(bytes.toString(), /^<svg [\s\S]*<text[\s\S]*<\/svg>\s*$/);
    else assert.equal(bytes.readUInt32BE(0), 0x89504e47);
  }
  await close(page);
});

test("in Chromium runs end in the states of the list of hashes", async () => {
  const page = await open(sizes[0]);
  let seen = 0;
  for (const [key, { state }] of goldenHashes()) {
    const [dimension, scene, cells, method, ...more] = key.split(" ");
    if (dimension !== "2d" || cells !== "delaunay" || method !== "published" || more.length > 0) continue;
    const got = await page.evaluate(([scene, command]) => {
      window.core.open(scene);
      window.core.run(command);
      return window.core.hash();
    }, [scene, "method published; budget unlimited; run"]);
    assert.equal(got, state, key);
    ++seen;
  }
  assert.ok(seen > 10);
  await close(page);
});

test("times on this machine", async t => {
  const page = await open(sizes[0], "#streets");
  const first = await page.evaluate(() => performance.getEntriesByName("first picture")[0].startTime);
  const times = await page.evaluate(async () => {
    const frame = () => new Promise(done => requestAnimationFrame(done));
    const median = list => list.sort((a, b) => a - b)[list.length >> 1];
    const steps = [], drags = [];
    for (let i = 0; i < 60; ++i) {
      await frame();
      const from = performance.now();
      window.app.run("step");
      await frame();
      steps.push(performance.now() - from);
    }
    const [x, y] = window.core.look().eye;
    window.core.picture(0, 900, 640, 1);
    window.core.take(x, y, 1);
    for (let i = 0; i < 30; ++i) {
      const from = performance.now();
      window.core.drag(x + 0.02 * i, y);
      window.core.look();
      window.core.picture(0, 900, 640, 1);
      drags.push(performance.now() - from);
    }
    window.core.letGo(true);
    return { step: median(steps), drag: median(drags) };
  });
  t.diagnostic(`first picture ${first.toFixed(0)} ms, a step of streets with its panel ${times.step.toFixed(1)} ms, ` +
               `a place of the dragged eye ${times.drag.toFixed(1)} ms`);
  await close(page);
});
