// How fast the page is here, and at a sixth of the speed: node web/tests/times.mjs. It prints, and asserts nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
import { join } from "node:path";
import { chromium } from "playwright-core";
import { root } from "./load.mjs";

const browser = await chromium.launch({
  executablePath: process.env.SIGHTLINE_CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"],
});
const median = list => [...list].sort((a, b) => a - b)[list.length >> 1];

async function measure(slower) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, offline: true });
  const page = await context.newPage();
  const session = await context.newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate: slower });
  const first = [];
  for (let i = 0; i < 5; ++i) {
    await page.goto("about:blank");
    await page.goto("file://" + join(root, "out/sightline.html"));
    await page.waitForSelector("body[data-ready]", { timeout: 60_000 });
    first.push(await page.evaluate(() => performance.getEntriesByName("first picture")[0].startTime));
  }
  await page.goto("about:blank");
  await page.goto("file://" + join(root, "out/sightline.html") + "#streets");
  await page.waitForSelector("body[data-ready]", { timeout: 60_000 });
  const steps = {};
  for (const panel of ["why", "code", "run"])
    steps[panel] = median(await page.evaluate(async panel => {
      const frame = () => new Promise(done => requestAnimationFrame(done)), times = [];
      // Not the wait for the next frame: what the page does in it, and until the picture is painted.
      const next = window.requestAnimationFrame.bind(window);
      let busy = 0;
      const timed = call => {
        const from = performance.now();
        call();
        busy += performance.now() - from;
      };
      window.requestAnimationFrame = call => next(now => timed(() => call(now)));
      const paint = document.querySelector("#panes canvas").getContext("2d", { willReadFrequently: false });
      if (window.core.look().desk.right !== panel) window.app.run("show " + panel);
      window.app.run("seek 100");
      for (let i = 0; i < 60; ++i) {
        await frame();
        busy = 0;
        timed(() => window.app.run("step"));
        await frame();
        timed(() => paint.getImageData(0, 0, 1, 1));
        times.push(busy);
      }
      window.requestAnimationFrame = next;
      return times;
    }, panel));
  const parts = await page.evaluate(() => {
    const of = (count, call) => {
      const from = performance.now();
      for (let i = 0; i < count; ++i) call();
      return (performance.now() - from) / count;
    };
    const { core } = window;
    core.run("seek 100");
    return { step: of(20, () => core.run("step")), look: of(20, () => core.look()),
             picture: of(20, () => core.picture(0, 870, 620, 1)), curve: of(5, () => core.curve()),
             state: of(5, () => core.handout()), refresh: of(10, () => window.app.refresh()) };
  });
  await context.close();
  const rounded = times => Object.entries(times).map(([name, ms]) => `${name} ${ms.toFixed(1)}`).join(", ");
  const where = slower === 1 ? "here" : `at 1/${slower} of the speed`;
  console.log(`${where}: first picture ${median(first).toFixed(0)} ms; ` +
              `a step of streets with its picture and panel ${rounded(steps)} ms; parts of it: ${rounded(parts)} ms`);
}

await measure(1);
await measure(6);
await browser.close();
