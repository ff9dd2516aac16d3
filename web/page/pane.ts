// A pane of the picture: canvases over each other, the legend, and fingers, mouse and pinch on it.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Core, Light, Picture } from "./core";
import { make } from "./dom";
import { SolidCanvas } from "./solid";
import { asSvg, escaped, paintLabels, paintOnCanvas, toPixels, toScene, type View } from "./paint";

export type PaneActions = {
  changed(): void;         // the picture is to be made again
  run(command: string): void;
  turn(right: number, up: number): boolean;  // a flight's eye; false: nobody flies
  hover(cell: number | null): void;
};

const reachOf = (event: PointerEvent) => event.pointerType === "touch" ? 24 : 9;

export class Pane {
  readonly element = make("div", { class: "pane" });
  private readonly ground = make("canvas", {
    role: "img", "aria-label": "Plan of the scene; the panel tells what it shows" });
  private readonly over = make("canvas", { class: "over", "aria-hidden": "true" });
  private readonly head = make("p", { class: "head", hidden: true });
  private readonly legend = make("ul", { class: "legend", hidden: true });
  private readonly tip = make("div", { class: "tip", hidden: true });
  private picture: Picture | null = null;
  private view: View = { world: [0, 0, 1, 1], width: 0, height: 0, unit: 1 };
  private ratio = 1;
  private readonly fingers = new Map<number, [number, number]>();
  private drag: { id: number; view: View; moved: boolean; eye: boolean; at: [number, number] } | null = null;
  private pinch: { apart: number; at: [number, number] } | null = null;
  private lastTap = 0;
  private outlined: [number, number][] = [];
  private lights: Light[] = [];
  private solid: SolidCanvas | null = null;
  private readonly still = document.createElement("canvas");
  private stillOf = "";

  constructor(private readonly core: Core, private readonly side: number, private readonly actions: PaneActions) {
    this.element.append(this.ground, this.over, this.head, this.legend, this.tip);
    const canvas = this.ground;
    canvas.addEventListener("pointerdown", event => this.down(event));
    canvas.addEventListener("pointermove", event => this.move(event));
    canvas.addEventListener("pointerup", event => this.up(event, false));
    canvas.addEventListener("pointercancel", event => this.up(event, true));
    canvas.addEventListener("pointerleave", () => { this.tip.hidden = true; this.actions.hover(null); });
    canvas.addEventListener("wheel", event => {
      if (event.ctrlKey) return;
      event.preventDefault();
      const [x, y] = this.scene(event), turns = Math.sign(event.deltaY) * Math.min(1, Math.abs(event.deltaY) / 60);
      const factor = Math.pow(1.2, -turns);
      if (this.picture?.solid) return this.actions.run(`zoom ${factor.toFixed(4)}`);
      this.core.magnify(x, y, factor);
      this.actions.changed();
    }, { passive: false });
  }

  /// Whether a hand is on it: then the picture is made again, and panels wait.
  get busy() { return this.drag?.moved === true || this.pinch !== null; }

  private pixels(event: MouseEvent): [number, number] {
    const box = this.ground.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
  private scene(event: MouseEvent, view = this.view): [number, number] {
    const [x, y] = this.pixels(event);
    return toScene(view, x * this.ratio, y * this.ratio);
  }
  private reach(event: PointerEvent) {
    return reachOf(event) * this.ratio * (this.view.world[2] - this.view.world[0]) / this.view.width;
  }

  private down(event: PointerEvent) {
    if (!this.picture?.world || this.side !== 0) return;
    try { this.ground.setPointerCapture(event.pointerId); } catch { /* a pointer of a script */ }
    this.fingers.set(event.pointerId, this.pixels(event));
    this.tip.hidden = true;
    if (this.fingers.size === 2) {
      this.stop(true);
      const [a, b] = [...this.fingers.values()];
      this.pinch = { apart: Math.hypot(a[0] - b[0], a[1] - b[1]), at: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2] };
      return;
    }
    const [x, y] = this.scene(event);
    const eye = this.core.take(x, y, 1.6 * this.reach(event));
    this.drag = { id: event.pointerId, view: this.view, moved: false, eye, at: this.pixels(event) };
  }

