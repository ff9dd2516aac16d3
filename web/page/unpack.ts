// Packed bytes: how they stand in a page's text, and LZMA.
// SPDX-License-Identifier: GPL-3.0-or-later

/// Seven bits a character, but for those that a script element does not keep: they stand in a character of two bytes
/// with the seven bits after them. web/build.mjs writes it.
const unfit = [0, 13, 60];

export function bytesOfText(text: string, size: number): Uint8Array {
  const bytes = new Uint8Array(size);
  let at = 0, held = 0, bits = 0;
  for (let i = 0; i < text.length; ++i) {
    const c = text.charCodeAt(i);
    if (c < 128) {
      held = held << 7 | c;
      bits += 7;
    } else {
      held = held << 14 | unfit[c - 256 >> 7] << 7 | c & 127;
      bits += 14;
    }
    while (bits >= 8) {
      bits -= 8;
      bytes[at++] = held >> bits;
    }
    held &= (1 << bits) - 1;
  }
  return bytes;
}

export function textOfBytes(bytes: Uint8Array): string {
  const parts: string[] = [];
  let text = "", held = 0, bits = 0, first = -1;
  const put = (seven: number) => {
    if (first >= 0) {
      text += String.fromCharCode(256 + (first << 7 | seven));
      first = -1;
    } else if (unfit.includes(seven)) first = unfit.indexOf(seven);
    else text += String.fromCharCode(seven);
  };
  for (const byte of bytes) {
    held = held << 8 | byte;
    bits += 8;
    while (bits >= 7) {
      bits -= 7;
      put(held >> bits & 127);
    }
    held &= (1 << bits) - 1;
    if (text.length > 60_000) { parts.push(text); text = ""; }
  }
  if (bits > 0) put(held << 7 - bits & 127);
  if (first >= 0) put(0);
  return parts.join("") + text;
}

/// What xz writes as --format=raw --lzma1=lc=4,lp=0,pb=0, `size` bytes of it. By the description of the format in
/// Igor Pavlov's LZMA specification (2015): a range coder of bits, whose probabilities follow what was decoded before.
export function lzma(packed: Uint8Array, size: number): Uint8Array {
  const out = new Uint8Array(size);
  const literalBits = 4, states = 12, lengthStates = 4;
  let places = 0;
  const room = (count: number) => (places += count) - count;
  const isMatch = room(states), isRep = room(states), isRepG0 = room(states), isRepG1 = room(states);
  const isRepG2 = room(states), isRep0Long = room(states);
  const slots = room(lengthStates << 6), distances = room(128), align = room(16);
  const lengthCoder = () => ({ choice: room(2), low: room(8), middle: room(8), high: room(256) });
  const matchLength = lengthCoder(), repLength = lengthCoder();
  const literals = room(0x300 << literalBits);
  const chances = new Uint16Array(places).fill(1024);

  let range = -1 >>> 0, code = 0, next = 5;
  for (let i = 1; i < 5; ++i) code = (code << 8 | packed[i]) >>> 0;

  const bit = (place: number): number => {
    const chance = chances[place], bound = Math.imul(range >>> 11, chance) >>> 0;
    let one: number;
    if (code < bound) {
      range = bound;
      chances[place] = chance + (2048 - chance >> 5);
      one = 0;
    } else {
      range = range - bound >>> 0;
      code = code - bound >>> 0;
      chances[place] = chance - (chance >> 5);
      one = 1;
    }
    if (range < 0x1000000) {
      range = range << 8 >>> 0;
      code = (code << 8 | packed[next++]) >>> 0;
    }
    return one;
  };
  const tree = (place: number, bits: number): number => {
    let node = 1;
    for (let i = 0; i < bits; ++i) node = node << 1 | bit(place + node);
    return node - (1 << bits);
  };
  const treeBackwards = (place: number, bits: number): number => {
    let node = 1, value = 0;
    for (let i = 0; i < bits; ++i) {
      const one = bit(place + node);
      node = node << 1 | one;
      value |= one << i;
    }
    return value;
  };
  const evenBits = (count: number): number => {
    let value = 0;
    for (; count > 0; --count) {
      range >>>= 1;
      const one = code >= range ? 1 : 0;
      if (one) code = code - range >>> 0;
      value = value << 1 | one;
      if (range < 0x1000000) {
        range = range << 8 >>> 0;
        code = (code << 8 | packed[next++]) >>> 0;
      }
    }
    return value;
  };
  const length = (coder: typeof matchLength): number =>
    !bit(coder.choice) ? tree(coder.low, 3)
      : !bit(coder.choice + 1) ? 8 + tree(coder.middle, 3) : 16 + tree(coder.high, 8);

  let state = 0, rep0 = 0, rep1 = 0, rep2 = 0, rep3 = 0, at = 0;
  while (at < size) {
    if (!bit(isMatch + state)) {
      const place = literals + 0x300 * (at > 0 ? out[at - 1] >> 8 - literalBits : 0);
      let symbol = 1;
      if (state >= 7)
        for (let matched = out[at - rep0 - 1]; symbol < 0x100;) {
          const expected = matched >> 7 & 1, one = bit(place + (1 + expected << 8) + symbol);
          matched <<= 1;
          symbol = symbol << 1 | one;
          if (expected !== one) break;
        }
      while (symbol < 0x100) symbol = symbol << 1 | bit(place + symbol);
      out[at++] = symbol;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let count: number;
    if (bit(isRep + state)) {
      if (!bit(isRepG0 + state)) {
        if (!bit(isRep0Long + state)) {
          out[at] = out[at - rep0 - 1];
          ++at;
          state = state < 7 ? 9 : 11;
          continue;
        }
      } else {
        let distance = rep1;
        if (bit(isRepG1 + state)) {
          distance = rep2;
          if (bit(isRepG2 + state)) {
            distance = rep3;
            rep3 = rep2;
          }
          rep2 = rep1;
        }
        rep1 = rep0;
        rep0 = distance;
      }
      count = length(repLength);
      state = state < 7 ? 8 : 11;
    } else {
      rep3 = rep2;
      rep2 = rep1;
      rep1 = rep0;
      count = length(matchLength);
      state = state < 7 ? 7 : 10;
      const slot = tree(slots + (Math.min(count, lengthStates - 1) << 6), 6);
      if (slot < 4) rep0 = slot;
      else {
        const footer = (slot >> 1) - 1;
        rep0 = (2 | slot & 1) << footer;
        if (slot < 14) rep0 += treeBackwards(distances + rep0 - slot, footer);
        else rep0 += (evenBits(footer - 4) << 4) + treeBackwards(align, 4);
      }
    }
    const end = Math.min(at + count + 2, size);
    if (rep0 >= at) throw new Error("the page is damaged: load it again");
    for (let from = at - rep0 - 1; at < end;) out[at++] = out[from++];
  }
  return out;
}
