// The diagrams of the article, in its order. Scenes and methods are those of the core, by their ids.
// SPDX-License-Identifier: GPL-3.0-or-later
import { endHandle, eyeHandle, lookHandle, type ChoiceSpec, type DiagramSpec, type SliderSpec } from "./specs";

const plain = "set show_tessellation=off; set label=none";
const states = "/examples/states/coorg-teller/";
const byViewpoint = 'method "by-viewpoint choose_by=paper allotted_ms=0 grid=3 azimuths=4 samples=2"; run';

const budget = (most: number, value: number): SliderSpec => ({
  id: "budget", label: "Budget", min: 1, max: most, step: 1, value,
  does: percent => `budget ${percent}%; run`, words: percent => `${percent} %`,
});
const methods = (ids: [string, string][], value: string): ChoiceSpec => ({
  id: "method", label: "Order", value, options: ids.map(([id, label]) => ({ id, label, does: `method ${id}; run` })),
});
const setting = (name: string, label: string, options: [string, string][], value: string, then = ""): ChoiceSpec => ({
  id: name, label, value,
  options: options.map(([id, words]) => ({ id, label: words, does: `set ${name}=${id}${then}` })),
});

export const diagrams: Record<string, DiagramSpec> = {
  // 1. What you cannot see
  town: {
    open: "streets", begin: `method perfect; budget unlimited; ${plain}; set show_eye=on; seek start`, after: "run",
    shape: 1.3, handles: [eyeHandle, lookHandle(14)], words: "none", guess: { reveal: "run" },
  },
  layers: {
    open: "rooms", begin: `method perfect; budget unlimited; ${plain}; run`, after: "run", shape: 1.4,
    handles: [eyeHandle, lookHandle(7)], chart: "crossed", words: "none",
  },

  // 2. The view
  cone: {
    open: "rooms", begin: `method view; budget unlimited; ${plain}; seek start`, after: "run", shape: 1.35,
    steps: "step", handles: [eyeHandle, lookHandle(7)], guess: { reveal: "run" },
    sliders: [{ id: "fov", label: "Width of the view", min: 10, max: 170, step: 5, value: 90,
                does: angle => `fov ${angle}; run`, words: angle => `${angle}°` }],
  },

  // 3. Shadows
  shadow: {
    open: states + "figure-4a.json", begin: "eye 1,3; run; select node:4", after: "run; select node:4", shape: 1.7,
    handles: [eyeHandle, endHandle(0, 0, "The lower end of the wall"), endHandle(0, 1, "The upper end of the wall")],
    words: "verdict",
  },
  together: {
    open: states + "figure-4b.json", begin: "set connected=off; run; select node:2", after: "run; select node:2",
    shape: 1.7, handles: [eyeHandle, endHandle(1, 1, "The far end of the second wall")], words: "verdict",
    choices: [setting("connected", "Who may hide together?", [["off", "no one"], ["on", "walls that meet"],
                                                              ["fused", "any shadows that overlap"]], "off")],
  },
  floor: {
    open: "soda", begin: 'fov 360; method "coorg-teller connected=on"; budget unlimited; run', after: "run",
    shape: 1.35, handles: [eyeHandle], words: "result", steps: "box",
    sliders: [{ id: "walls", label: "Walls that may hide", min: 1, max: 64, step: 1, value: 32,
                does: count => `set occluder_count=${count}; run`, words: count => String(count) }],
    facts: {
      changed_near: { open: states + "moving-eye.json", does: "eye 20.2,22; run", of: "changed" },
      changed_far: { open: states + "moving-eye.json", does: "eye 23,22; run", of: "changed" },
      jungle_view: { open: "jungle", does: "method view; budget unlimited; run", of: "drawn" },
      jungle_drawn: { open: "jungle", does: 'method "coorg-teller connected=on"; budget unlimited; run', of: "drawn" },
    },
  },

  // 4. Cells and a front
  cells: {
    open: "bottleneck", begin: "method layers; set label=solidity; set show_choice=off; seek start; step 4",
    shape: 1.02, steps: "step", handles: [eyeHandle], guess: { reveal: "set show_choice=on; step" },
    facts: {
      taken: { does: "step", of: "cell", place: "cell" }, taken_drawn: { does: "step", of: "step_drawn" },
      taken_visible: { does: "step", of: "step_visible" },
    },
  },

  // 5. Solidity
  key: {
    open: "bottleneck",
    begin: "method published; set penalty=none; set label=none; set show_choice=off; seek start; step 6",
    shape: 1.02, steps: "step", handles: [eyeHandle], formula: true,
    guess: { reveal: "set label=solidity; set show_choice=on; step" },
    facts: {
      taken: { does: "step", of: "cell", place: "cell" }, taken_key: { does: "step", of: "key" },
      other: { does: "step", of: "runner_up", place: "cell" }, other_key: { does: "step", of: "runner_up_key" },
      taken_drawn: { does: "step", of: "step_drawn" }, taken_visible: { does: "step", of: "step_visible" },
    },
  },
  budget: {
    open: "streets", begin: `method published; ${plain}; set show_eye=on; budget 10%; run`, after: "run", shape: 1.3,
    handles: [eyeHandle, lookHandle(14)], sliders: [budget(80, 10)], words: "result",
    facts: { needed: { does: "budget unlimited; seek start; until coverage == 1", of: "drawn" } },
  },

  // 6. When the guess fails
  flood: {
    open: "rooms", begin: `method published; budget 5%; ${plain}; run`, shape: 1.35, steps: "step",
    handles: [eyeHandle],
    choices: [setting("own_content", "A cell's own content counts for itself",
                      [["off", "no, as published"], ["on", "yes"]], "off", "; run")],
    guess: { reveal: "set own_content=on; run", choose: ["own_content", "on"] },
    facts: {
      zero: { does: "run", of: "zero_keys" }, plain: { does: "run", of: "found" },
      zero_own: { does: "set own_content=on; run", of: "zero_keys" },
      own: { does: "set own_content=on; run", of: "found" },
    },
  },
  star: {
    open: "bottleneck", begin: "method published; set penalty=none; set label=solidity; set show_penalties=on; run",
    shape: 1.02, steps: "step", handles: [eyeHandle], words: "result",
    choices: [setting("penalty", "A cell that fails the test pays", [["none", "nothing"], ["multiply", "twice its key"],
                                                                    ["add", "2 more"]], "none", "; run")],
    guess: { reveal: "set penalty=multiply; run", choose: ["penalty", "multiply"] },
    facts: {
      without: { does: "run", of: "found" }, paid: { does: "set penalty=multiply; run", of: "found" },
      moved: { does: "set penalty=multiply; eye 7.5,2.05; run", of: "found" },
    },
  },
  forget: {
    open: "forget", begin: "method published; run", shape: 1.35, steps: "step", words: "result", handles: [eyeHandle],
    choices: [methods([["published", "PLP"], ["layers", "layers"], ["centroid", "nearest first"]], "published")],
    guess: { reveal: "method layers; run", choose: ["method", "layers"] },
    facts: {
      plp: { does: "run", of: "found" }, layers: { does: "method layers; run", of: "found" },
      nearest: { does: "method centroid; run", of: "found" },
    },
  },

  // 7. Light
  light: {
    open: "bottleneck", begin: "method flux; set label=solidity; seek start; step 5", shape: 1.02, steps: "step",
    handles: [eyeHandle], formula: true,
    facts: { all: { does: "run", of: "found" }, there: { does: "run", of: "visible" } },
  },
  contest: {
    open: "streets", begin: `method published; ${plain}; set show_eye=on; budget 10%; run`, after: "run", shape: 1.3,
    handles: [eyeHandle, lookHandle(14)], sliders: [budget(40, 10)], words: "result",
    choices: [methods([["published", "PLP"], ["layers", "layers"], ["centroid", "nearest first"], ["flux", "light"],
                       ["tri", "light and size"], ["perfect", "perfect"]], "published")],
    guess: { reveal: "method flux; run", choose: ["method", "flux"] },
    facts: {
      plp: { does: "run", of: "found" }, layers: { does: "method layers; run", of: "found" },
      light: { does: "method flux; run", of: "found" }, light_wrong: { does: "method flux; run", of: "wrong" },
      plp_wrong: { does: "run", of: "wrong" }, tri: { does: "method tri; run", of: "found" },
      fog_plp: { open: "fog", does: "run", of: "found" },
      fog_light: { open: "fog", does: "method flux; run", of: "found" },
    },
  },

  // 8. Never wrong
  rounds: {
    open: "rooms", begin: `method published; budget 5%; ${plain}; set show_depth=on; run; method cplp`, shape: 1.3,
    steps: "step", handles: [eyeHandle], sliders: [{ ...budget(30, 5), label: "First budget" }],
    guess: { reveal: "run" },
    facts: {
      plp: { does: "method published; run", of: "found" }, done: { does: "run", of: "drawn" },
      there: { does: "run", of: "visible" },
      winners: { does: 'method "cplp draws=winners"; run', of: "drawn" },
      by_boxes: { does: "method boxes; budget unlimited; run", of: "drawn" },
    },
  },

  // 9. The right method for the place
  doors: {
    open: "rooms", begin: `method portals; budget unlimited; ${plain}; seek start`, after: "run", shape: 1.35,
    steps: "step", handles: [eyeHandle, lookHandle(7)], words: "result", guess: { reveal: "run" },
    facts: {
      view_culling: { does: "method view; run", of: "drawn" }, pvs: { does: "method pvs; run", of: "drawn" },
    },
  },
  place: {
    open: "campus", begin: `method view; budget unlimited; ${plain}; run`, after: "run", shape: 1.15,
    handles: [eyeHandle, lookHandle(12)], words: "technique", workOut: true,
    choices: [{ id: "where", label: "Stand", value: "room", options: [
      { id: "room", label: "in a room", does: "eye -38,12.5; look -38,18; run" },
      { id: "lawn", label: "on the lawn", does: "eye 0,0; look 20,4; run" },
      { id: "far", label: "far out", does: "eye -88,-60; look 0,0; run" }] }],
    guess: { reveal: byViewpoint },
    facts: {
      here: { does: byViewpoint, of: "technique" },
      lawn: { does: byViewpoint + "; eye 0,0; look 20,4; run", of: "technique" },
    },
  },

  // 10. Cost
  cost: {
    open: "streets", begin: `method published; ${plain}; set show_eye=on; budget 5%; run`, shape: 1.3, words: "result",
    chart: "cost",
    choices: [{ id: "scene", label: "Scene", value: "streets",
                options: ["streets", "rooms", "cars", "fog"].map(id => ({ id, label: id, does: `open ${id}` })) }],
  },
};
