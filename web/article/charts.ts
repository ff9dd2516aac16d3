// Charts beside a picture: what rays cross, and what methods cost. The core counts and measures.
// SPDX-License-Identifier: GPL-3.0-or-later
import { make } from "../page/dom";
import type { DiagramCore, Dot, ViewNow } from "./handle";

const columns = 96;

/// A bar for each column of the view: how many segments the ray through it crosses. One is chosen.
export class CrossedChart {
  readonly element = make("div", { class: "crossed" });
  private readonly bars = make("div", { class: "bars", "aria-hidden": "true" });
  private readonly input = make("input", { type: "range", min: 0, max: columns - 1, step: 1, value: columns / 2,
                                           "aria-label": "Which ray, from left to right" });
  private readonly words = make("p", { class: "ray", role: "status" });
  private counts: number[] = [];
  private chosen = false;

  constructor(private readonly show: (column: number) => void) {
    this.element.append(this.bars, make("label", { class: "slider" }, make("span", {}, "Ray"), this.input), this.words);
    this.input.addEventListener("input", () => this.choose(Number(this.input.value)));
    const point = (event: PointerEvent) => {
      const box = this.bars.getBoundingClientRect();
      this.choose(Math.max(0, Math.min(columns - 1, Math.floor((event.clientX - box.left) / box.width * columns))));
    };
    this.bars.addEventListener("pointermove", point);
    this.bars.addEventListener("pointerdown", point);
  }
  private choose(column: number) {
    this.chosen = true;
    this.input.value = String(column);
    this.tell();
    this.show(column);
  }
  private tell() {
    const column = Number(this.input.value), crossed = this.counts[column];
    const text = crossed === 0 ? "This ray meets nothing." :
        crossed === 1 ? "This ray meets 1 segment, which is seen." :
      `This ray meets ${crossed} segments: 1 is seen, ${crossed - 1} are painted over.`;
    this.words.textContent = text;
    this.input.setAttribute("aria-valuetext", text);
    [...this.bars.children].forEach((bar, i) => bar.classList.toggle("chosen", i === column));
  }
  /// The way through a column of the view, as a point in the scene.
  static through(view: ViewNow, column: number): [number, number] {
    const [dx, dy] = [view.look[0] - view.eye[0], view.look[1] - view.eye[1]];
    const half = Math.tan(view.fov * Math.PI / 360);
    const side = (1 - 2 * (column + 0.5) / columns) * half;
    return [view.eye[0] + dx - dy * side, view.eye[1] + dy + dx * side];
  }
  update(core: DiagramCore) {
    this.counts = core.crossed(columns).all;
    const most = Math.max(1, ...this.counts);
    if (this.bars.childElementCount === 0) for (let i = 0; i < columns; ++i) this.bars.append(make("i"));
    [...this.bars.children].forEach((bar, i) => {
      (bar as HTMLElement).style.height = `${100 * this.counts[i] / most}%`;
    });
    this.tell();
    if (this.chosen) this.show(Number(this.input.value));
  }
}

const W = 640, H = 330, left = 84, bottom = 56, top = 14, right = 14;
const svg = (name: string, attributes: Record<string, string | number>, text = "") => {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  element.textContent = text;
  return element;
};

/// Dots of methods at budgets: what they leave wrong over what they cost. One chosen dot runs in the picture.
export class CostChart {
  readonly element = make("div", { class: "cost" });
  private readonly words = make("p", { class: "measured", role: "status" });
  private readonly plot = svg("svg", { viewBox: `0 0 ${W} ${H}`, role: "group",
                                       "aria-label": "Wrong pixels over cost; arrow keys go from dot to dot" });
  private readonly names = make("ul", { class: "legend", "aria-label": "Methods" });
  private dots: Dot[] = [];
  private by: "ms" | "drawn" = "drawn";
  private chosen = -1;

  constructor(private readonly run: (dot: Dot) => void) {
    const axis = make("fieldset", { class: "choice" }, make("legend", {}, "Cost is counted in"));
    for (const [id, label] of [["drawn", "segments drawn"], ["ms",
        "milliseconds of culling, measured here"]] as const) {
      const input = make("input", { type: "radio", name: "cost-by", value: id, checked: id === this.by });
      input.addEventListener("change", () => { this.by = id; this.draw(); });
      axis.append(make("label", {}, input, make("span", {}, label)));
    }
    this.element.append(axis, this.plot, this.names, this.words);
    this.plot.addEventListener("keydown", event => {
      const step = ({ ArrowLeft: -1, ArrowRight: 1 } as Record<string, number>)[(event as KeyboardEvent).key];
      if (!step || this.dots.length === 0) return;
      event.preventDefault();
      event.stopPropagation();
      const order = this.dots.map((_, i) => i).sort((a, b) => this.dots[a][this.by] - this.dots[b][this.by]);
      const at = order.indexOf(this.chosen);
      this.choose(order[Math.max(0, Math.min(order.length - 1, at + step))], true);
    });
  }

