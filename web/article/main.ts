// The article: text first, and a core for each diagram as it scrolls into view.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Module } from "../page/core";
import { make } from "../page/dom";
import { labelFont } from "../page/paint";
import { packedBlock, partsOf } from "../page/parts";
import { loadCore } from "../page/payload";
import { Core } from "../page/core";
import { Diagram } from "./diagram";
import { diagrams } from "./diagrams";

/// Diagrams that keep their core; those farthest away give theirs back.
const alive = 5;

function characterWidths(): number[] {
  const to = document.createElement("canvas").getContext("2d")!;
  to.font = `100px ${labelFont}`;
  const width = (text: string) => to.measureText(text).width / 100;
  return [...Array(128).keys()].map(i => i < 32 || i === 127 ? 0 : width(String.fromCharCode(i))).concat(width("ρ"));
}

let loaded: Promise<{ module: Module; widths: number[] }> | null = null;
const load = () => loaded ??= (async () => {
  const [, , ...ofCore] = partsOf(await packedBlock());  // the first two are of the other page
  const module = await loadCore(ofCore), widths = characterWidths();
  const failed = new Core(module).selfTest(2000);
  if (failed) throw new Error(`exact geometry is not exact in this browser (${failed}), so nothing is shown`);
  return { module, widths };
})();

const all = new Map<Element, Diagram>(), near = new Set<Element>();
const distance = (element: Element) => {
  const box = element.getBoundingClientRect();
  return box.top > innerHeight ? box.top - innerHeight : box.bottom < 0 ? -box.bottom : 0;
};

function tidy() {
  const running = [...all.values()].filter(one => one.running && !near.has(one.figure));
  running.sort((a, b) => distance(b.figure) - distance(a.figure));
  for (const one of running.slice(0, Math.max(0, running.length + near.size - alive))) one.drop();
}

let queue: Promise<void> = Promise.resolve();
/// One after the other, so that the page stays quick while it scrolls.
function startSoon(diagram: Diagram) {
  queue = queue.then(async () => {
    if (!near.has(diagram.figure)) return;
    try {
      await diagram.start();
      tidy();
    } catch (error) {
      diagram.figure.querySelector(".stand")!.prepend(
        make("p", { class: "wait", role: "alert" }, `This diagram cannot start: ${(error as Error).message}`));
      diagram.figure.dataset.ready = "failed";
    }
    await new Promise(done => setTimeout(done));
  });
}

const observer = new IntersectionObserver(entries => {
  for (const entry of entries) {
    if (!entry.isIntersecting) { near.delete(entry.target); continue; }
    near.add(entry.target);
    startSoon(all.get(entry.target)!);
  }
}, { rootMargin: "500px 0px" });

for (const figure of document.querySelectorAll<HTMLElement>("figure[data-diagram]")) {
  const id = figure.dataset.diagram!, spec = diagrams[id];
  if (!spec) throw new Error(`there is no diagram '${id}'`);
  all.set(figure, new Diagram(id, figure, spec, load));
  observer.observe(figure);
}
new ResizeObserver(() => { for (const one of all.values()) one.redraw(); }).observe(document.body);
Object.assign(window, { diagrams: new Map([...all.values()].map(one => [one.id, one])) });
document.body.dataset.ready = "yes";
