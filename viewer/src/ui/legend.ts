import type { Header } from "../format/header";
import { numberText, unitText } from "../format/number";
import {
  contactColour,
  css,
  type Range,
  scaleColour,
  type Theme,
  valueAtPlace,
} from "../scene/colour";
import type { Quantity } from "../scene/instant";
import { h } from "./dom";
import type { Store } from "./state";

export const quantityNames: Record<Quantity, string> = {
  tension: "Tension",
  strain: "Strain",
  curvature: "Curvature",
  speed: "Speed",
  contact: "Contact",
};

export function unitOf(header: Header, quantity: Quantity): string {
  return unitText(header.channels.find((c) => c.name === quantity)?.unit ?? "1");
}

/** The colours with their numbers, and the control of the range. */
export class Legend {
  readonly element: HTMLElement;
  private readonly bar = h("div", { class: "bar" });
  private readonly marks = h("div", { class: "marks" });
  private readonly states = h("div", { class: "states" });
  private readonly title = h("span", { class: "title" });
  private readonly low: HTMLInputElement;
  private readonly high: HTMLInputElement;
  private readonly log: HTMLInputElement;
  private readonly control: HTMLElement;

  constructor(
    private readonly header: Header,
    private readonly store: Store,
    private readonly usual: () => Range,
  ) {
    const number = (label: string): HTMLInputElement =>
      h("input", { type: "number", step: "any", "aria-label": label, change: () => this.read() });
    this.low = number("Lowest value of the colour range");
    this.high = number("Highest value of the colour range");
    this.log = h("input", { type: "checkbox", change: () => this.read() });
    this.control = h(
      "details",
      { class: "range" },
      h("summary", {}, "Range"),
      h(
        "div",
        {},
        h("label", {}, "from ", this.low),
        h("label", {}, "to ", this.high),
        h("label", { class: "check" }, this.log, "logarithmic"),
        h("button", { click: () => this.store.set({ range: this.usual() }) }, "Reset"),
      ),
    );
    this.element = h(
      "div",
      { class: "legend" },
      this.title,
      this.bar,
      this.marks,
      this.states,
      this.control,
    );
    store.listen((_, changed) => {
      if (changed.has("range") || changed.has("quantity") || changed.has("theme")) this.show();
    });
    this.show();
  }

  private read(): void {
    const logarithmic = this.log.checked;
    let [low, high] = [Number(this.low.value), Number(this.high.value)];
    if (!Number.isFinite(low) || !Number.isFinite(high) || high <= low) return this.show();
    // A logarithm needs a start above zero: three decades below the end.
    if (logarithmic && low <= 0) low = high / 1000;
    if (!logarithmic && this.store.now.range.logarithmic && low === high / 1000) low = 0;
    this.store.set({ range: { low, high, logarithmic } });
  }

  private show(): void {
    const { quantity, range, theme } = this.store.now;
    const unit = unitOf(this.header, quantity);
    const contact = quantity === "contact";
    this.title.textContent = unit
      ? `${quantityNames[quantity]} / ${unit}`
      : quantityNames[quantity];
    this.bar.hidden = this.marks.hidden = this.control.hidden = contact;
    this.states.hidden = !contact;
    this.showStates(theme);
    const stops = Array.from({ length: 17 }, (_, k) => css(scaleColour(k / 16, theme)));
    this.bar.style.background = `linear-gradient(90deg, ${stops.join(",")})`;
    this.marks.replaceChildren(
      ...[0, 0.5, 1].map((t) => h("span", {}, numberText(valueAtPlace(t, range), 3))),
    );
    this.low.value = String(range.low);
    this.high.value = String(range.high);
    this.log.checked = range.logarithmic;
  }

  private showStates(theme: Theme): void {
    this.states.replaceChildren(
      ...["free", "slides", "sticks"].map((name, k) =>
        h("span", {}, h("i", { style: `background:${css(contactColour(k, theme))}` }), name),
      ),
    );
  }
}
