// A picture of the page for its documentation: node web/tests/picture.mjs FILE.png
// SPDX-License-Identifier: GPL-3.0-or-later
import { join } from "node:path";
import { chromium } from "playwright-core";
import { root } from "./load.mjs";

const browser = await chromium.launch({
  executablePath: process.env.SIGHTLINE_CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"],
});
const page = await browser.newPage({ viewport: { width: 1100, height: 680 } });
await page.goto("file://" + join(root, "out/sightline.html") + "#open=bottleneck&do=run; seek 7; show timeline");
await page.waitForSelector("body[data-ready]");
await page.waitForTimeout(700);
await page.screenshot({ path: process.argv[2] });
await browser.close();
