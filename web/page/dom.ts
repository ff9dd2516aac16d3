// Elements, and the rows of panels as elements.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Row } from "./core";

type Attributes = Record<string, string | number | boolean | ((event: never) => void) | undefined>;

/// `on…` attributes are listeners; false and undefined leave an attribute out.
export function make<K extends keyof HTMLElementTagNameMap>(
    name: K, attributes: Attributes = {}, ...inside: (Node | string)[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (typeof value === "function") element.addEventListener(key.slice(2), value as (event: Event) => void);
    else element.setAttribute(key, value === true ? "" : String(value));
  }
  element.append(...inside);
  return element;
}

export const byId = (id: string) => document.getElementById(id)!;

const shapes: Record<string, string> = {
  start: "M3 3h3v14H3zM17 3v14L7 10z", back: "M14 3v14L4 10z", play: "M5 3v14l12-7z",
  pause: "M4 3h4v14H4zM12 3h4v14h-4z", step: "M4 3v14l9-7zM14 3h3v14h-3z",
  end: "M3 3v14l7-7zM10 3v14l5-7zM15 3h3v14h-3z",
};
export function icon(name: string): SVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 20 20");
  svg.setAttribute("class", "icon");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", shapes[name]);
  svg.append(path);
  return svg;
}

export type RowActions = {
  run(command: string): void;
  hover(cell: number | null): void;
  light(about: number, light: [number, number, number]): void;
};

function formula(row: Row, actions: RowActions): Node[] {
  return row.parts!.map(part => {
    if (!part.about) return part.text;
    const term = make("span", { class: `term about${part.about}`, tabindex: 0, title: part.name ?? "" }, part.text);
    if (row.captions && part.name) term.append(make("small", {}, part.name));
    const show = () => actions.light(part.about!, row.light!), hide = () => actions.light(0, row.light!);
    for (const name of ["mouseenter", "focus", "click"]) term.addEventListener(name, show);
    for (const name of ["mouseleave", "blur"]) term.addEventListener(name, hide);
    return term;
  }).map(node => typeof node === "string" ? document.createTextNode(node) : node);
}

export function rowElement(row: Row, actions: RowActions): HTMLElement {
  const line = make(row.tone === "heading" ? "h2" : "div", { class: `row ${row.tone}`, title: row.tip });
  if (row.indent) line.style.paddingLeft = `${row.indent * 14}px`;
  const inside = row.parts ? formula(row, actions) : [document.createTextNode(row.text)];
  if (row.command && !row.parts)
    line.append(make("button", { type: "button", onclick: () => actions.run(row.command!) }, ...inside));
  else
    line.append(...inside);
  if (row.cell !== undefined) {
    line.addEventListener("mouseenter", () => actions.hover(row.cell!));
    line.addEventListener("mouseleave", () => actions.hover(null));
    line.addEventListener("focusin", () => actions.hover(row.cell!));
    line.addEventListener("focusout", () => actions.hover(null));
  }
  return line;
}

export function download(name: string, content: BlobPart, type: string) {
  const url = URL.createObjectURL(new Blob([content], { type }));
  const link = make("a", { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
