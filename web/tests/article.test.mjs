// The article as a student reads it, in Chromium, offline from a file, at two sizes; and its numbers against the core
// in node.
// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { existsSync, mkdirSync, readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { build } from "esbuild";
import { chromium } from "playwright-core";
import { loadPage, root } from "./load.mjs";

const executablePath = process.env.SIGHTLINE_CHROMIUM ?? "/usr/bin/chromium";
const file = join(root, "out/article.html"), pictures = join(root, "out/web-tests");
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const sizes = [{ width: 1280, height: 800, hasTouch: false }, { width: 390, height: 844, hasTouch: true }];
const prose = join(root, "docs/article");

/// The table of diagrams, as the page has it.
const bundled = await build({ entryPoints: [join(root, "web/article/diagrams.ts")], bundle: true, format: "esm",
    write: false });
const { diagrams } = await import("data:text/javascript;base64," +
    Buffer.from(bundled.outputFiles[0].text).toString("base64"));
const ids = Object.keys(diagrams);

let browser;
before(async () => {
  assert.ok(existsSync(file), `${file} is missing: ./run web makes it`);
  mkdirSync(pictures, { recursive: true });
  browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
});
after(() => browser?.close());

async function open({ width, height, hasTouch }, more = {}, from = file, hash = "") {
  const context = await browser.newContext({ viewport: { width, height }, hasTouch, offline: true, ...more });
  const page = await context.newPage();
  page.errors = [];
  page.on("pageerror", error => page.errors.push(error.message));
  page.on("console", line => { if (line.type() === "error") page.errors.push(line.text()); });
  page.on("request", request => { if (!/^(file|blob|data):/.test(request.url())) page.errors.push(request.url()); });
  await page.goto("file://" + from + hash);
  await page.waitForSelector("body[data-ready]", { timeout: 60_000 });
  return page;
}
async function close(page) {
  assert.deepEqual(page.errors, []);
  await page.context().close();
}
/// Scrolls to a diagram, which then runs, with the numbers of its prose.
async function show(page, id) {
  await page.evaluate(id => document.getElementById(id).scrollIntoView({ block: "start", behavior: "instant" }), id);
  await page.waitForSelector(`#${id}[data-ready=yes]`, { timeout: 30_000 });
  if (diagrams[id].facts) await page.waitForSelector(`#${id}[data-facts]`, { timeout: 30_000 });
  await page.waitForTimeout(60);
}
/// Of the pixels on its canvas.
const picture = (page, id) => page.evaluate(id => {
  const canvas = document.querySelector(`#${id} .stage canvas`), of = canvas.getContext("2d");
  const { data } = of.getImageData(0, 0, canvas.width, canvas.height), colours = new Set();
  let hash = 0;
  for (let i = 0; i < data.length; i += 4) {
    const colour = data[i] << 16 | data[i + 1] << 8 | data[i + 2];
    hash = (Math.imul(hash, 31) + colour) | 0;
    if (colours.size < 20) colours.add(colour);
  }
  return { hash, colours: colours.size };
}, id);
const lit = (page, id) => page.evaluate(id => {
  const canvas = document.querySelector(`#${id} .stage .over`);
  return canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data.some(value => value > 0);
}, id);
/// A number far from its diagram may have to wait for it to wake.
async function becomesLit(page, id) {
  for (let i = 0; i < 60; ++i) {
    if (await lit(page, id)) return true;
    await page.waitForTimeout(50);
  }
  return false;
}
async function guess(page, id, number = "7") {
  const form = page.locator(`#${id} form.guess`);
  if (await form.count() === 0 || await form.getAttribute("data-tried")) return;
  if (await form.getAttribute("data-kind") === "number") {
    await form.locator(".line input").fill(number);
    await form.locator(".line button").click();
  } else await form.locator(".chips button").first().click();
  await page.waitForTimeout(120);
}
async function drag(page, id, handle, dx, dy) {
  const at = page.locator(`#${id} [data-handle="${handle}"]`);
  await at.scrollIntoViewIfNeeded();
  const box = await at.boundingBox(), x = box.x + box.width / 2, y = box.y + box.height / 2;
  if (page.hasTouch) {
    const session = await page.context().newCDPSession(page);
    const touch = (type, at) => session.send("Input.dispatchTouchEvent", { type, touchPoints: at ? [{ x: at[0], y:
        at[1] }] : [] });
    await touch("touchStart", [x, y]);
    for (let i = 1; i <= 5; ++i) await touch("touchMove", [x + dx * i / 5, y + dy * i / 5]);
    await touch("touchEnd");
  } else {
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 5; ++i) await page.mouse.move(x + dx * i / 5, y + dy * i / 5);
    await page.mouse.up();
  }
  await page.waitForTimeout(150);
}

