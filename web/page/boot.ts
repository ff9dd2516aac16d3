// What begins the page: it unpacks script, style, core and files, which build.mjs has packed into one block, and
// starts the script. It also gives the page as a file again, for hand-outs.
// SPDX-License-Identifier: GPL-3.0-or-later
import { packedBlock, partsOf, type Part } from "./parts";
import { textOfBytes } from "./unpack";

export type Boot = {
  parts: Part[];
  handout: string;                           // the session that the page came with, as JSON; empty: none
  pageWith(handout: string): Promise<string>;  // the page as one file, with another session
};

// Before anything changes it.
const original = document.documentElement.cloneNode(true) as HTMLElement;
let packed: Uint8Array;

/// The page as a host has it has its files beside it: they come into one.
async function asOneFile(root: HTMLElement) {
  const script = root.querySelector("script[src]");
  if (!script) return;
  const element = (text: string) => Object.assign(document.createElement("script"), { textContent: text });
  const payload = element(textOfBytes(packed));
  for (const [name, value] of [["type", "text/plain"], ["id", "payload"], ["data-size", String(packed.length)]])
    payload.setAttribute(name, value);
  script.replaceWith(payload, element(await (await fetch("page.js")).text()));
}

async function pageWith(handout: string) {
  const root = original.cloneNode(true) as HTMLElement;
  await asOneFile(root);
  root.querySelector("#handout")!.textContent = handout.replaceAll("<", "\\u003c");
  const before = [...document.childNodes].map(node =>
    node.nodeType === Node.COMMENT_NODE ? `<!--${node.nodeValue}-->\n` : "");
  return `<!doctype html>\n${before.join("")}${root.outerHTML}\n`;
}

async function start() {
  packed = await packedBlock();
  const parts = partsOf(packed), decoder = new TextDecoder();
  const script = document.createElement("script");
  script.textContent = decoder.decode(parts.shift()!.bytes);
  document.getElementById("style")!.textContent = decoder.decode(parts.shift()!.bytes);
  const boot: Boot = { parts, handout: document.getElementById("handout")!.textContent!.trim(), pageWith };
  Object.assign(window, { boot });
  document.body.append(script);
}
void start();
