// What stands under a picture: the steps, sliders, choices, the legend.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { LegendRow, Look } from "../page/core";
import { icon, make } from "../page/dom";
import type { ChoiceSpec, SliderSpec } from "./specs";

export class Steps {
  readonly element = make("div", { class: "steps" });
  private readonly slider: HTMLInputElement;
  private readonly where = make("span", { class: "where" });
  private readonly buttons: Record<string, HTMLButtonElement> = {};

  constructor(private readonly name: string, run: (command: string) => void) {
    const button = (kind: string, command: string, label: string) => {
      this.buttons[kind] = make("button", { type: "button", title: label, "aria-label": label,
                                            onclick: () => run(command) }, icon(kind));
      this.element.append(this.buttons[kind]);
    };
    button("start", "seek start", "To the start");
    button("back", "back", `One ${name} back`);
    button("step", "step", `One ${name} forward`);
    button("end", "run", "To the end");
    this.slider = make("input", { type: "range", min: 0, max: 1, step: 1, "aria-label": `Which ${name}` });
    this.slider.addEventListener("input", () => run(`seek ${this.slider.value}`));
    this.element.append(this.slider, this.where);
  }
  update(look: Look, hidesLast: boolean) {
    const text = `${this.name} ${look.position} of ${hidesLast ? "?" : look.recorded}`;
    this.slider.max = String(Math.max(1, look.recorded));
    this.slider.value = String(look.position);
    this.slider.setAttribute("aria-valuetext", text);
    this.where.textContent = text;
    this.buttons.start.disabled = this.buttons.back.disabled = look.position === 0;
    this.buttons.step.disabled = this.buttons.end.disabled = look.position >= look.recorded;
  }
}

export function slider(spec: SliderSpec, run: (command: string) => void): HTMLElement {
  const words = make("output", {}, spec.words(spec.value));
  const input = make("input", { type: "range", min: spec.min, max: spec.max, step: spec.step, value: spec.value,
                                "data-slider": spec.id, "aria-valuetext": spec.words(spec.value) });
  input.addEventListener("input", () => {
    const text = spec.words(Number(input.value));
    words.textContent = text;
    input.setAttribute("aria-valuetext", text);
    run(spec.does(Number(input.value)));
  });
  return make("label", { class: "slider" }, make("span", {}, spec.label), input, words);
}

export function choice(spec: ChoiceSpec, group: string, run: (command: string) => void): HTMLElement {
  const box = make("fieldset", { class: "choice" }, make("legend", {}, spec.label));
  for (const option of spec.options) {
    const input = make("input", { type: "radio", name: `${group}-${spec.id}`, value: option.id,
                                  checked: option.id === spec.value });
    input.addEventListener("change", () => run(option.does));
    box.append(make("label", {}, input, make("span", {}, option.label)));
  }
  return box;
}

/// Looks of the picture that are the places of numbers.
const lit: Record<string, string> = { rendered: "found", missed: "missed", wasted: "wasted", enqueued: "front",
                                      projected: "projected", last: "cell", next: "runner_up", seed: "seed" };
const svg = (row: LegendRow) => {
  const { fill, stroke, dash } = row.style;
  const line = stroke ? ` stroke="${stroke}" stroke-width="1.8"${dash ? ' stroke-dasharray="4 3"' : ""}` : "";
  const shape = row.swatch === "polygon" ? `<rect x="1" y="1" width="18" height="10" fill="${fill ?? "none"}"${line}/>`
    : row.swatch === "disc" || row.swatch === "ring"
      ? `<circle cx="10" cy="6" r="4" fill="${row.swatch === "disc" ? fill ?? "none" : "none"}"${line}/>`
      : `<path d="M1 6h18" fill="none"${line}/>`;
  return `<svg viewBox="0 0 20 12" aria-hidden="true">${shape}</svg>`;
};
export function showLegend(list: HTMLUListElement, rows: LegendRow[], light: (name: string | null) => void) {
  const text = rows.map(row => svg(row) + row.text).join("");
  if (list.dataset.of === text) return;
  list.dataset.of = text;
  list.replaceChildren(...rows.map(row => {
    const item = make("li", {}), place = lit[row.style.name];
    item.innerHTML = svg(row);
    item.append(row.text);
    if (place) {
      item.dataset.place = place;
      item.addEventListener("mouseenter", () => light(place));
      item.addEventListener("mouseleave", () => light(null));
    }
    return item;
  }));
}