for (const size of sizes) {
  const at = `${size.width}x${size.height}`;

  test(`every diagram starts, is the core's, and changes under a hand at ${at}`, async () => {
    const page = await open(size);
    page.hasTouch = size.hasTouch;
    assert.deepEqual(await page.evaluate(() => [...document.querySelectorAll("figure")].map(one => one.id)), ids);
    for (const id of ids) {
      await show(page, id);
      const start = await picture(page, id);
      assert.ok(start.colours > 5, `${id} shows ${start.colours} colours`);
      await guess(page, id);
      for (const { id: handle } of diagrams[id].handles ?? []) {
        const before = await picture(page, id);
        await drag(page, id, handle, handle === "look" ? -12 : 22, handle === "look" ? 30 : 11);
        assert.notEqual((await picture(page, id)).hash, before.hash, `${id}: ${handle} changes nothing`);
      }
      await page.locator(`#${id}`).screenshot({ path: join(pictures, `article-${id}-${size.width}.png`) });
    }
    const running = await page.evaluate(() => [...window.diagrams.values()].filter(one => one.running).length);
    assert.ok(running <= 6, `${running} diagrams keep their core`);
    await close(page);
  });

  test(`guesses keep their answers until somebody has tried at ${at}`, async () => {
    const page = await open(size);
    for (const id of ids.filter(id => diagrams[id].guess)) {
      await show(page, id);
      const form = page.locator(`#${id} form.guess`), asks = await form.getAttribute("data-asks");
      assert.equal(await page.locator(`#${id} .answer`).isVisible(), false, id);
      for (const value of await page.locator(`[data-value="${id}.${asks}"]`).allTextContents()) assert.equal(value,
          "?", id);
      const before = await picture(page, id);
      await guess(page, id);
      assert.equal(await page.locator(`#${id} .answer`).isVisible(), true, id);
      assert.match(await page.locator(`#${id} .verdict`).textContent(), /\w.*\./, id);
      assert.notEqual((await picture(page, id)).hash, before.hash, `${id}: the answer changes no picture`);
      for (const value of await page.locator(`#${id} .answer [data-value]`).allTextContents()) assert.match(value,
          /^[^?…]+$/, id);
    }
    await close(page);
  });

  test(`numbers light up their places, and places their numbers at ${at}`, async () => {
    const page = await open(size);
    let buttons = 0;
    for (const id of ids) {
      await show(page, id);
      await guess(page, id);
      for (const number of await page.locator(`#${id} button.n:not(:disabled)`).all()) {
        if (!await number.isVisible() || /^(0|0 %)$/.test(await number.textContent())) continue;
        size.hasTouch ? await number.tap() : await number.hover();
        assert.ok(await becomesLit(page, id), `${id}: ${await number.getAttribute("data-value")} lights nothing`);
        await page.evaluate(() => document.activeElement.blur());
        await page.mouse.move(1, 1);
        ++buttons;
      }
    }
    assert.ok(buttons > 25, `only ${buttons} numbers have a place`);
    if (!size.hasTouch) {
      await show(page, "budget");
      const place = await page.evaluate(() => {
        const diagram = window.diagrams.get("budget"), [[from, to]] = [diagram.core.place("found")[0].points];
        const { world } = diagram.core.picture(0, 700, 538, 1),
            box = document.querySelector("#budget canvas").getBoundingClientRect();
        const scale = box.width / (world[2] - world[0]);
        return [box.left + ((from[0] + to[0]) / 2 - world[0]) * scale, box.bottom - ((from[1] +
            to[1]) / 2 - world[1]) * scale];
      });
      await page.mouse.move(...place);
      assert.ok(await page.locator('#budget [data-value="budget.found"][data-lit]').count() > 0);
    }
    await close(page);
  });

  test(`nothing is cut off or hard to reach at ${at}`, async () => {
    for (const colorScheme of ["light", "dark"]) {
      const page = await open(size, { colorScheme, reducedMotion: "reduce" });
      for (const id of ids) {
        await show(page, id);
        await guess(page, id);
      }
      const wide = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
      assert.ok(wide[0] <= wide[1], `the page is ${wide[0]} wide in ${wide[1]}`);
      const cut = await page.evaluate(() => [...document.querySelectorAll("main *")].filter(one => {
        const box = one.getBoundingClientRect();
        return box.width > 0 && !one.closest(".stage, svg") && (box.right > innerWidth + 0.5 || box.left < -0.5);
      }).map(one => one.outerHTML.slice(0, 80)));
      assert.deepEqual(cut, []);
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => window.axe.run());
      assert.deepEqual(violations.map(v => `${v.id}: ${v.nodes.map(n => n.html).slice(0, 3).join(" ")}`), [],
          colorScheme);
      await close(page);
    }
  });
}

