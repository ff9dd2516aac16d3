// Prose to HTML: docs/article/*.md is Markdown of a few kinds (headings, paragraphs, lists, links, emphasis), with
// {{diagram.number}} for what the core says and blocks "::: diagram" for pictures. What it does not know is an error.
// SPDX-License-Identifier: GPL-3.0-or-later

const escaped = text => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");

/// `home`: the diagram whose numbers are meant where none is named.
export function inline(text, home = "") {
  return escaped(text)
    .replace(/\{\{([\w-]+\.)?(\w+)\}\}/g, (_, of, name) => {
      if (!of && !home) throw new Error(`{{${name}}} names no diagram`);
      return `<span class="n" data-value="${of ?? home + "."}${name}">…</span>`;
    })
    .replace(/`([^`]+)`/g, "<code>$1</code>")
    .replace(/\*\*([^*]+)\*\*/g, "<strong>$1</strong>")
    .replace(/\*([^*]+)\*/g, "<em>$1</em>")
    .replace(/\[([^\]]+)\]\(([^)\s]+)\)/g, (_, words, to) => `<a href="${to.replace(/"/g, "%22")}">${words}</a>`);
}

const joined = (text, home) => inline(text.replace(/\n/g, " "), home);

/// task:, ask KIND NAME:, - OPTION | WORDS, answer:, note:
function block(id, lines) {
  const parts = [];
  for (const line of lines) {
    const found = /^(task|answer|note|ask (?:number|cell|option) \w+):\s*(.*)$/.exec(line);
    if (found) parts.push({ kind: found[1], text: found[2] });
    else if (/^- /.test(line) && parts.at(-1)?.kind.startsWith("ask option"))
      (parts.at(-1).options ??= []).push(line.slice(2));
    else if (parts.length) parts.at(-1).text += "\n" + line;
    else throw new Error(`${id}: '${line}' belongs to nothing`);
  }
  const one = kind => parts.find(part => part.kind === kind)?.text;
  const ask = parts.find(part => part.kind.startsWith("ask"));
  const task = one("task"), answer = one("answer"), note = one("note");
  if (!task) throw new Error(`${id}: a diagram needs a task`);
  if (!ask !== !answer) throw new Error(`${id}: a question needs an answer, and an answer a question`);
  let html = `<figure class="diagram" data-diagram="${id}" id="${id}">\n` +
    `<p class="task" id="${id}-task">${joined(task, id)}</p>\n` +
    `<div class="stand"><p class="wait">The diagram starts when it comes into view.</p></div>\n`;
  if (ask) {
    const [, kind, name] = ask.kind.split(" ");
    const options = (ask.options ?? []).map(line => {
      const [option, words] = line.split(" | ");
      return `<li data-option="${escaped(option)}">${inline(words, id)}</li>`;
    }).join("");
    html += `<form class="guess" data-kind="${kind}" data-asks="${name}">` +
        `<p class="question" id="${id}-question">` +
      `${joined(ask.text, id)}</p>${options ? `<ul>${options}</ul>` : ""}</form>\n` +
      `<div class="answer" hidden><p>${joined(answer, id)}</p></div>\n`;
  }
  if (note) html += `<figcaption>${joined(note, id)}</figcaption>\n`;
  return html + "</figure>";
}

export function toHtml(text, section) {
  const html = [], lines = text.replace(/<!--[\s\S]*?-->/g, "").split("\n");
  for (let i = 0; i < lines.length;) {
    const line = lines[i];
    if (!line.trim()) { ++i; continue; }
    const open = /^::: ([\w-]+)$/.exec(line);
    if (open) {
      const end = lines.indexOf(":::", i + 1);
      if (end < 0) throw new Error(`${section}: ::: ${open[1]} does not end`);
      html.push(block(open[1], lines.slice(i + 1, end).filter(one => one.trim())));
      i = end + 1;
      continue;
    }
    if (line.startsWith("    ")) {
      html.push(`<p class="equation">${inline(line.trim())}</p>`);
      ++i;
      continue;
    }
    const heading = /^(#{1,3}) (.*)$/.exec(line);
    if (heading) {
      const level = heading[1].length, id = level === 1 ? "top" : section;
      html.push(`<h${level}${level < 3 ? ` id="${id}"` : ""}>${inline(heading[2])}</h${level}>`);
      ++i;
      continue;
    }
    if (/^(- |\d+\. )/.test(line)) {
      const ordered = /^\d/.test(line), items = [];
      for (; i < lines.length && lines[i].trim(); ++i)
        if (/^(- |\d+\. )/.test(lines[i])) items.push(lines[i].replace(/^(- |\d+\. )/, ""));
        else items[items.length - 1] += " " + lines[i].trim();
      const list = ordered ? "ol" : "ul";
      html.push(`<${list}>${items.map(item => `<li>${inline(item)}</li>`).join("\n")}</${list}>`);
      continue;
    }
    const sources = line.startsWith("Sources: "), words = [];
    for (; i < lines.length && lines[i].trim(); ++i) words.push(lines[i]);
    html.push(`<p${sources ? ' class="sources"' : ""}>${inline(words.join(" "))}</p>`);
  }
  return html.join("\n");
}