  update(dots: Dot[], done: number, total: number) {
    this.dots = dots;
    this.draw();
    if (this.chosen < 0)
      this.words.textContent = done < total ? `Measuring in this browser: ${done} of ${total} …` :
        `Measured ${total} runs in this browser. Choose a dot to see its picture.`;
  }
  private choose(i: number, focus = false) {
    this.chosen = i;
    this.draw();
    if (focus) this.plot.querySelector<SVGElement>(`[data-i="${i}"]`)?.focus();
    const dot = this.dots[i];
    this.words.textContent = `${dot.method}, budget ${dot.budget} (${dot.promise}): ` +
      `${Math.round(dot.drawn)} segments ` +
                             `drawn, ${dot.msText} ms of culling, ${dot.wrongText} of the pixels wrong`;
    this.run(dot);
  }

  private draw() {
    if (this.dots.length === 0) return;
    const values = this.dots.map(dot => Math.max(dot[this.by], 1e-4));
    const low = Math.log10(Math.min(...values)) - 0.1, high = Math.log10(Math.max(...values)) + 0.1;
    const worst = Math.max(0.01, ...this.dots.map(dot => dot.wrong)) * 1.05;
    const x = (v: number) => left + (W - left - right) * (Math.log10(Math.max(v, 1e-4)) - low) / (high - low || 1);
    const y = (v: number) => H - bottom - (H - top - bottom) * v / worst;
    const parts: Element[] = [svg("path", { class: "axis", d: `M${left} ${top}V${H - bottom}H${W - right}` })];
    const write = (at: number, down: number, anchor: string, text: string) =>
      parts.push(svg("text", { x: at, y: down, class: "tick", "text-anchor": anchor }, text));
    for (let e = Math.ceil(low); e <= high; ++e)
      write(x(10 ** e), H - bottom + 22, "middle", `${+(10 ** e).toPrecision(1)}`);
    for (let i = 0; i <= 4; ++i)
      write(left - 6, y(worst * i / 4) + 4, "end", `${Math.round(worst * i / 4 * 100)} %`);
    write((left + W) / 2, H - 6, "middle", this.by === "drawn" ? "segments drawn →" : "milliseconds →");
    write(left + 8, top + 10, "start", "↑ wrong pixels");
    const names = new Map(this.dots.map(dot => [dot.method, dot.colour]));
    this.names.replaceChildren(...[...names].map(([name, colour]) => {
      const swatch = make("i", { class: "swatch" });
      swatch.style.background = colour;
      return make("li", {}, swatch, name);
    }));
    for (const name of new Set(this.dots.map(dot => dot.method))) {
      const of = this.dots.filter(dot => dot.method === name).sort((a, b) => a[this.by] - b[this.by]);
      if (of.length > 1)
        parts.push(svg("polyline", { class: "way", stroke: of[0].colour,
                                     points: of.map(d => `${x(d[this.by])},${y(d.wrong)}`).join(" ") }));
    }
    this.dots.forEach((dot, i) => {
      const mark = svg("g", { role: "button", "data-i": i, class: i === this.chosen ? "dot chosen" : "dot",
                              tabindex: i === Math.max(this.chosen, 0) ? 0 : -1,
                              "aria-label": `${dot.method}, budget ${dot.budget}: ${dot.wrongText} wrong`,
                              "aria-pressed": String(i === this.chosen) });
      const place = { cx: x(dot[this.by]), cy: y(dot.wrong) };
      const fill = dot.promise === "conservative" ? "none" : dot.colour;
      mark.append(svg("circle", { ...place, r: 12, class: "reach" }),
                  svg("circle", { ...place, r: 5.5, fill, stroke: dot.colour, "stroke-width": 2.4 }));
      mark.addEventListener("click", () => this.choose(i));
      mark.addEventListener("keydown", event => {
        if (!["Enter", " "].includes((event as KeyboardEvent).key)) return;
        event.preventDefault();
        this.choose(i, true);
      });
      parts.push(mark);
    });
    this.plot.replaceChildren(...parts);
  }
}
