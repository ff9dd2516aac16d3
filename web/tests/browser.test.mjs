// The page as people use it, in Chromium, offline from a file: keys, mouse and touch at two sizes.
// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { existsSync, mkdirSync, readFileSync } from "node:fs";
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

async function open({ width, height, hasTouch }, hash = "", more = {}) {
  const context = await browser.newContext({ viewport: { width, height }, hasTouch, offline: true, acceptDownloads: true, ...more });
  const page = await context.newPage();
  page.errors = [];
  page.on("pageerror", error => page.errors.push(error.message));
  page.on("console", line => { if (line.type() === "error") page.errors.push(line.text()); });
  page.on("request", request => { if (!/^(file|blob|data):/.test(request.url())) page.errors.push(request.url()); });
  await page.goto("file://" + page_file + hash);
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
    const press = name => size.hasTouch ? page.getByRole("button", { name }).tap() : page.getByRole("button", { name }).click();
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
      const touch = (type, at) => session.send("Input.dispatchTouchEvent", { type, touchPoints: at ? [{ x: at[0], y: at[1] }] : [] });
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
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: kind, exact: true }).click()]);
    const bytes = readFileSync(await download.path());
    kind === "SVG" ? assert.match(bytes.toString(), /^<svg [\s\S]*<text[\s\S]*<\/svg>\s*$/) : assert.equal(bytes.readUInt32BE(0), 0x89504e47);
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
