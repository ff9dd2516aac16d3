// Flying with keys: while one of them is held, the eye moves and the traversal follows.
// SPDX-License-Identifier: GPL-3.0-or-later

/// Right, up, ahead.
const directions: Record<string, [number, number, number]> = {
  KeyW: [0, 0, 1], KeyS: [0, 0, -1], KeyA: [-1, 0, 0], KeyD: [1, 0, 0], KeyE: [0, 1, 0], KeyQ: [0, -1, 0],
};
const faster = 4;

export class Flight {
  private readonly held = new Set<string>();
  private fast = false;
  private last = 0;

  /// `move`: seconds to the right, up and ahead.
  constructor(private readonly move: (by: [number, number, number]) => void) {
    addEventListener("keyup", event => { this.held.delete(event.code); this.fast = event.shiftKey; });
    addEventListener("blur", () => this.held.clear());
  }

  /// True: the key is one of flight.
  key(event: KeyboardEvent): boolean {
    if (!(event.code in directions) || event.ctrlKey || event.altKey || event.metaKey) return false;
    this.fast = event.shiftKey;
    if (!event.repeat) {
      const idle = this.held.size === 0;
      this.held.add(event.code);
      if (idle) {
        this.last = performance.now();
        requestAnimationFrame(now => this.frame(now));
      }
    }
    return true;
  }
  stop() { this.held.clear(); }

  private frame(now: number) {
    if (this.held.size === 0) return;
    const seconds = Math.min(Math.max(now - this.last, 0), 250) / 1000 * (this.fast ? faster : 1);
    this.last = now;
    const by: [number, number, number] = [0, 0, 0];
    for (const code of this.held) directions[code].forEach((one, axis) => by[axis] += one * seconds);
    this.move(by);
    requestAnimationFrame(next => this.frame(next));
  }
}