test("keys alone: steps, handles, a number, a guess", async () => {
  const page = await open(sizes[0]);
  await show(page, "cells");
  await page.locator("#cells .chips button").first().focus();
  assert.ok(await lit(page, "cells"), "the cell of a letter lights up");
  await page.keyboard.press("Enter");
  await page.locator("#cells .stage").focus();
  const where = () => page.locator("#cells .where").textContent();
  assert.match(await where(), /^step 5 of/);
  await page.keyboard.press("ArrowRight");
  await page.waitForTimeout(80);
  assert.match(await where(), /^step 6 of/);
  assert.match(await page.locator("#cells .said").textContent(), /^Step 6 took cell/);
  await page.keyboard.press("Home");
  await page.waitForTimeout(80);
  assert.match(await where(), /^step 0 of/);
  await show(page, "shadow");
  await page.locator('#shadow [data-handle="eye"]').focus();
  for (let i = 0; i < 12; ++i) await page.keyboard.press("Shift+ArrowUp");
  await page.waitForTimeout(120);
  assert.match(await page.locator("#shadow .said").textContent(), /PARTIAL|VISIBLE/);
  await close(page);
});

test("a diagram that was far away goes on where it was", async () => {
  const page = await open(sizes[0]);
  await show(page, "key");
  await guess(page, "key");
  await page.locator('#key [aria-label="One step forward"]').click();
  await page.waitForTimeout(100);
  const before = await page.evaluate(() => window.diagrams.get("key").core.hash());
  for (const id of ids.slice(-8)) await show(page, id);
  assert.equal(await page.evaluate(() => window.diagrams.get("key").running), false);
  await show(page, "key");
  assert.equal(await page.evaluate(() => window.diagrams.get("key").core.hash()), before);
  await close(page);
});

test("the chart is measured here, and a dot runs its method", async () => {
  const page = await open(sizes[0]);
  await show(page, "cost");
  await page.waitForSelector("#cost[data-measured]", { timeout: 120_000 });
  const dots = page.locator("#cost .dot");
  assert.ok(await dots.count() > 20);
  await dots.first().focus();
  await page.keyboard.press("ArrowRight");
  await page.waitForTimeout(200);
  const words = await page.locator("#cost .measured").textContent();
  const now = await page.evaluate(() => window.diagrams.get("cost").core.numbers(""));
  assert.ok(words.startsWith(now.method.text), words);
  assert.ok(words.includes(`${now.drawn.text} segments drawn`), words);
  await close(page);
});

