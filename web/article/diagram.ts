// A diagram: a page of the core, its picture, what changes it, and the numbers of the prose that speak of it.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Module } from "../page/core";
import { make, rowElement } from "../page/dom";
import { CostChart, CrossedChart } from "./charts";
import { choice, showLegend, slider, Steps } from "./controls";
import { Guess } from "./guess";
import { DiagramCore, type Numbers, type ViewNow } from "./handle";
import type { DiagramSpec } from "./specs";
import { Stage } from "./stage";
import { raise } from "./values";

export class Diagram {
  core: DiagramCore | null = null;
  private readonly stage: Stage;
  private readonly steps: Steps | null = null;
  private readonly crossed: CrossedChart | null = null;
  private readonly cost: CostChart | null = null;
  private readonly legend = make("ul", { class: "legend", "aria-label": "Legend" });
  private readonly said = make("p", { class: "said", role: "status" });
  private readonly formula = make("div", { class: "formula" });
  private readonly guess: Guess | null = null;
  private readonly values: HTMLElement[];
  private readonly asked: string;
  private facts: Numbers = {};
  private now: (Numbers & { view: ViewNow }) | null = null;
  private saved: string | null = null;
  private edits = 0;
  private seen = false;
  private turn = 0;

  constructor(readonly id: string, readonly figure: HTMLElement, private readonly spec: DiagramSpec,
              private readonly module: () => Promise<{ module: Module; widths: number[] }>) {
    this.stage = new Stage(spec.handles ?? [], spec.shape, {
      moved: () => this.changed(true),
      tapped: (x, y, reach) => this.tapped(x, y, reach),
      pointed: (at, reach) => this.pointed(at, reach),
    });
    const stand = figure.querySelector<HTMLElement>(".stand")!, controls = make("div", { class: "controls" });
    if (spec.steps) controls.append((this.steps = new Steps(spec.steps, command => this.does(command, false))).element);
    for (const one of spec.sliders ?? []) controls.append(slider(one, command => this.does(command, true)));
    for (const one of spec.choices ?? []) controls.append(choice(one, id, command => this.does(command, true)));
    stand.replaceChildren(this.stage.element, controls);
    if (spec.chart === "crossed") {
      this.crossed = new CrossedChart(column => this.showRay(column));
      stand.append(this.crossed.element);
    }
    if (spec.chart === "cost") {
      this.cost = new CostChart(dot => this.does(`method "${dot.method}"; budget ${dot.budget}; run`, false));
      stand.append(this.cost.element);
    }
    stand.append(this.said, this.formula, this.legend);
    const form = figure.querySelector<HTMLFormElement>("form.guess");
    if (form) this.guess = new Guess(form, figure.querySelector<HTMLElement>(".answer")!, () => this.reveal());
    const all = [...document.querySelectorAll<HTMLElement>(`[data-value^="${id}."]`)];
    const thing = (value: HTMLElement) => spec.facts?.[value.dataset.value!.split(".").pop()!]?.place;
    this.values = all.map(value => raise(value, thing(value), name => this.light(name)));
    this.asked = all.map(value => value.dataset.value).join(" ");
    const task = figure.querySelector(".task");
    if (task) this.stage.element.setAttribute("aria-labelledby", task.id);
    this.stage.element.addEventListener("keydown", event => this.key(event));
  }

  /// A guess is open that a run would answer.
  private get sealed() { return !!this.guess?.open && this.guess.kind === "number"; }
  get running() { return this.core !== null; }

  async start() {
    if (this.core) return;
    const { module, widths } = await this.module();
    if (this.core) return;
    this.core = new DiagramCore(module, widths);
    if (this.saved) this.core.openState(this.saved);
    else this.begin(this.core);
    if (this.sealed) this.core.does("truth hide");
    this.refresh();
    if (this.guess?.kind === "cell" && this.guess.open) this.offerCells(this.core);
    if (!this.seen) setTimeout(() => this.askFacts(), 30);
    this.seen = true;
    if (this.cost) this.measure();
    if (this.spec.workOut && !this.guess?.open) this.workOut();
  }
  private offerCells(core: DiagramCore) {
    const front = core.panel("front").flatMap(row => row.cell === undefined ? [] : [row.cell]);
    const light = (cell: number | null) => this.light(cell === null ? null : `cell ${cell}`);
    this.stage.putBadges(this.guess!.offer(front, light).map(({ cell, text }) => {
      const corners = core.corners(cell);
      const mean = (i: 0 | 1) => corners.reduce((sum, p) => sum + p[i], 0) / corners.length;
      return { text, at: [mean(0), mean(1)] };
    }));
    this.redraw();
  }
  private begin(core: DiagramCore, open = this.spec.open, commands = this.spec.begin) {
    if (open.endsWith(".json")) core.openState(new TextDecoder().decode(core.files.readFile(open)));
    else core.open(open);
    if (commands) core.does(commands);
  }

