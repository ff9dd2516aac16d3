// The core of one diagram: a page of its own in the one memory, with what only the article asks.
// SPDX-License-Identifier: GPL-3.0-or-later
import { Core, type Light, type Module, type Under } from "../page/core";

export type Numbers = Record<string, { value?: number; text: string }>;
export type ViewNow = { eye: [number, number]; look: [number, number]; fov: number };
export type Dot = { method: string; budget: string; ms: number; msText: string; drawn: number; wrong: number;
                    wrongText: string; promise: string; colour: string };
export type Dots = { done?: number; total?: number; dots?: Dot[] };

export class DiagramCore extends Core {
  constructor(module: Module, widths: number[]) {
    super(module);
    this.setFont(widths);
  }
  free() { this.module._page_free(this.page); }

  /// `asked`: the names of those that take long.
  numbers(asked = "") {
    return this.read<Numbers & { view: ViewNow }>(this.withText(asked, at => this.module._page_numbers(this.page, at)));
  }
  place(name: string) { return this.read<Light[]>(this.withText(name, at => this.module._page_place(this.page, at))); }
  names(x: number, y: number, reach: number) {
    return this.read<Under & { names?: string[] }>(this.module._page_names(this.page, x, y, reach));
  }
  crossed(columns: number) {
    return this.read<{ all: number[]; drawn: number[] }>(this.module._page_crossed(this.page, columns));
  }
  dots() { return this.read<Dots>(this.module._page_dots(this.page)); }
  workOut(milliseconds: number) { return this.module._page_work_out(this.page, milliseconds) !== 0; }
  /// Commands, without a way back; what went wrong is thrown.
  does(commands: string) {
    this.run(commands);
    const bad = this.look().said?.find(line => line.bad);
    this.module._page_forget(this.page);
    if (bad) throw new Error(bad.text);
  }
}
