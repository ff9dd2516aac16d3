// The core: WebAssembly and the functions of web/core/exports.cpp, with types for what they tell.
// SPDX-License-Identifier: GPL-3.0-or-later

export type Row = {
  text: string; tone: string; command?: string; cell?: number; indent?: number; tip?: string; captions?: boolean;
  parts?: { text: string; about?: number; name?: string }[]; light?: [number, number, number];
};

export type Look = {
  dimension: 2 | 3; scene: string; source: string; title: string; headline: string; result?: string; step: string;
  position: number; recorded: number; run: number; method: string; guarantee: string; state: string;
  frozen: boolean; selected: number; asks: boolean; undo: boolean; redo: boolean; panes: number; eye: [number, number];
  desk: { projector: boolean; blank: boolean; speaker: boolean; edit: boolean; left: string; right: string;
          legend: boolean; timeline: boolean; fullscreen: boolean; tool: string; animate: boolean };
  flight?: boolean; formula?: string;
  lesson: Row[]; teaching?: { id: string; part: number; asksKey: boolean }; speaker?: Row[]; panel?: Row[];
  said?: { text: string; bad: boolean }[];
};

export type Binding = { key: string; command: string; asks: boolean };
export type Command = { id: string; group: string; label: string; arguments: string; text: string; slow: string;
                        keys?: Binding[] };
export type MenuRow = { line?: boolean; label: string; text: string; keys: string; command?: string; asks?: boolean;
                        inside?: MenuRow[] };
export type Tables = {
  commands: Command[]; menus: { title: string; rows: MenuRow[] }[];
  panels: { id: string; title: string; text: string; group: string; body: string }[];
  methods: { id: string; title: string; sentence: string; colour: string }[];
  presets: { id: string; title: string }[];
};
export type SceneChoice = { group: string; title: string; text: string; command: string; dimension: number };
export type Setting = { name: string; help: string; source: string; values: string; group: string; value: string;
                        otherwise: string; parameter: boolean; words?: string[] };
export type Curve = { run?: number; tells?: boolean; coverage?: (number | null)[]; oracle?: (number | null)[];
                      hidden?: number[]; visible?: number[]; key?: (number | null)[]; cell?: number[];
                      other?: (number | null)[]; bookmarks?: { step: number; label: string }[] };

export type Style = { name: string; width: number; fill?: string; stroke?: string; hatch?: string; hatchColour?: string;
                      dash?: string };
export type List = { points: number; pointCount: number; shapes: number; shapeCount: number; styles: Style[] };
export type PlacedLabel = { text: string; x: number; y: number; size: number; colour: string; halo?: string;
                            disc?: string; radius?: number; leader?: [number, number, number, number] };
export type LegendRow = { swatch: string; text: string; style: Style };
export type Solid = { triangles: number; triangleCorners: number; opaque: number; edges: number; edgeCorners: number;
                      clip: number[]; forward: number[]; lamp: number[]; background: string };
export type Picture = {
  solid?: Solid;
  still?: string;  // what the second list was drawn of: the same words, the same list
  world?: [number, number, number, number]; background: string; ink: string; accent: string; lists: List[];
  labels: PlacedLabel[]; legend?: LegendRow[]; head?: string;
  bar?: { title: string; low: string; high: string; stops: string[] };
};
export type TradeDot = { ms: number; share: number; variant: string; budget: string; primitives: number; colour: string;
                         marker: string; filled: boolean; best: boolean; now: boolean; command: string };
export type TradeOff = { time?: string; share?: string; dots?: TradeDot[] };
export type Under = { cell?: number; primitive?: number; eye?: boolean; words?: string; drag?: string };
export type Light = { points: [number, number][]; closed: boolean; arrow: boolean };

export type Module = {
  HEAPU8: Uint8Array;
  FS: { mkdirTree(path: string): void; writeFile(path: string, bytes: Uint8Array | string): void;
        readdir(path: string): string[]; readFile(path: string): Uint8Array; unlink(path: string): void;
        chdir(path: string): void };
  UTF8ToString(at: number): string;
  stringToUTF8(text: string, at: number, size: number): void;
  lengthBytesUTF8(text: string): number;
  _malloc(size: number): number;
  _free(at: number): void;
} & Record<string, (...args: number[]) => number>;

/// Points and shapes of a list where they lie in the core's memory (web/core/picture.cpp): good until the next call.
export type Shapes = { points: Float64Array; bytes: Uint8Array; shorts: Uint16Array; words: Uint32Array;
                       sizes: Float64Array; count: number };
export const shapeBytes = 24;

