// The settings, a widget each, in the groups of what a change makes again.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Setting, Tables } from "./core";
import { make } from "./dom";

const groups: [string, string][] = [["traversal", "Method and traversal"], ["picture", "Picture"],
  ["tessellation", "Tessellation"], ["reference", "Reference"], ["scene", "Scene"]];

export function settingsElements(settings: Setting[], tables: Tables, run: (command: string) => void): Node[] {
  const set = (setting: Setting, value: string) => run(`set ${setting.name}=${value}`);
  const widget = (setting: Setting): HTMLElement => {
    const label = `${setting.name}: ${setting.help}`;
    if (setting.words?.join() === "off,on" || setting.words?.join() === "on,off") {
      const box = make("input", { type: "checkbox", "aria-label": label, checked: setting.value === "on" });
      box.addEventListener("change", () => set(setting, box.checked ? "on" : "off"));
      return box;
    }
    if (setting.words) {
      const choice = make("select", { "aria-label": label });
      for (const word of setting.words) {
        const method = setting.name === "method" && tables.methods.find(method => method.id === word);
        const title = method ? method.title : word;
        choice.append(make("option", { value: word, selected: word === setting.value }, title));
      }
      choice.addEventListener("change", () => set(setting, choice.value));
      return choice;
    }
    const field = make("input", { type: "text", "aria-label": label, value: setting.value, spellcheck: "false" });
    field.addEventListener("change", () => set(setting, field.value));
    return field;
  };
  const nodes: Node[] = [make("h2", {}, "Presets"), make("div", { class: "buttons" }, ...tables.presets.map(preset =>
    make("button", { type: "button", title: preset.title, onclick: () => run(`preset ${preset.id}`) }, preset.id)))];
  for (const [group, title] of groups) {
    const some = settings.filter(setting => setting.group === group);
    if (some.length === 0) continue;
    nodes.push(make("h2", {}, title));
    for (const setting of some)
      nodes.push(make("label", { class: setting.value !== setting.otherwise ? "changed" : "",
                                 title: `${setting.help} (${setting.values}; default ${setting.otherwise}; ` +
                                        `${setting.source})` },
                      setting.name, widget(setting)));
  }
  return nodes;
}
