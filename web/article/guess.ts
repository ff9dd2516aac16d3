// A guess: the answer stays hidden until somebody has tried. What is right comes from the core.
// SPDX-License-Identifier: GPL-3.0-or-later
import { make } from "../page/dom";
import type { Numbers } from "./handle";

/// Numbers that would tell what is visible.
const tells = ["drawn", "visible", "hidden", "found", "missed", "wasted", "coverage", "visible_share", "per_visible",
    "wrong",
               "steps"];

export type GuessKind = "number" | "cell" | "option";

export class Guess {
  readonly kind: GuessKind;
  readonly asks: string;
  open = true;
  private readonly chips = make("div", { class: "chips" });
  private readonly verdict = make("p", { class: "verdict", hidden: true });

  constructor(private readonly form: HTMLFormElement, private readonly answer: HTMLElement,
              private readonly reveal: () => Numbers) {
    this.kind = form.dataset.kind as GuessKind;
    this.asks = form.dataset.asks!;
    if (this.kind === "number") {
      const input = make("input", { type: "number", inputmode: "numeric", min: 0, required: true, step: "any",
                                    "aria-labelledby": form.querySelector(".question")!.id });
      form.append(make("div", { class: "line" }, input, make("button", { type: "submit" }, "Guess")));
      form.addEventListener("submit", event => {
        event.preventDefault();
        if (input.value !== "") this.tryNumber(Number(input.value));
      });
    } else {
      form.addEventListener("submit", event => event.preventDefault());
      form.append(this.chips);
    }
    for (const option of form.querySelectorAll<HTMLElement>("[data-option]")) {
      const { option: means } = option.dataset, text = option.textContent!;
      this.chips.append(make("button", { type: "button", "data-option": means,
                                         onclick: () => this.tryOption(means!, text) }, text));
    }
    form.querySelector("ul")?.remove();
    answer.before(this.verdict);
    answer.hidden = true;
  }

  /// Whether a number would give the answer away.
  hides(name: string) { return this.open && (name === this.asks || (this.kind === "number" && tells.includes(name))); }

  /// Cells to choose from, by letters that the picture has too.
  offer(cells: number[], light: (cell: number | null) => void): { cell: number; text: string }[] {
    if (this.kind !== "cell" || !this.open) return [];
    const offered = cells.sort((a, b) => a - b).map((cell, i) => ({ cell, text: String.fromCharCode(65 + i) }));
    this.chips.replaceChildren(...offered.map(({ cell, text }) => {
      const chip = make("button", { type: "button", "data-cell": cell, "aria-label": `${text}, cell ${cell}`,
                                    onclick: () => this.tryCell(cell) }, text);
      for (const event of ["mouseenter", "focus"]) chip.addEventListener(event, () => light(cell));
      for (const event of ["mouseleave", "blur"]) chip.addEventListener(event, () => light(null));
      return chip;
    }));
    return offered;
  }

  tryCell(cell: number) {
    if (this.kind !== "cell" || !this.open) return;
    const before = this.asks;
    this.end(now => now[before]?.value === cell ? `Cell ${cell}: right.`
                                                 : `You took cell ${cell}. The method takes ${now[before]?.text}.`);
  }
  private tryNumber(number: number) {
    this.end(now => {
      const right = now[this.asks]?.value ?? NaN, off = Math.abs(number - right) / Math.max(1, Math.abs(right));
      const word = off < 1e-6 ? "Exactly right." : off < 0.15 ? "Very close." : off < 1 ? "Not far off." :
        number > right ? "Far fewer." : "Far more.";
      return `You said ${number}. It is ${now[this.asks]?.text ?? "unknown"}. ${word}`;
    });
  }
  private tryOption(option: string, text: string) {
    this.end(now => holds(option, this.asks, now) ? `“${text}”: right.` : `“${text}”: no, see what it does.`);
  }

  private end(words: (now: Numbers) => string) {
    if (!this.open) return;
    this.open = false;
    const now = this.reveal();
    this.verdict.textContent = words(now);
    this.verdict.hidden = this.answer.hidden = false;
    this.verdict.setAttribute("role", "status");
    this.form.querySelectorAll(".line *, .chips *").forEach(one => one.setAttribute("disabled", ""));
    this.form.dataset.tried = "yes";
  }
}

/// "a>b" compares two numbers; any other text is compared with the one that is asked for.
export function holds(option: string, asks: string, now: Numbers): boolean {
  const found = /^(\w+)([<>=])(\w+)$/.exec(option);
  if (!found) return now[asks]?.text === option;
  const [a, b] = [now[found[1]]?.value ?? NaN, now[found[3]]?.value ?? Number(found[3])];
  return found[2] === "<" ? a < b : found[2] === ">" ? a > b : a === b;
}
