// The trade-off's chart: time of a frame to the right, on a scale of powers, and what is wrong or found upwards.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { TradeDot, TradeOff } from "./core";
import { make } from "./dom";
import { escaped } from "./paint";

const width = 360, height = 250, left = 38, right = 8, top = 10, bottom = 34;

const marker = ({ marker, filled, colour, now }: TradeDot, x: number, y: number) => {
  const r = now ? 7 : 4.5, inside = filled ? colour : "var(--paper)", border = now ? "var(--ink)" : colour;
  const look = `fill="${inside}" stroke="${border}" stroke-width="${now ? 2.4 : 1.4}"`;
  const polygon = (corners: number, turn: number) => `<polygon ${look} points="${[...Array(corners).keys()].map(i => {
    const angle = turn + 2 * Math.PI * i / corners;
    return `${(x + r * Math.sin(angle)).toFixed(1)},${(y - r * Math.cos(angle)).toFixed(1)}`;
  }).join(" ")}"/>`;
  switch (marker) {
    case "square": return polygon(4, Math.PI / 4);
    case "diamond": return polygon(4, 0);
    case "triangle": return polygon(3, 0);
    case "triangle_down": return polygon(3, Math.PI);
    case "pentagon": return polygon(5, 0);
    default: return `<circle ${look} cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="${r}"/>`;
  }
};

/// 1, 2, 5, 10, …, or powers of ten where those would be too many.
function roundNumbers(from: number, to: number): number[] {
  const steps = to / from > 300 ? [1] : [1, 2, 5], found: number[] = [];
  for (let power = Math.floor(Math.log10(from)); power <= Math.ceil(Math.log10(to)); ++power)
    for (const step of steps) {
      const number = step * 10 ** power;
      if (number >= from && number <= to) found.push(number);
    }
  return found;
}

const short = (number: number, digits: number) => String(Number(number.toPrecision(digits)));

export function tradeOffChart(study: TradeOff, run: (command: string) => void): HTMLElement | null {
  const dots = study.dots ?? [];
  if (dots.length === 0) return null;
  const times = dots.map(dot => dot.ms), shares = dots.map(dot => dot.share);
  const from = Math.min(...times) / 1.3, to = Math.max(...times) * 1.3;
  const most = study.share!.startsWith("coverage") ? 104 : Math.max(Math.max(...shares) * 1.06, 0.01);
  const least = -0.05 * most;  // dots on the axis stand inside
  const x = (ms: number) => left + (width - left - right) * Math.log(ms / from) / Math.log(to / from);
  const y = (share: number) => top + (height - top - bottom) * (most - share) / (most - least);
  const text = (words: string, at: [number, number], anchor: string) =>
    `<text x="${at[0].toFixed(1)}" y="${at[1].toFixed(1)}" text-anchor="${anchor}">${escaped(words)}</text>`;
  let body = "";
  for (const ms of roundNumbers(from, to))
    body += `<path d="M${x(ms).toFixed(1)} ${top}V${height - bottom}"/>` +
            text(short(ms, 2), [x(ms), height - bottom + 13], "middle");
  const step = 10 ** Math.floor(Math.log10(most / 2)), every = most / step > 8 ? 2 * step : step;
  for (let share = 0; share <= most; share += every)
    body += `<path d="M${left} ${y(share).toFixed(1)}H${width - right}"/>` +
            text(short(share, 3), [left - 4, y(share) + 4], "end");
  body += text(study.time!, [width - right, height - 6], "end");
  const variants = new Map<string, TradeDot[]>();
  for (const dot of dots) variants.set(dot.variant, [...variants.get(dot.variant) ?? [], dot]);
  for (const list of variants.values()) {
    list.sort((a, b) => a.primitives - b.primitives);
    body += `<polyline fill="none" stroke="${list[0].colour}" stroke-width="1.4" opacity=".6" points="${
      list.map(dot => `${x(dot.ms).toFixed(1)},${y(dot.share).toFixed(1)}`).join(" ")}"/>`;
  }
  const best = dots.filter(dot => dot.best).sort((a, b) => a.ms - b.ms);
  body += `<polyline fill="none" stroke="var(--ink)" stroke-width="1.6" stroke-dasharray="5 3" points="${
    best.map(dot => `${x(dot.ms).toFixed(1)},${y(dot.share).toFixed(1)}`).join(" ")}"/>`;
  dots.forEach((dot, i) => {
    const words = `${dot.variant} ${dot.budget}: ${short(dot.ms, 3)} ms, ${study.share!.replace(", %", "")} ` +
                  `${short(dot.share, 3)} %${dot.best ? ", Pareto" : ""}`;
    body += `<g data-dot="${i}"><title>${escaped(words)}</title>${marker(dot, x(dot.ms), y(dot.share))}</g>`;
  });
  const figure = make("figure", { class: "chart" }, make("figcaption", {}, study.share!));
  figure.insertAdjacentHTML("beforeend", `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="${
    escaped(`${study.share} against ${study.time}; the rows below say the same`)}">${body}</svg>`);
  figure.addEventListener("click", event => {
    const dot = (event.target as Element).closest<SVGElement>("[data-dot]");
    if (dot) run(dots[Number(dot.dataset.dot)].command);
  });
  return figure;
}
