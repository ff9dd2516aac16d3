// A picture of the core put down on a canvas or as SVG: shapes in their order, then labels. Nothing is decided here.
// SPDX-License-Identifier: GPL-3.0-or-later
import { shapeBytes, type Core, type List, type Picture, type PlacedLabel, type Style } from "./core";

export type View = { world: [number, number, number, number]; width: number; height: number; unit: number };
const thinnest = 0.5, pointPixels = 4 / 3;
export const labelFont = "'DejaVu Sans', Verdana, system-ui, sans-serif";

export const toPixels = (view: View, x: number, y: number): [number, number] => {
  const scale = view.width / (view.world[2] - view.world[0]);
  return [(x - view.world[0]) * scale, view.height - (y - view.world[1]) * scale];
};
export const toScene = (view: View, x: number, y: number): [number, number] => {
  const scale = view.width / (view.world[2] - view.world[0]);
  return [view.world[0] + x / scale, view.world[1] + (view.height - y) / scale];
};

/// What shapes are put down on: runs of points, each closed or not, and circles, that share one look.
interface Sheet {
  begin(): void;
  run(points: number[], closed: boolean): void;
  circle(x: number, y: number, radius: number): void;
  end(style: Style, fill: boolean, stroke: boolean, view: View): void;
}

const dashes = (style: Style, width: number) =>
  style.dash === "dashed" ? [4 * width, 3 * width] : style.dash === "dotted" ? [width, 2 * width] : [];

class CanvasSheet implements Sheet {
  private path = new Path2D();
  constructor(private readonly to: CanvasRenderingContext2D) {}
  begin() { this.path = new Path2D(); }
  run(points: number[], closed: boolean) {
    this.path.moveTo(points[0], points[1]);
    for (let i = 2; i < points.length; i += 2) this.path.lineTo(points[i], points[i + 1]);
    if (closed) this.path.closePath();
  }
  circle(x: number, y: number, radius: number) {
    this.path.moveTo(x + radius, y);
    this.path.arc(x, y, radius, 0, 2 * Math.PI);
  }
  end(style: Style, fill: boolean, stroke: boolean, view: View) {
    if (fill && style.fill) {
      this.to.fillStyle = style.fill;
      this.to.fill(this.path);
    }
    if (fill && style.hatch) {
      this.to.fillStyle = hatch(this.to, style, view.unit);
      this.to.fill(this.path);
    }
    if (stroke && style.stroke) {
      const width = Math.max(style.width, thinnest) * pointPixels * view.unit;
      this.to.strokeStyle = style.stroke;
      this.to.lineWidth = width;
      this.to.lineJoin = "round";
      this.to.setLineDash(dashes(style, width));
      this.to.stroke(this.path);
    }
  }
}

const patterns = new Map<string, CanvasPattern>();
function hatch(to: CanvasRenderingContext2D, style: Style, unit: number): CanvasPattern {
  const key = `${style.hatch} ${style.hatchColour} ${unit}`;
  const known = patterns.get(key);
  if (known) return known;
  const side = Math.round(6 * unit), tile = document.createElement("canvas");
  tile.width = tile.height = side;
  const on = tile.getContext("2d")!;
  on.strokeStyle = on.fillStyle = style.hatchColour!;
  on.lineWidth = Math.max(0.7 * unit, 0.7);
  on.beginPath();
  const line = (x0: number, y0: number, x1: number, y1: number) => { on.moveTo(x0, y0); on.lineTo(x1, y1); };
  for (const k of [-1, 0, 1]) {
    if (style.hatch === "diagonal" || style.hatch === "cross") line(k * side, side, (k + 1) * side, 0);
    if (style.hatch === "back_diagonal" || style.hatch === "cross") line(k * side, 0, (k + 1) * side, side);
  }
  if (style.hatch === "horizontal") line(0, side / 2, side, side / 2);
  on.stroke();
  if (style.hatch === "dots") on.fillRect(side / 2 - 1, side / 2 - 1, 1.5 * unit, 1.5 * unit);
  const made = to.createPattern(tile, "repeat")!;
  patterns.set(key, made);
  return made;
}