  private move(event: PointerEvent) {
    if (this.fingers.has(event.pointerId)) this.fingers.set(event.pointerId, this.pixels(event));
    if (this.pinch && this.fingers.size === 2) {
      const [a, b] = [...this.fingers.values()], apart = Math.hypot(a[0] - b[0], a[1] - b[1]);
      const middle: [number, number] = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
      const [x, y] = toScene(this.view, middle[0] * this.ratio, middle[1] * this.ratio);
      const factor = apart / Math.max(this.pinch.apart, 1);
      this.pinch = { apart, at: middle };
      if (this.picture?.solid) return this.actions.run(`zoom ${factor.toFixed(4)}`);
      this.core.magnify(x, y, factor);
      this.actions.changed();
      return;
    }
    if (!this.drag) {
      if (event.pointerType === "mouse" && this.picture?.world && !this.picture.solid) this.look(event);
      return;
    }
    const at = this.pixels(event);
    if (!this.drag.moved && Math.hypot(at[0] - this.drag.at[0], at[1] - this.drag.at[1]) < 4) return;
    this.drag.moved = true;
    if (this.picture?.solid) {
      const [dx, dy] = [at[0] - this.drag.at[0], at[1] - this.drag.at[1]];
      this.drag.at = at;
      if (this.actions.turn(dx / 5, -dy / 5)) return;
      return this.actions.run(`orbit ${(-dx / 3).toFixed(2)},${(dy / 3).toFixed(2)}`);
    }
    const [x, y] = this.scene(event, this.drag.eye ? this.drag.view : this.view);
    this.core.drag(x, y);
    this.actions.changed();
  }

  private up(event: PointerEvent, cancelled: boolean) {
    this.fingers.delete(event.pointerId);
    if (this.pinch) {
      if (this.fingers.size === 0) this.pinch = null;
      return;
    }
    if (!this.drag || this.drag.id !== event.pointerId) return;
    const { moved } = this.drag;
    const [x, y] = this.scene(event), reach = this.reach(event);
    this.stop(cancelled);
    if (!moved && !cancelled && this.picture?.solid) this.core.tap(x, y, reach / 1.5);
    else if (!moved && !cancelled) {
      const twice = event.timeStamp - this.lastTap < 350;
      this.lastTap = event.timeStamp;
      twice ? this.core.tapTwice(x, y) : this.core.tap(x, y, reach / 1.5);
    }
    this.actions.changed();
  }

  private stop(back: boolean) {
    if (!this.drag) return;
    this.drag = null;
    this.core.letGo(back);
  }
  /// Escape: as if the drag had not been.
  cancel(): boolean {
    const had = this.drag !== null;
    this.stop(true);
    return had;
  }

  private look(event: PointerEvent) {
    const [x, y] = this.scene(event), under = this.core.under(x, y, this.reach(event) / 1.5);
    const at = this.pixels(event);
    this.actions.hover(under.cell ?? null);
    this.tip.textContent = under.eye ? "drag: move the eye" : under.drag ?? under.words ?? "";
    this.tip.hidden = !this.tip.textContent;
    this.ground.style.cursor = under.eye || under.drag ? "grab" : "crosshair";
    const left = at[0] > this.element.clientWidth * 0.55;
    this.tip.style.left = left ? "auto" : `${at[0] + 14}px`;
    this.tip.style.right = left ? `${this.element.clientWidth - at[0] + 14}px` : "auto";
    this.tip.style.top = `${Math.min(at[1] + 14, this.element.clientHeight - 40)}px`;
  }

  /// Makes the picture anew for the room that there is.
  draw(withLegend: boolean) {
    const { clientWidth: w, clientHeight: h } = this.element;
    if (w < 2 || h < 2) return;
    this.ratio = Math.min(window.devicePixelRatio || 1, 3);
    const width = Math.round(w * this.ratio), height = Math.round(h * this.ratio);
    for (const canvas of [this.ground, this.over])
      if (canvas.width !== width || canvas.height !== height) {
        canvas.width = width;
        canvas.height = height;
      }
    const picture = this.core.picture(this.side, width, height, this.ratio);
    this.picture = picture;
    const to = this.ground.getContext("2d")!;
    if (!picture.world) {
      to.clearRect(0, 0, width, height);
      return;
    }
    this.view = { world: picture.world, width, height, unit: this.ratio };
    to.setLineDash([]);
    if (picture.solid) {
      if (!this.solid) this.element.prepend((this.solid = new SolidCanvas()).element);
      this.solid.draw(picture.solid, this.core.memory, width, height);
      to.clearRect(0, 0, width, height);
    } else {
      to.fillStyle = picture.background;
      to.fillRect(0, 0, width, height);
    }
    for (const [layer, list] of picture.lists.entries())
      layer === 1 && picture.still ? this.paintStill(picture, to) : paintOnCanvas(this.core, list, this.view, to);
    paintLabels(picture.labels, this.ratio, to);
    this.head.hidden = !picture.head;
    this.head.textContent = picture.head ?? "";
    this.drawLegend(withLegend ? picture : null);
    this.drawOver();
  }

