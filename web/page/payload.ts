// The core and its files, out of what the page carries.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Module } from "./core";
import type { Part } from "./parts";

declare const sightline: (options: { wasmBinary: ArrayBuffer; print?: (line: string) => void;
                                     printErr?: (line: string) => void }) => Promise<Module>;

/// The core comes first.
export async function loadCore([core, ...files]: Part[]): Promise<Module> {
  const module = await sightline({
    wasmBinary: core.bytes.slice().buffer, print: () => {}, printErr: line => console.warn(line) });
  for (const file of files) {
    module.FS.mkdirTree(file.name.slice(0, file.name.lastIndexOf("/")));
    module.FS.writeFile(file.name, file.bytes);
  }
  module.FS.mkdirTree("/files");
  module.FS.chdir("/files");
  return module;
}
