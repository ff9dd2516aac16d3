// The address says what is shown: #bottleneck, #open=streets&do=step 7, or a whole state, packed.
// SPDX-License-Identifier: GPL-3.0-or-later

const packed = async (bytes: Uint8Array, through: GenericTransformStream) =>
  new Uint8Array(await new Response(new Blob([bytes as BlobPart]).stream().pipeThrough(through)).arrayBuffer());

export async function packState(state: string): Promise<string> {
  const small = JSON.stringify(JSON.parse(state));
  const bytes = await packed(new TextEncoder().encode(small), new CompressionStream("deflate-raw"));
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return "s=" + btoa(text).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

export type Asked = { open?: string; state?: string; commands?: string };

export async function readAddress(hash: string): Promise<Asked> {
  const text = decodeURIComponent(hash.replace(/^#/, ""));
  if (!text || text === "panel") return {};
  if (text.startsWith("s=")) {
    const bytes = Uint8Array.from(atob(text.slice(2).replaceAll("-", "+").replaceAll("_", "/")), c => c.charCodeAt(0));
    return { state: new TextDecoder().decode(await packed(bytes, new DecompressionStream("deflate-raw"))) };
  }
  if (!text.includes("=")) return { open: text };
  const asked = new URLSearchParams(text.replaceAll("+", "%2B"));
  return { open: asked.get("open") ?? undefined, commands: asked.get("do") ?? undefined };
}
