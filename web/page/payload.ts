// What the page carries: the core and its files, in one packed block (build.mjs), or as files beside the page.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Module } from "./core";

declare const sightline: (options: { wasmBinary: ArrayBuffer; print?: (line: string) => void;
                                     printErr?: (line: string) => void }) => Promise<Module>;

type Part = { name: string; size: number };

async function packed(): Promise<ArrayBuffer> {
  const inside = document.getElementById("payload");
  const bytes = inside
    ? Uint8Array.from(atob(inside.textContent!.trim()), c => c.charCodeAt(0)).buffer
    : await (await fetch("payload.gz")).arrayBuffer();
  inside?.remove();
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

/// The block begins with the length of a table in JSON; then the table, then the parts, the core first.
export async function loadCore(): Promise<Module> {
  const all = await packed();
  const length = new DataView(all).getUint32(0, true);
  const parts = JSON.parse(new TextDecoder().decode(new Uint8Array(all, 4, length))) as Part[];
  let at = 4 + length;
  const files = parts.map(part => {
    const bytes = new Uint8Array(all, at, part.size);
    at += part.size;
    return { name: part.name, bytes };
  });
  const wasm = files.shift()!.bytes;
  const module = await sightline({ wasmBinary: wasm.slice().buffer, print: () => {}, printErr: line => console.warn(line) });
  for (const file of files) {
    module.FS.mkdirTree(file.name.slice(0, file.name.lastIndexOf("/")));
    module.FS.writeFile(file.name, file.bytes);
  }
  module.FS.mkdirTree("/files");
  module.FS.chdir("/files");
  return module;
}
