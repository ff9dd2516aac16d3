// Keys by the names that the command table has for them.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Binding, Command } from "./core";

const names: Record<string, string> = {
  ArrowRight: "Right", ArrowLeft: "Left", ArrowUp: "Up", ArrowDown: "Down", " ": "Space", Enter: "Enter",
  Home: "Home", End: "End", PageUp: "PageUp", PageDown: "PageDown", Tab: "Tab", Escape: "Escape", Delete: "Delete",
  Backspace: "Backspace",
};

/// "Ctrl+Shift+Z", "F2", "]"; empty for none that a command could have.
export function keyName(event: KeyboardEvent): string {
  if (event.metaKey) return "";
  const { key, ctrlKey, altKey, shiftKey } = event;
  if (!ctrlKey && !altKey && ":[]{}+-".includes(key)) return key;
  let base = names[key] ?? "";
  if (/^F([1-9]|1[0-2])$/.test(key)) base = key;
  if (/^[a-z]$/i.test(key)) base = key.toUpperCase();
  if (/^[0-9]$/.test(key)) base = key;
  if (ctrlKey && (key === "+" || key === "=")) base = "Plus";
  if (ctrlKey && key === "-") base = "Minus";
  if (!base) return "";
  return (ctrlKey ? "Ctrl+" : "") + (altKey ? "Alt+" : "") + (shiftKey && base !== "Plus" ? "Shift+" : "") + base;
}

export function bindings(commands: Command[]): Map<string, Binding> {
  const all = new Map<string, Binding>();
  for (const command of commands) for (const binding of command.keys ?? []) all.set(binding.key, binding);
  return all;
}

/// What the browser does with this key where the focus is, and is to do.
export function belongsToFocus(event: KeyboardEvent, name: string): boolean {
  const at = event.target as HTMLElement;
  if (["Ctrl+Plus", "Ctrl+Minus", "Ctrl+0", "Ctrl+W", "Ctrl+T", "Ctrl+R"].includes(name)) return true;
  if (name === "Tab" || name === "Shift+Tab" || name === "F12" || name === "F5") return true;
  if (name === "Ctrl+C" && String(getSelection())) return true;
  if (name === "Ctrl+V") return true;  // comes as the event "paste"
  if (at.closest("textarea, select, input:not([type=range])")) return true;
  if (at.closest("input[type=range]") && /^(Shift\+)?(Left|Right|Up|Down|Home|End|Page\w+)$/.test(name)) return true;
  if (at.closest("button, a, summary, [role=tab]") && (name === "Space" || name === "Enter")) return true;
  return at.closest("dialog") !== null;
}
