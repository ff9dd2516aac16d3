// The timeline: what each step drew, visible upwards and hidden downwards, the keys of the cells, what is found.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Curve, Look } from "./core";
import { byId, make } from "./dom";

const lanes = { found: [4, 54], drawn: [60, 120], key: [126, 166] };
const height = 172, most = 600;

export class Timeline {
  private readonly canvas = make("canvas", { role: "img" });
  private steps = 0;
  private drawnOf = "";
  private curve: { of: string; is: Curve } = { of: "", is: {} };

  constructor(seek: (step: number) => void) {
    byId("timeline").append(this.canvas);
    const go = (event: PointerEvent) => {
      const box = this.canvas.getBoundingClientRect();
      seek(Math.round(Math.min(Math.max((event.clientX - box.left) / box.width, 0), 1) * this.steps));
    };
    this.canvas.addEventListener("pointerdown", event => {
      this.canvas.setPointerCapture(event.pointerId);
      go(event);
    });
    this.canvas.addEventListener("pointermove", event => { if (event.buttons) go(event); });
  }

  update(look: Look, curve: () => Curve) {
    const box = byId("timeline");
    box.hidden = !look.desk.timeline || look.recorded === 0;
    if (box.hidden) return;
    this.steps = look.recorded;
    this.canvas.setAttribute("aria-label", `Timeline of ${look.recorded} steps; the slider moves in it`);
    const width = box.clientWidth, of = `${look.run} ${look.recorded} ${look.position} ${width} ${look.panes}`;
    if (of === this.drawnOf || width < 2) return;
    this.drawnOf = of;
    const run = `${look.run} ${look.recorded} ${look.panes}`;
    if (run !== this.curve.of) this.curve = { of: run, is: curve() };
    this.draw(this.curve.is, look.position, width);
  }

  private draw(curve: Curve, position: number, width: number) {
    const ratio = Math.min(devicePixelRatio || 1, 3), n = this.steps;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.canvas.style.height = `${height}px`;
    const to = this.canvas.getContext("2d")!, colours = getComputedStyle(document.documentElement);
    const colour = (name: string) => colours.getPropertyValue(`--${name}`).trim();
    to.scale(ratio, ratio);
    to.font = "11px 'DejaVu Sans', Verdana, sans-serif";
    to.lineWidth = 1.5;
    const x = (step: number) => step / n * width, every = Math.max(1, Math.floor(n / most));
    const line = (values: (number | null)[] | undefined, [high, low]: number[], ink: string, largest: number) => {
      if (!values?.length || !(largest > 0)) return;
      to.beginPath();
      let open = false;
      for (let i = 0; i < values.length; i += every) {
        const value = values[i];
        if (value === null) { open = false; continue; }
        to[open ? "lineTo" : "moveTo"](x(i + 1), low - (low - high) * Math.min(value / largest, 1));
        open = true;
      }
      to.strokeStyle = ink;
      to.stroke();
    };
    const name = (words: string, y: number) => { to.fillStyle = colour("faint"); to.fillText(words, 4, y); };
    const middle = (lanes.drawn[0] + lanes.drawn[1]) / 2;
    if (curve.tells) {
      line(curve.oracle, lanes.found, colour("faint"), 1);
      line(curve.other, lanes.found, colour("handed"), 1);
      line(curve.coverage, lanes.found, colour("good"), 1);
    }
    const visible = curve.visible ?? [], hidden = curve.hidden ?? [];
    const bars = curve.tells ? [visible, hidden] : [visible.map((count, i) => count + hidden[i]), []];
    const largest = Math.max(1, ...bars[0], ...bars[1]), half = (lanes.drawn[1] - lanes.drawn[0]) / 2;
    for (let i = 0; i < n; i += every) {
      let up = 0, down = 0;
      for (let k = i; k < Math.min(i + every, n); ++k) {
        up = Math.max(up, bars[0][k] ?? 0);
        down = Math.max(down, bars[1][k] ?? 0);
      }
      const wide = Math.max(width / n * every - 0.5, 1);
      to.fillStyle = colour("good");
      to.fillRect(x(i), middle - half * Math.sqrt(up / largest), wide, half * Math.sqrt(up / largest));
      to.fillStyle = colour("wasted");
      to.fillRect(x(i), middle, wide, half * Math.sqrt(down / largest));
    }
    const keys = (curve.key ?? []).filter((key): key is number => key !== null);
    line(curve.key, lanes.key, colour("accent"), keys.reduce((most, key) => Math.max(most, key), 0) || 1);
    name(curve.tells ? "found, and the best possible" : "found: hidden until it is told", 14);
    name(curve.tells ? "drawn: visible up, hidden down" : "drawn", lanes.drawn[0] + 10);
    name("key", lanes.key[0] + 10);
    to.fillStyle = colour("accent");
    for (const mark of curve.bookmarks ?? []) to.fillRect(x(mark.step) - 1, 0, 2, 10);
    to.fillStyle = colour("ink");
    to.fillRect(Math.min(x(position), width - 1) - 1, 0, 2, height);
  }
  /// What it tells may have changed without a new run.
  forget() { this.drawnOf = this.curve.of = ""; }
}