test("numbers in the prose are those of the core", async () => {
  const core = await loadPage(), page = await open(sizes[0]);
  core.FS.mkdirTree("/examples/states/coorg-teller");
  for (const name of readdirSync(join(root, "examples/states/coorg-teller")))
    core.FS.writeFile(`/examples/states/coorg-teller/${name}`, readFileSync(join(root, "examples/states/coorg-teller",
        name)));
  const begin = (place, commands) => {
    place.endsWith(".json") ? core.json("open_state", Buffer.from(core.FS.readFile(place)).toString()) :
        core.json("open", place);
    core.json("do", commands);
  };
  let compared = 0;
  for (const id of ids.filter(id => id !== "cost")) {
    const spec = diagrams[id];
    await show(page, id);
    await guess(page, id);
    const told = await page.evaluate(id => [...document.querySelectorAll(`[data-value^="${id}."]`)].map(
      one => [one.dataset.value.split(".").pop(), one.textContent]), id);
    const facts = {};
    for (const [name, fact] of Object.entries(spec.facts ?? {})) {
      begin(fact.open ?? spec.open, fact.open ? "" : spec.begin);
      core.json("do", fact.does);
      facts[name] = core.json("numbers", fact.of)[fact.of];
      assert.ok(facts[name], `${id}: the core says nothing of ${name}`);
    }
    begin(spec.open, spec.begin);
    if (spec.guess) core.json("do", spec.guess.reveal);
    const numbers = { ...core.json("numbers", told.map(([name]) => name).join(" ")), ...facts };
    for (const [name, text] of told) {
      assert.equal(text, numbers[name]?.text, `${id}.${name}`);
      ++compared;
    }
    // What the sentences around the numbers claim.
    const value = name => numbers[name].value;
    if (id === "town") assert.ok(value("visible_share") < 0.05);
    if (id === "cone") assert.ok(value("steps") < value("boxes") / 2 && value("wasted") > 10 * value("visible"));
    if (id === "floor") assert.ok(value("changed_near") < value("changed_far") &&
        value("jungle_drawn") > 0.9 * value("jungle_view"));
    if (id === "floor") assert.equal(value("missed"), 0);
    if (["cells", "key"].includes(id)) assert.equal(value("taken_visible"), 0);
    if (id === "flood") assert.ok(value("own") > value("plain") && value("zero") > value("zero_own"));
    if (id === "star") assert.ok(value("paid") === value("visible") && value("without") < value("paid") &&
        value("moved") < value("paid"));
    if (id === "forget") assert.ok(value("layers") === value("visible") && value("nearest") === value("visible") &&
        value("plp") < value("layers"));
    if (id === "light") assert.equal(value("all"), value("there"));
    if (id === "contest") assert.ok(value("light") > value("plp") && value("tri") > value("light") &&
        value("fog_light") < value("fog_plp"));
    if (id === "rounds") assert.ok(value("winners") < value("done") && value("by_boxes") < value("winners") &&
        value("missed") === 0);
    if (id === "place") assert.ok(numbers.here.text === "portals" && numbers.lawn.text === "view");
    if (id === "doors") assert.ok(value("drawn") < value("pvs") && value("pvs") < value("view_culling"));
  }
  assert.ok(compared > 60, `only ${compared} numbers`);
  await close(page);
});

test("no result is typed by hand, and every section has its sources", () => {
  const allowed = new Set(["1", "2", "3", "0", "20"]);  // regions, a term, dimensions, metres walked
  for (const name of readdirSync(prose).filter(name => /^\d+-.*\.md$/.test(name))) {
    const text = readFileSync(join(prose, name), "utf8");
    if (!name.startsWith("00")) assert.match(text, /^## \d+ /);
    if (!/^(00|10)/.test(name)) assert.match(text, /\nSources: .*(section|figure|“)/s, name);
    const own = text.replace(/\n(### )?Sources[\s\S]*$/, "").replace(/\{\{.*?\}\}/gs, "")
      .replace(/^(#|::: |    ).*$/gm, "").replace(/section \d+/g, "").replace(/\]\([^)]*\)/g, "]");
    for (const [number] of own.matchAll(/\d+(\.\d+)?/g)) assert.ok(allowed.has(number),
        `${name}: ${number} is typed by hand`);
  }
});

test("links lead to what they say, in the page beside it", async () => {
  const links = [...readFileSync(join(prose, "10-cost.md"),
      "utf8").matchAll(/\(sightline\.html(#[^)\s]+)\)/g)].map(one => one[1]);
  assert.ok(links.length >= 4);
  for (const link of links) {
    const page = await open(sizes[0], {}, join(root, "out/sightline.html"), link);
    await page.waitForTimeout(300);
    assert.equal(await page.locator("#said .bad").count(), 0, `${link}: ${await page.locator("#said").textContent()}`);
    assert.notEqual(await page.locator("#headline").textContent(), "Sightline", link);
    await close(page);
  }
});
