// The formula of a key, typed live: the run follows while it can be read, and a line says why where it cannot.
// SPDX-License-Identifier: GPL-3.0-or-later
import { byId, make } from "./dom";

export class FormulaField {
  private readonly field = make("input", { type: "text", id: "formula-text", spellcheck: "false", autocapitalize: "off",
                                           "aria-describedby": "formula-error" });
  private readonly error = make("span", { id: "formula-error", role: "status" });

  /// `set` takes a formula and says what is wrong with it; empty: nothing.
  constructor(set: (text: string) => string) {
    byId("formula").append(make("label", { for: "formula-text" }, "key ="), this.field, this.error);
    this.field.addEventListener("input", () => {
      const wrong = set(this.field.value);
      this.error.textContent = wrong;
      this.field.setAttribute("aria-invalid", String(wrong !== ""));
    });
  }

  show(formula: string | undefined) {
    const box = byId("formula");
    box.hidden = formula === undefined;
    if (formula === undefined || document.activeElement === this.field) return;
    if (this.field.value !== formula) this.field.value = formula;
    this.error.textContent = "";
    this.field.setAttribute("aria-invalid", "false");
  }
}
