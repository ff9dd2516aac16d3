// What a diagram is made of: plain data and small functions. The diagrams themselves stand in diagrams.ts.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { DiagramCore, ViewNow } from "./handle";
import type { HandleSpec } from "./stage";

export type SliderSpec = { id: string; label: string; min: number; max: number; step: number; value: number;
                           does(value: number): string; words(value: number): string };
export type ChoiceSpec = { id: string; label: string; options: { id: string; label: string; does: string }[];
                           value: string };
/// A number of another run: commands after those of `begin`, on a scene that may be another one.
/// `place`: it is the number of such a thing, "cell".
export type FactSpec = { does: string; of: string; open?: string; place?: string };

export type DiagramSpec = {
  open: string;           // a scene, or a state of the project
  begin: string;          // commands before the first picture
  after?: string;         // after each change by a hand, a slider or a choice; else the step is kept
  shape: number;          // width / height
  handles?: HandleSpec[];
  steps?: string;         // what a step is called: then there are buttons and a slider for them
  sliders?: SliderSpec[];
  choices?: ChoiceSpec[];
  formula?: boolean;      // the key of the last step, term by term
  chart?: "crossed" | "cost";
  words?: "step" | "result" | "verdict" | "technique" | "none";  // what the line under it says
  // While a guess is open the truth is hidden; then these commands run, and a choice shows what they chose.
  guess?: { reveal: string; choose?: [string, string] };
  facts?: Record<string, FactSpec>;
  workOut?: boolean;      // a table by viewpoint fills in while one looks
};

export const eyeHandle: HandleSpec = {
  id: "eye", label: "The eye",
  at: view => view.eye,
  move: (core, to, view) => {
    core.take(view.eye[0], view.eye[1], 1e-3 * (1 + Math.abs(view.eye[0]) + Math.abs(view.eye[1])));
    core.drag(to[0], to[1]);
    core.letGo(false);
  },
};

/// Stands so far in front of the eye, in scene units, and turns the view.
export const lookHandle = (far: number): HandleSpec => ({
  id: "look", label: "The direction of the view",
  at: view => {
    const [dx, dy] = [view.look[0] - view.eye[0], view.look[1] - view.eye[1]], length = Math.hypot(dx, dy) || 1;
    return [view.eye[0] + dx / length * far, view.eye[1] + dy / length * far];
  },
  move: (core, to, view) => {
    if (Math.hypot(to[0] - view.eye[0], to[1] - view.eye[1]) < 1e-3 * far) return;
    core.does(`look ${to[0].toFixed(4)},${to[1].toFixed(4)}`);
  },
});

const ends = (core: DiagramCore, segment: number) => core.place(`segment ${segment}`)[0].points;
const point = (p: [number, number]) => `${p[0].toFixed(4)},${p[1].toFixed(4)}`;

/// An end of a wall.
export const endHandle = (segment: number, end: 0 | 1, label: string): HandleSpec => ({
  id: `end${segment}-${end}`, label,
  at: (_: ViewNow, core) => ends(core, segment)[end],
  move: (core, to) => {
    const points = ends(core, segment);
    points[end] = to;
    if (Math.hypot(points[0][0] - points[1][0], points[0][1] - points[1][1]) < 0.05) return;
    core.does(`segment move ${segment} ${point(points[0])} ${point(points[1])}; select none`);
  },
});

/// A whole wall, by its middle.
export const wallHandle = (segment: number, label: string): HandleSpec => ({
  id: `wall${segment}`, label,
  at: (_: ViewNow, core) => {
    const [a, b] = ends(core, segment);
    return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  },
  move: (core, to) => {
    const [a, b] = ends(core, segment), dx = to[0] - (a[0] + b[0]) / 2, dy = to[1] - (a[1] + b[1]) / 2;
    core.does(`segment move ${segment} ${point([a[0] + dx, a[1] + dy])} ${point([b[0] + dx, b[1] + dy])}; select none`);
  },
});