  /// Far away: its state is kept as text, its memory given back, and the picture stays on its canvas.
  drop() {
    if (!this.core) return;
    this.saved = this.core.state();
    this.core.free();
    this.core = null;
    this.stage.letGo();
    this.figure.removeAttribute("data-ready");
  }

  does(commands: string, after: boolean) {
    if (!this.core) return;
    try {
      this.core.does(commands);
    } catch (error) {
      this.said.textContent = (error as Error).message;
      return;
    }
    this.changed(after);
    if (this.cost && commands.startsWith("open ")) {
      this.core.does(this.spec.begin);
      this.measure();
    }
  }
  private changed(after: boolean) {
    if (!this.core) return;
    if (after && this.spec.after && !this.sealed) this.core.does(this.spec.after);
    this.refreshSoon();
  }
  private pending = 0;
  private refreshSoon() {
    if (!this.pending) this.pending = requestAnimationFrame(() => { this.pending = 0; this.refresh(); });
  }
  /// The room for the picture has changed.
  redraw() { if (this.core && this.now) this.stage.draw(this.core, this.now.view, `${this.edits}`); }

  private refresh() {
    if (!this.core) return;
    const look = this.core.look(), now = this.core.numbers(this.asked);
    this.now = now;
    this.stage.draw(this.core, now.view, `${++this.edits}`);
    if (this.wanted) this.light(this.wanted);
    this.steps?.update(look, !!this.guess?.hides("steps"));
    if (this.steps) this.steps.element.inert = !!this.guess?.open && this.guess.kind !== "option";
    showLegend(this.legend, this.stage.legend ?? [], name => this.light(name));
    const words = this.spec.words ?? (this.spec.steps ? "step" : "result");
    const quiet = words === "none" || (this.guess?.open && this.guess.kind !== "option");
    const told = quiet ? "" : words === "verdict" ? now.verdict?.text ?? "" : words === "step" ? look.step :
      words === "technique" && now.technique ? `${now.region.text}: ${now.technique.text}. ${look.result}` :
        look.result ?? "";
    const text = told ? told[0].toUpperCase() + told.slice(1) + (/[.!]$/.test(told) ? "" : ".") : "";
    if (this.said.textContent !== text) this.said.textContent = text;
    this.stage.label = `${look.headline}. ${look.result ?? ""}`;
    if (this.spec.formula) this.showFormula();
    this.crossed?.update(this.core);
    this.fill();
    this.figure.dataset.ready = "yes";
  }

  /// The key of what the step took: a term under the mouse lights up in the picture.
  private showFormula() {
    const rows = this.core!.panel("why"), row = rows.find(one => one.parts && one.captions) ?? rows.find(one =>
        one.parts);
    const text = JSON.stringify(row ?? null);
    if (this.formula.dataset.of === text) return;
    this.formula.dataset.of = text;
    this.formula.replaceChildren(...(row && !this.guess?.open ? [rowElement(row, {
      run: () => {}, hover: () => {},
      light: (about, light) => this.stage.lightUp(about && this.core ? this.core.light(about, light) : []),
    })] : []));
  }

  private number(name: string): Numbers[string] | undefined { return this.facts[name] ?? this.now?.[name]; }
  private fill() {
    for (const value of this.values) {
      const name = value.dataset.value!.split(".").pop()!, hidden = this.guess?.hides(name);
      const text = hidden ? "?" : this.number(name)?.text ?? "…";
      if (value.textContent !== text) value.textContent = text;
      if (value instanceof HTMLButtonElement) value.disabled = !!hidden;
    }
  }

