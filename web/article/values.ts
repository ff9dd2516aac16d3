// Numbers in the prose: the core fills them in, and a number under mouse, finger or focus lights up its place.
// SPDX-License-Identifier: GPL-3.0-or-later
import { make } from "../page/dom";

/// Names whose place is that of another name; those that are their own place stand alone.
const placeOf: Record<string, string> = {
  key: "cell", cell_share: "cell", step_drawn: "cell", step_visible: "cell", runner_up_key: "runner_up",
  coverage: "found", visible_share: "visible", drawn_share: "drawn", budget: "drawn", verdict: "node",
};
const ownPlace = ["segments", "in_view", "hidden", "visible", "drawn", "found", "missed", "wasted", "cell", "next",
    "seed",
                  "runner_up", "front", "projected", "fullest", "wrong", "deepest", "node"];
export const placeName = (value: string) => placeOf[value] ?? (ownPlace.includes(value) ? value : undefined);

/// "street.visible" in `data-value` becomes a button, or plain text where nothing in the picture is meant. `thing`: the
/// number is that of such a thing, "cell".
export function raise(value: HTMLElement, thing: string | undefined, light: (name: string | null) => void):
    HTMLElement {
  const name = value.dataset.value!.split(".").pop()!, place = thing ?? placeName(name);
  if (!place) return value;
  const button = make("button", { type: "button", class: "n", "data-value": value.dataset.value, "data-place": place },
                      value.textContent ?? "…");
  const show = () => light(thing ? `${thing} ${button.textContent}` : place);
  for (const event of ["mouseenter", "focus", "click"]) button.addEventListener(event, show);
  // One that was tapped stays lit: the mouse that a browser makes up for a finger leaves when the page moves.
  button.addEventListener("mouseleave", () => { if (document.activeElement !== button) light(null); });
  button.addEventListener("blur", () => light(null));
  value.replaceWith(button);
  return button;
}
