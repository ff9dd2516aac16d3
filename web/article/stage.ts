// The picture of a diagram: the core's lists on a canvas, what is lit over it, and handles that can be dragged.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Light, Picture } from "../page/core";
import { make } from "../page/dom";
import { paintLabels, paintOnCanvas, toPixels, toScene, type View } from "../page/paint";
import type { DiagramCore, ViewNow } from "./handle";

/// A handle stands in the scene and moves by hand or by arrow keys.
export type HandleSpec = {
  id: string; label: string;
  at(view: ViewNow, core: DiagramCore): [number, number];
  move(core: DiagramCore, to: [number, number], view: ViewNow): void;
};

export type StageActions = { moved(done: boolean): void; tapped(x: number, y: number, reach: number): void;
                             pointed(at: [number, number] | null, reach: number): void };

export class Stage {
  readonly element = make("div", { class: "stage", tabindex: 0, role: "group" });
  private readonly ground = make("canvas", { role: "img" });
  private readonly over = make("canvas", { class: "over", "aria-hidden": "true" });
  private readonly tip = make("div", { class: "tip", hidden: true });
  private readonly handles = new Map<string, HTMLButtonElement>();
  private view: View = { world: [0, 0, 1, 1], width: 1, height: 1, unit: 1 };
  private ratio = 1;
  private lights: Light[] = [];
  private core: DiagramCore | null = null;
  private now: ViewNow | null = null;
  private held: { id: string; pointer: number } | null = null;
  private readonly badges: { at: [number, number]; element: HTMLElement }[] = [];
  legend: Picture["legend"] = [];

  constructor(private readonly specs: HandleSpec[], shape: number, private readonly actions: StageActions) {
    this.element.style.aspectRatio = String(shape);
    this.element.append(this.ground, this.over, this.tip);
    for (const spec of specs) this.addHandle(spec);
    this.ground.addEventListener("click", event => {
      const [x, y] = this.scene(event);
      this.actions.tapped(x, y, this.reach(12));
    });
    this.ground.addEventListener("pointermove", event => {
      if (event.pointerType === "mouse" && this.core) this.actions.pointed(this.scene(event), this.reach(6));
    });
    this.ground.addEventListener("pointerleave", () => this.actions.pointed(null, 0));
  }

  set label(text: string) { this.ground.setAttribute("aria-label", text); }
  private scene(event: MouseEvent): [number, number] {
    const box = this.ground.getBoundingClientRect();
    return toScene(this.view, (event.clientX - box.left) * this.ratio, (event.clientY - box.top) * this.ratio);
  }
  private reach(pixels: number) {
    return pixels * this.ratio * (this.view.world[2] - this.view.world[0]) / this.view.width;
  }

