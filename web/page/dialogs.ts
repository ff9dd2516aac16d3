// What opens over the page: scenes, keys, the command line, menus, about.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { MenuRow, SceneChoice, Tables } from "./core";
import { byId, make } from "./dom";

type Run = (command: string) => void;

export const dialog = () => byId("dialog") as HTMLDialogElement;

function show(title: string, ...inside: Node[]) {
  const box = dialog();
  box.setAttribute("aria-label", title);
  const close = make("button", { type: "button", onclick: () => box.close() }, "Close");
  box.replaceChildren(make("h2", {}, title), ...inside, make("div", { class: "buttons" }, close));
  if (!box.open) box.showModal();
}

/// Rows that a text narrows down; Enter takes the first.
function chooser(title: string, hint: string, rows: { group: string; label: string; text: string; take(): void }[],
                 first = "") {
  const list = make("div", { class: "choices" });
  const field = make("input", { type: "text", "aria-label": hint, placeholder: hint, value: first });
  const fill = () => {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    list.replaceChildren();
    let group = "";
    for (const row of rows) {
      const all = `${row.group} ${row.label} ${row.text}`.toLowerCase();
      if (!words.every(word => all.includes(word))) continue;
      if (row.group !== group) list.append(make("h3", {}, group = row.group));
      list.append(make("button", { type: "button", onclick: () => { dialog().close(); row.take(); } }, row.label,
                       make("small", {}, row.text)));
    }
  };
  field.addEventListener("input", fill);
  field.addEventListener("keydown", event => {
    if (event.key === "Enter") list.querySelector("button")?.click();
  });
  fill();
  show(title, field, list);
  field.focus();
}

export function chooseScene(scenes: SceneChoice[], run: Run, group?: string) {
  chooser(group ?? "Scenes", "a part of the name",
          scenes.filter(scene => !group || scene.group === group).map(scene => ({
            group: scene.group, label: scene.title, text: scene.text,
            take: () => run(scene.command.replace(/^open /, `viewer${scene.dimension}d `)),
          })));
}

/// The command line: what fits what is typed so far stands below it.
export function commandLine(tables: Tables, run: Run, begin: string) {
  const field = make("input", { type: "text", "aria-label": "Command", value: begin, spellcheck: "false",
                                autocapitalize: "off", placeholder: "such as  until visible_share == 0" });
  const list = make("div", { class: "choices" });
  const fill = () => {
    const word = field.value.trim().split(" ")[0].toLowerCase();
    const fits = (id: string, label: string) => !word || id.startsWith(word) || label.toLowerCase().includes(word);
    list.replaceChildren(...tables.commands.filter(command => fits(command.id, command.label))
      .slice(0, 12).map(command => make("button", { type: "button", onclick: () => {
        if (command.arguments.trim()) { field.value = command.id + " "; field.focus(); fill(); }
        else { dialog().close(); run(command.id); }
      } }, `${command.id} ${command.arguments}`, make("small", {}, command.text))));
  };
  field.addEventListener("input", fill);
  field.addEventListener("keydown", event => {
    if (event.key !== "Enter" || !field.value.trim()) return;
    event.preventDefault();
    dialog().close();
    run(field.value.trim());
  });
  fill();
  show("Command", field, list);
  field.focus();
  field.setSelectionRange(field.value.length, field.value.length);
}

export function showKeys(tables: Tables) {
  const table = make("table", {});
  let group = "";
  for (const command of tables.commands) {
    if (!command.keys?.length) continue;
    if (command.group !== group)
      table.append(make("tr", {}, make("th", { colspan: 2 }, group = command.group)));
    const keys = make("td", {});
    for (const binding of command.keys) keys.append(make("kbd", {}, binding.key), " ");
    table.append(make("tr", {}, keys, make("td", {}, `${command.label}: ${command.text}`)));
  }
  show("Keys", table);
}

export function showMenu(tables: Tables, page: [string, () => void, string][], run: Run, ask: (begin: string) => void) {
  const rows: Node[] = [make("div", { class: "buttons" }, ...page.map(([label, act, title]) =>
    make("button", { type: "button", title, onclick: () => { dialog().close(); act(); } }, label)))];
  const add = (list: MenuRow[], to: Node[]) => {
    for (const row of list) {
      if (row.line) continue;
      if (row.inside) {
        const inside: Node[] = [];
        add(row.inside, inside);
        to.push(make("details", {}, make("summary", {}, row.label), ...inside));
        continue;
      }
      to.push(make("button", { type: "button", title: row.text, onclick: () => {
        dialog().close();
        row.asks ? ask(row.command + " ") : run(row.command!);
      } }, row.label + (row.asks ? " …" : ""), ...(row.keys ? [" ", make("kbd", {}, row.keys)] : [])));
    }
  };
  for (const menu of tables.menus) {
    const inside: Node[] = [];
    add(menu.rows, inside);
    rows.push(make("details", {}, make("summary", {}, menu.title), make("div", { class: "choices" }, ...inside)));
  }
  show("Menu", ...rows);
}

export function about(text: string) {
  show("About", ...text.split("\n\n").map(part => make("p", {}, part)));
}

/// A line of text that is asked for; nothing where it is given up.
export function askLine(title: string, take: (text: string) => void) {
  const field = make("input", { type: "text", "aria-label": title });
  field.addEventListener("keydown", event => {
    if (event.key !== "Enter") return;
    dialog().close();
    take(field.value);
  });
  show(title, field);
  field.focus();
}
