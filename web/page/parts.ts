// The packed block that a page carries or has beside it, and the parts in it (web/build.mjs).
// SPDX-License-Identifier: GPL-3.0-or-later
import { bytesOfText, lzma } from "./unpack";

export type Part = { name: string; bytes: Uint8Array };

/// Takes the block out of the page, where it stands there.
export async function packedBlock(): Promise<Uint8Array> {
  const inside = document.getElementById("payload");
  const packed = inside ? bytesOfText(inside.textContent!, Number(inside.dataset.size))
                        : new Uint8Array(await (await fetch("payload.lzma")).arrayBuffer());
  inside?.remove();
  return packed;
}

/// The block begins with its size unpacked; that is the length of a table in JSON, the table, the parts: script and
/// style of the page, the core, its files.
export function partsOf(packed: Uint8Array): Part[] {
  const size = new DataView(packed.buffer).getUint32(0, true), all = lzma(packed.subarray(4), size);
  const length = new DataView(all.buffer).getUint32(0, true);
  const table = JSON.parse(new TextDecoder().decode(all.subarray(4, 4 + length))) as { name: string; size: number }[];
  let at = 4 + length;
  return table.map(({ name, size }) => ({ name, bytes: all.subarray(at, at += size) }));
}