  /// The borders of the cells, which no step changes, are painted once.
  private paintStill(picture: Picture, to: CanvasRenderingContext2D) {
    const { width, height } = this.view, of = `${picture.still} ${width} ${height}`;
    if (of !== this.stillOf) {
      this.stillOf = of;
      this.still.width = width;
      this.still.height = height;
      paintOnCanvas(this.core, picture.lists[1], this.view, this.still.getContext("2d")!);
    }
    to.drawImage(this.still, 0, 0);
  }

  private drawLegend(picture: Picture | null) {
    const rows = picture?.legend ?? [];
    this.legend.hidden = rows.length === 0;
    const html = rows.map(row => {
      const { fill, stroke, dash } = row.style;
      const line = stroke ? ` stroke="${stroke}" stroke-width="1.6"${dash ? ' stroke-dasharray="4 3"' : ""}` : "";
      const shape = row.swatch === "polygon"
        ? `<rect x="1" y="1" width="18" height="10" fill="${fill ?? "none"}"${line}/>`
        : row.swatch === "disc" || row.swatch === "ring"
          ? `<circle cx="10" cy="6" r="4" fill="${row.swatch === "disc" ? fill ?? "none" : "none"}"${line}/>`
          : `<path d="M1 6h18" fill="none"${line}/>`;
      return `<li><svg viewBox="0 0 20 12" aria-hidden="true">${shape}</svg>${escaped(row.text)}</li>`;
    }).join("");
    const bar = picture?.bar;
    const scale = bar ? `<li>${escaped(bar.title)}: ${escaped(bar.low)} ` +
      `<span style="display:inline-block;width:60px;height:10px;` +
      `background:linear-gradient(90deg,${bar.stops.join(",")})"></span> ${escaped(bar.high)}</li>` : "";
    if (this.legend.innerHTML !== html + scale) this.legend.innerHTML = html + scale;
  }

  outline(cell: number | null) {
    this.outlined = cell === null ? [] : this.core.corners(cell);
    this.drawOver();
  }
  lightUp(lights: Light[]) {
    this.lights = lights;
    this.drawOver();
  }
  private drawOver() {
    const to = this.over.getContext("2d")!;
    to.clearRect(0, 0, this.over.width, this.over.height);
    to.lineJoin = "round";
    const line = (points: [number, number][], closed: boolean, colour: string, width: number) => {
      to.beginPath();
      points.forEach(([x, y], i) => to[i ? "lineTo" : "moveTo"](...toPixels(this.view, x, y)));
      if (closed) to.closePath();
      to.strokeStyle = colour;
      to.lineWidth = width * this.ratio;
      to.stroke();
    };
    if (this.outlined.length > 2) {
      line(this.outlined, true, "#ffffff", 5);
      line(this.outlined, true, "#1b1f24", 2.2);
    }
    for (const light of this.lights) {
      line(light.points, light.closed, "#ffffff", 7);
      line(light.points, light.closed, this.picture?.accent ?? "#d00", 3.5);
    }
  }

  svg(title: string): string {
    const under = this.picture?.solid && this.solid ? this.solid.element.toDataURL("image/png") : undefined;
    const picture = this.core.picture(this.side, this.view.width, this.view.height, this.view.unit);
    return asSvg(this.core, picture, this.view, title, under);
  }
  png(): Promise<Blob> {
    const all = make("canvas", { width: this.ground.width, height: this.ground.height }), to = all.getContext("2d")!;
    if (this.picture?.solid && this.solid) to.drawImage(this.solid.element, 0, 0);
    to.drawImage(this.ground, 0, 0);
    return new Promise((done, fail) => all.toBlob(blob => blob ? done(blob) : fail(new Error("no picture"))));
  }
}