const round = (n: number) => String(Math.round(n * 100) / 100);
export const escaped = (text: string) =>
  text.replace(/[&<>"]/g, c => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]!);

class SvgSheet implements Sheet {
  body = "";
  private path = "";
  begin() { this.path = ""; }
  run(points: number[], closed: boolean) {
    for (let i = 0; i < points.length; i += 2)
      this.path += (i === 0 ? "M" : "L") + round(points[i]) + " " + round(points[i + 1]);
    if (closed) this.path += "Z";
  }
  circle(x: number, y: number, r: number) {
    this.path += `M${round(x - r)} ${round(y)}a${round(r)} ${round(r)} 0 1 0 ${round(2 * r)} 0` +
                 `a${round(r)} ${round(r)} 0 1 0 ${round(-2 * r)} 0Z`;
  }
  end(style: Style, fill: boolean, stroke: boolean, view: View) {
    const width = Math.max(style.width, thinnest) * pointPixels * view.unit;
    const line = stroke && style.stroke
      ? ` stroke="${style.stroke}" stroke-width="${round(width)}" stroke-linejoin="round"` +
        (style.dash ? ` stroke-dasharray="${dashes(style, width).map(round).join(" ")}"` : "") : "";
    const inside = fill && style.fill ? style.fill : "none";
    this.body += `<path class="${style.name}" fill="${inside}"${line} d="${this.path}"/>\n`;
  }
}

const kinds = ["polygon", "polyline", "disc", "ring", "cross", "arrow"];

function paintList(core: Core, list: List, view: View, sheet: Sheet) {
  const { points, bytes, shorts, words, sizes, count } = core.shapes(list);
  const pt = pointPixels * view.unit;
  let style = -1, kind = -1, open = false;
  const close = () => {
    if (!open) return;
    const fills = kind === 0 || kind === 2;
    sheet.end(list.styles[style], fills, true, view);
    open = false;
  };
  for (let i = 0; i < count; ++i) {
    const nextKind = bytes[i * shapeBytes], nextStyle = shorts[i * 12 + 1];
    const first = words[i * 6 + 1], size = words[i * 6 + 2], reach = sizes[i * 3 + 2] * pt;
    if (!list.styles[nextStyle]) continue;
    const see = list.styles[nextStyle];
    // Shapes that share a look are one path, unless they are filled through, where overlaps would show.
    const through = (see.fill?.length === 9 && !see.fill.endsWith("ff")) || (see.fill && see.stroke);
    if (nextStyle !== style || nextKind !== kind || through || nextKind === 5) close();
    if (!open) { sheet.begin(); open = true; }
    style = nextStyle;
    kind = nextKind;
    const run: number[] = [];
    for (let k = first; k < first + size; ++k) {
      const [x, y] = toPixels(view, points[2 * k], points[2 * k + 1]);
      run.push(x, y);
    }
    if (kinds[kind] === "polygon") sheet.run(run, true);
    else if (kinds[kind] === "polyline") sheet.run(run, false);
    else if (kinds[kind] === "disc" || kinds[kind] === "ring") sheet.circle(run[0], run[1], reach);
    else if (kinds[kind] === "cross") {
      sheet.run([run[0] - reach, run[1] - reach, run[0] + reach, run[1] + reach], false);
      sheet.run([run[0] - reach, run[1] + reach, run[0] + reach, run[1] - reach], false);
    } else arrow(run, reach || Math.max(4 * pt, 4 * see.width * pt), see, view, sheet), open = false;
  }
  close();
}

function arrow(run: number[], head: number, style: Style, view: View, sheet: Sheet) {
  const n = run.length, [x, y] = [run[n - 2], run[n - 1]];
  const dx = x - run[n - 4], dy = y - run[n - 3], length = Math.hypot(dx, dy);
  if (!(length > 0)) return;
  const ux = dx / length, uy = dy / length, back = Math.min(0.8 * head, length);
  sheet.run([...run.slice(0, n - 2), x - ux * back, y - uy * back], false);
  sheet.end(style, false, true, view);
  sheet.begin();
  sheet.run([x, y, x - head * (ux - 0.38 * uy), y - head * (uy + 0.38 * ux), x - head * (ux + 0.38 * uy),
             y - head * (uy - 0.38 * ux)], true);
  sheet.end({ name: style.name, width: style.width, fill: style.stroke }, true, false, view);
  sheet.begin();
}

function leaderRun(label: PlacedLabel, unit: number, put: (points: number[], fill: boolean) => void) {
  const [x0, y0, x1, y1] = label.leader!, length = Math.hypot(x1 - x0, y1 - y0) || 1;
  const ux = (x1 - x0) / length, uy = (y1 - y0) / length, head = 7 * unit;
  put([x0, y0, x1 - ux * head, y1 - uy * head], false);
  put([x1, y1, x1 - head * (ux - 0.38 * uy), y1 - head * (uy + 0.38 * ux), x1 - head * (ux + 0.38 * uy),
       y1 - head * (uy - 0.38 * ux)], true);
}

/// One of the picture's lists. The lower ones are kept by who paints, for steps change only the last.
export function paintOnCanvas(core: Core, list: List, view: View, to: CanvasRenderingContext2D) {
  paintList(core, list, view, new CanvasSheet(to));
}

export function paintLabels(labels: PlacedLabel[], unit: number, to: CanvasRenderingContext2D) {
  to.textAlign = "center";
  to.textBaseline = "middle";
  to.lineJoin = "round";
  to.setLineDash([]);
  for (const label of labels)
    if (label.leader)
      leaderRun(label, unit, (points, fill) => {
        to.beginPath();
        to.moveTo(points[0], points[1]);
        for (let i = 2; i < points.length; i += 2) to.lineTo(points[i], points[i + 1]);
        to.strokeStyle = to.fillStyle = label.colour;
        to.lineWidth = 1.2 * unit;
        fill ? to.fill() : to.stroke();
      });
  for (const label of labels) {
    to.font = `${label.size}px ${labelFont}`;
    if (label.disc) {
      to.fillStyle = label.disc;
      to.beginPath();
      to.arc(label.x, label.y, label.radius!, 0, 2 * Math.PI);
      to.fill();
    }
    if (label.halo) {
      to.strokeStyle = label.halo;
      to.lineWidth = 4 * unit;
      to.strokeText(label.text, label.x, label.y);
    }
    to.fillStyle = label.colour;
    to.fillText(label.text, label.x, label.y);
  }
}

/// The whole picture as a document of its own; `under`: an image that lies below it.
export function asSvg(core: Core, picture: Picture, view: View, title: string, under?: string): string {
  const sheet = new SvgSheet();
  for (const list of picture.lists) paintList(core, list, view, sheet);
  for (const label of picture.labels) {
    if (label.leader)
      leaderRun(label, view.unit, (points, fill) => {
        sheet.begin();
        sheet.run(points, fill);
        sheet.end({ name: "leader", width: 1, fill: label.colour, stroke: label.colour }, fill, !fill, view);
      });
    if (label.disc)
      sheet.body += `<circle cx="${round(label.x)}" cy="${round(label.y)}" r="${round(label.radius!)}" ` +
                    `fill="${label.disc}"/>\n`;
    const halo = label.halo
      ? ` stroke="${label.halo}" stroke-width="${round(4 * view.unit)}" paint-order="stroke"` : "";
    sheet.body += `<text x="${round(label.x)}" y="${round(label.y)}" font-size="${round(label.size)}" ` +
                  `fill="${label.colour}"${halo}>${escaped(label.text)}</text>\n`;
  }
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${view.width}" height="${view.height}" ` +
         `viewBox="0 0 ${view.width} ${view.height}" font-family="${escaped(labelFont)}" text-anchor="middle" ` +
         `dominant-baseline="central"><title>${escaped(title)}</title>\n` +
         `<rect width="100%" height="100%" fill="${picture.background}"/>\n` +
         (under ? `<image width="100%" height="100%" href="${under}"/>\n` : "") + `${sheet.body}</svg>\n`;
}