  private addHandle(spec: HandleSpec) {
    const handle = make("button", { type: "button", class: `handle ${spec.id.replace(/\d+/g, "")}`, "data-handle":
        spec.id,
                                    "aria-label": `${spec.label}: drag it, or move it with the arrow keys` });
    handle.addEventListener("pointerdown", event => {
      if (!this.core) return;
      event.preventDefault();
      handle.focus({ preventScroll: true });
      try { handle.setPointerCapture(event.pointerId); } catch { /* a pointer of a script */ }
      this.held = { id: spec.id, pointer: event.pointerId };
    });
    handle.addEventListener("pointermove", event => {
      if (this.held?.pointer === event.pointerId && this.core) this.put(spec, this.scene(event), false);
    });
    const end = (event: PointerEvent) => {
      if (this.held?.pointer !== event.pointerId) return;
      this.held = null;
      this.actions.moved(true);
    };
    handle.addEventListener("pointerup", end);
    handle.addEventListener("pointercancel", end);
    handle.addEventListener("keydown", event => {
      const way = ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] } as
                   Record<string, [number, number]>)[event.key];
      if (!way || !this.core || !this.now) return;
      event.preventDefault();
      event.stopPropagation();
      const [x, y] = spec.at(this.now, this.core), far = this.reach(event.shiftKey ? 32 : 8);
      this.put(spec, [x + way[0] * far, y + way[1] * far], true);
    });
    this.handles.set(spec.id, handle);
    this.element.append(handle);
  }
  private put(spec: HandleSpec, to: [number, number], done: boolean) {
    const [x0, y0, x1, y1] = this.view.world, edge = this.reach(8);
    const clamp = (v: number, low: number, high: number) => Math.min(Math.max(v, low + edge), high - edge);
    spec.move(this.core!, [clamp(to[0], x0, x1), clamp(to[1], y0, y1)], this.now!);
    this.actions.moved(done);
  }

  private painted = "";
  /// Makes the picture for the room that there is; the same picture is left alone.
  draw(core: DiagramCore, now: ViewNow, state: string) {
    this.core = core;
    this.now = now;
    const { clientWidth: w, clientHeight: h } = this.element;
    if (w < 2 || h < 2) return;
    this.ratio = Math.min(window.devicePixelRatio || 1, 3);
    const width = Math.round(w * this.ratio), height = Math.round(h * this.ratio), key = `${state} ${width} ${height}`;
    if (key !== this.painted) {
      this.painted = key;
      for (const canvas of [this.ground, this.over])
        if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
      const picture = core.picture(0, width, height, this.ratio);
      if (!picture.world) return;
      this.view = { world: picture.world, width, height, unit: this.ratio };
      // What numbers on cells mean is of interest where there are any.
      this.legend = (picture.legend ?? []).filter(row => row.style.fill || row.style.stroke ||
          picture.labels.length > 0);
      const to = this.ground.getContext("2d")!;
      to.setLineDash([]);
      to.fillStyle = picture.background;
      to.fillRect(0, 0, width, height);
      for (const list of picture.lists) paintOnCanvas(core, list, this.view, to);
      paintLabels(picture.labels, this.ratio, to);
    }
    for (const spec of this.specs) {
      const [x, y] = toPixels(this.view, ...spec.at(now, core)), handle = this.handles.get(spec.id)!;
      handle.style.left = `${x / this.ratio}px`;
      handle.style.top = `${y / this.ratio}px`;
    }
    for (const { at, element } of this.badges) {
      const [x, y] = toPixels(this.view, ...at);
      element.style.left = `${x / this.ratio}px`;
      element.style.top = `${y / this.ratio}px`;
    }
    this.drawOver();
  }
  /// Letters on the picture, for what stands beside it in words. While they stand there is nothing to drag.
  putBadges(badges: { text: string; at: [number, number] }[]) {
    for (const old of this.badges.splice(0)) old.element.remove();
    for (const { text, at } of badges) {
      const element = make("span", { class: "badge", "aria-hidden": "true" }, text);
      this.badges.push({ at, element });
      this.element.append(element);
    }
    for (const handle of this.handles.values()) handle.hidden = badges.length > 0;
  }
  /// Nobody to ask until the next draw(): the picture stays.
  letGo() {
    this.core = null;
    this.painted = "";
    this.lightUp([]);
  }

  lightUp(lights: Light[]) {
    this.lights = lights;
    this.element.toggleAttribute("data-lit", lights.length > 0);
    this.drawOver();
  }
  private drawOver() {
    const to = this.over.getContext("2d")!;
    to.clearRect(0, 0, this.over.width, this.over.height);
    to.lineJoin = to.lineCap = "round";
    for (const [colour, width] of [["#fff", 7], ["#d6006c", 3.2]] as const) {
      to.strokeStyle = colour;
      to.lineWidth = width * this.ratio * (this.lights.length > 300 ? 0.6 : 1);
      for (const light of this.lights) {
        to.beginPath();
        light.points.forEach(([x, y], i) => to[i ? "lineTo" : "moveTo"](...toPixels(this.view, x, y)));
        if (light.closed) to.closePath();
        to.stroke();
      }
    }
  }

  say(text: string, at: [number, number] | null) {
    this.tip.hidden = !text || !at;
    if (!at) return;
    this.tip.textContent = text;
    const [x, y] = toPixels(this.view, ...at).map(v => v / this.ratio), w = this.element.clientWidth;
    this.tip.style.left = x > w * 0.5 ? "auto" : `${x + 14}px`;
    this.tip.style.right = x > w * 0.5 ? `${w - x + 14}px` : "auto";
    this.tip.style.top = `${Math.min(y + 14, this.element.clientHeight - 44)}px`;
  }
}