  /// Numbers of other runs that the prose tells: one after the other, on a page of their own.
  private async askFacts() {
    const facts = Object.entries(this.spec.facts ?? {});
    if (facts.length === 0) return;
    const { module, widths } = await this.module();
    for (const [name, fact] of facts) {
      const core = new DiagramCore(module, widths);
      try {
        this.begin(core, fact.open ?? this.spec.open, fact.open ? "" : this.spec.begin);
        core.does(fact.does);
        this.facts[name] = core.numbers(fact.of)[fact.of];
      } finally {
        core.free();
      }
      this.fill();
      await new Promise(done => setTimeout(done));
    }
    this.figure.dataset.facts = "yes";
  }

  private reveal(): Numbers {
    const asks = this.guess!.asks, told = { ...this.facts, ...this.now };
    this.stage.putBadges([]);
    if (this.core && this.spec.guess) this.core.does("truth tell; " + this.spec.guess.reveal);
    const [name, value] = this.spec.guess?.choose ?? [];
    const radio = this.figure.querySelector<HTMLInputElement>(`input[name="${this.id}-${name}"][value="${value}"]`);
    if (radio) radio.checked = true;
    if (this.spec.workOut) this.workOut();
    this.refresh();
    // What a step will take is known before it; anything else after the run.
    return { ...this.facts, ...this.now, ...(this.guess!.kind === "cell" ? { [asks]: told[asks] } : {}) } as Numbers;
  }

  private wanted: string | null = null;  // lit as soon as there is a core, and again whenever the picture changes
  light(name: string | null) {
    this.wanted = name;
    if (!this.core || (name && this.guess?.hides(name))) return;
    this.stage.lightUp(name ? this.core.place(name) : []);
  }
  private showRay(column: number) {
    if (!this.core || !this.now) return;
    const [x, y] = CrossedChart.through(this.now.view, column);
    this.stage.lightUp(this.core.place(`ray ${x},${y}`));
  }

  private tapped(x: number, y: number, reach: number) {
    if (!this.core) return;
    const under = this.core.names(x, y, reach);
    if (this.guess?.kind === "cell" && this.guess.open &&
        under.cell !== undefined) return this.guess.tryCell(under.cell);
    this.pointed([x, y], reach);
  }
  /// The other way: what lies under the mouse says which numbers count it.
  private pointed(at: [number, number] | null, reach: number) {
    const under = at && this.core ? this.core.names(at[0], at[1], reach) : null;
    const names = (under?.names ?? []).filter(name => !this.guess?.hides(name));
    for (const value of this.values) value.toggleAttribute("data-lit", names.includes(value.dataset.place ?? ""));
    for (const item of this.legend.querySelectorAll<HTMLElement>("[data-place]"))
      item.toggleAttribute("data-lit", names.includes(item.dataset.place!));
    this.stage.say(under?.words ?? "", at);
  }

  private key(event: KeyboardEvent) {
    if (!this.steps || this.steps.element.inert || event.target !== this.stage.element) return;
    const command = ({ ArrowRight: "step", ArrowLeft: "back", Home: "seek start", End: "run" } as
                     Record<string, string>)[event.key];
    if (!command) return;
    event.preventDefault();
    this.does(command, false);
  }

  /// Goes on while somebody looks, in slices that leave the page quick.
  private measure() {
    const core = this.core!;
    if (core.look().desk.right !== "trade-off") core.does("show trade-off");
    const turn = ++this.turn;
    const slice = () => {
      if (this.core !== core || turn !== this.turn) return;
      const more = core.idle(25), { dots, done, total } = core.dots();
      if (dots) this.cost!.update(dots, done!, total!);
      if (more) setTimeout(slice, 60);
      else this.figure.dataset.measured = "yes";
    };
    setTimeout(slice, 60);
  }
  private workOut() {
    const core = this.core!;
    core.workOut(0);
    core.does("work-out all");
    const slice = () => {
      if (this.core !== core) return;
      const more = core.workOut(25);
      this.refreshSoon();
      if (more) setTimeout(slice, 80);
      else this.figure.dataset.measured = "yes";
    };
    setTimeout(slice, 80);
  }
}
