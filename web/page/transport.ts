// The bar under the picture: play and step, how much is found, where the run stands.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Curve, Look } from "./core";
import { byId, icon, make } from "./dom";

type Actions = { run(command: string): void; seek(step: number): void };

export class Transport {
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private readonly slider = make("input", { type: "range", min: 0, max: 1, step: 1, "aria-label": "Step of the run" });
  private readonly chart = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  private readonly where = make("span", { class: "where" });
  private curveOf = "";

  constructor(actions: Actions) {
    const bar = byId("transport");
    const button = (name: string, command: string, label: string) => {
      const made = make("button", { type: "button", title: label, "aria-label": label,
                                    onclick: () => actions.run(command) }, icon(name));
      this.buttons.set(name, made);
      bar.append(made);
    };
    button("start", "seek start", "To the start (Home)");
    button("back", "back", "One step back (Left)");
    button("play", "toggle", "Play or pause (Space)");
    button("step", "step", "One step forward (Right)");
    button("end", "run", "To the end (End)");
    this.chart.setAttribute("preserveAspectRatio", "none");
    this.chart.setAttribute("aria-hidden", "true");
    const track = make("div", { class: "track" });
    track.append(this.chart, this.slider);
    bar.append(track, this.where);
    this.slider.addEventListener("input", () => actions.seek(Number(this.slider.value)));
  }

  update(look: Look, curve: () => Curve) {
    this.slider.max = String(Math.max(look.recorded, 1));
    this.slider.value = String(look.position);
    this.slider.setAttribute("aria-valuetext", `step ${look.position} of ${look.recorded}`);
    this.where.textContent = `step ${look.position} of ${look.recorded}`;
    const playing = look.state === "playing", button = this.buttons.get("play")!;
    if (button.getAttribute("aria-pressed") !== String(playing)) {
      button.replaceChildren(icon(playing ? "pause" : "play"));
      button.setAttribute("aria-pressed", String(playing));
    }
    this.buttons.get("start")!.disabled = this.buttons.get("back")!.disabled = look.position === 0;
    this.buttons.get("step")!.disabled = this.buttons.get("end")!.disabled = look.position >= look.recorded;
    const key = `${look.run} ${look.recorded} ${look.panes}`;
    if (key !== this.curveOf) {
      this.curveOf = key;
      this.draw(curve(), look.recorded);
    }
    const at = 1000 * look.position / Math.max(look.recorded, 1);
    this.chart.querySelector(".here")?.setAttribute("d", `M${at} 0V100`);
  }
  /// What it tells may have changed without a new run.
  forget() { this.curveOf = ""; }

  private draw(curve: Curve, steps: number) {
    this.chart.setAttribute("viewBox", "0 0 1000 100");
    const way = (values: (number | null)[] | undefined) => {
      if (!values?.length || !curve.tells) return "";
      let text = "M0 96";
      const every = Math.max(1, Math.floor(values.length / 600));
      for (let i = 0; i < values.length; i += every)
        if (values[i] !== null) text += `L${((i + 1) / steps * 1000).toFixed(1)} ${(96 - 90 * values[i]!).toFixed(1)}`;
      return text;
    };
    const line = (d: string, colour: string, more = "") =>
      d && `<path d="${d}" fill="none" stroke="${colour}" stroke-width="2" vector-effect="non-scaling-stroke" ` +
           `${more}/>`;
    const wasted = curve.tells ? (curve.cell ?? []).map((_, i) =>
      curve.hidden![i] > 0 && curve.visible![i] === 0 ? `M${(i + 1) / steps * 1000} 100V92` : "").join("") : "";
    this.chart.innerHTML =
      line(wasted, "#c2410c") + line(way(curve.oracle), "var(--faint)", 'stroke-dasharray="2 4"') +
      line(way(curve.other), "#9f5000") + line(way(curve.coverage), "var(--good)") +
      (curve.bookmarks ?? []).map(({ step }) => line(`M${step / Math.max(steps, 1) * 1000} 0V40`, "var(--accent)"))
        .join("") +
      '<path class="here" d="" fill="none" stroke="var(--ink)" stroke-width="2" vector-effect="non-scaling-stroke"/>';
  }
}