export class Core {
  protected readonly page: number;
  constructor(protected readonly module: Module) {
    this.page = module._page_new();
  }

  get files() { return this.module.FS; }
  /// Good until the next call.
  get memory() { return this.module.HEAPU8.buffer; }

  protected read<T>(at: number): T {
    const answer = JSON.parse(this.module.UTF8ToString(at)) as T & { error?: string };
    if (answer && answer.error) throw new Error(answer.error);
    return answer;
  }
  protected withText(text: string, call: (at: number) => number): number {
    const size = this.module.lengthBytesUTF8(text) + 1, at = this.module._malloc(size);
    this.module.stringToUTF8(text, at, size);
    try { return call(at); } finally { this.module._free(at); }
  }

  selfTest(inputs: number) { return this.module.UTF8ToString(this.module._page_self_test(this.page, inputs)); }
  setFont(widths: number[]) {
    const at = this.module._malloc(4 * widths.length);
    new Float32Array(this.module.HEAPU8.buffer, at, widths.length).set(widths);
    this.module._page_font(this.page, at);
    this.module._free(at);
  }
  open(name: string) { this.read(this.withText(name, at => this.module._page_open(this.page, at))); }
  openState(text: string) { this.read(this.withText(text, at => this.module._page_open_state(this.page, at))); }
  state() { return this.module.UTF8ToString(this.module._page_state(this.page)); }
  /// The same for links and hand-outs: with the lesson, and with scenes inside that no generator makes.
  handout() { return this.module.UTF8ToString(this.module._page_handout(this.page)); }
  run(commands: string) { this.read(this.withText(commands, at => this.module._page_do(this.page, at))); }
  tick(seconds: number) { return this.module._page_tick(this.page, seconds) !== 0; }
  idle(milliseconds: number) { return this.module._page_idle(this.page, milliseconds) !== 0; }
  look() { return this.read<Look>(this.module._page_look(this.page)); }
  panel(id: string) { return this.read<Row[]>(this.withText(id, at => this.module._page_panel(this.page, at))); }
  settings() { return this.read<Setting[]>(this.module._page_settings(this.page)); }
  tables() { return this.read<Tables>(this.module._page_tables(this.page)); }
  scenes() { return this.read<SceneChoice[]>(this.module._page_scenes(this.page)); }
  curve() { return this.read<Curve>(this.module._page_curve(this.page)); }
  light(about: number, [from, facet, cell]: [number, number, number]) {
    return this.read<Light[]>(this.module._page_light(this.page, about, from, facet, cell));
  }
  corners(cell: number) { return this.read<[number, number][]>(this.module._page_corners(this.page, cell)); }
  hash() { return this.module.UTF8ToString(this.module._page_hash(this.page)); }

  picture(pane: number, width: number, height: number, unit: number) {
    return this.read<Picture>(this.module._page_picture(this.page, pane, width, height, unit));
  }
  shapes(list: List): Shapes {
    const buffer = this.module.HEAPU8.buffer;
    const none = list.shapeCount === 0;
    const at = none ? 0 : list.shapes, size = list.shapeCount * shapeBytes;
    return {
      points: new Float64Array(buffer, list.pointCount ? list.points : 0, 2 * list.pointCount),
      bytes: new Uint8Array(buffer, at, size), shorts: new Uint16Array(buffer, at, size / 2),
      words: new Uint32Array(buffer, at, size / 4), sizes: new Float64Array(buffer, at, size / 8),
      count: list.shapeCount,
    };
  }
  under(x: number, y: number, reach: number) {
    return this.read<Under>(this.module._page_under(this.page, x, y, reach));
  }
  tap(x: number, y: number, reach: number) { this.read(this.module._page_tap(this.page, x, y, reach)); }
  tapTwice(x: number, y: number) { this.read(this.module._page_tap_twice(this.page, x, y)); }
  /// True: something of the scene is held, not the picture.
  take(x: number, y: number, reach: number) { return this.module._page_take(this.page, x, y, reach) !== 0; }
  fly([right, up, ahead]: [number, number, number], turn = 0, rise = 0) {
    this.read(this.module._page_fly(this.page, right, up, ahead, turn, rise));
  }
  tradeOff() { return this.read<TradeOff>(this.module._page_trade_off(this.page)); }
  drag(x: number, y: number) { this.read(this.module._page_drag(this.page, x, y)); }
  letGo(back: boolean) { this.read(this.module._page_let_go(this.page, back ? 1 : 0)); }
  magnify(x: number, y: number, factor: number) { this.read(this.module._page_magnify(this.page, x, y, factor)); }
}
