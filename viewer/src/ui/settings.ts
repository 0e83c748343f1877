import { type Preset, presets } from "../scene/camera";
import { isOnNodes, quantities, type Quantity } from "../scene/instant";
import type { Follow } from "../scene/stage";
import { choice, h } from "./dom";
import { quantityNames } from "./legend";
import type { Store } from "./state";

/** What is shown and from where: colours, parts, camera. */
export class Settings {
  readonly element: HTMLElement;

  constructor(
    store: Store,
    hasBodies: boolean,
    colourBy: (quantity: Quantity) => void,
    look: (preset: Preset) => void,
  ) {
    const colour = choice(
      "Colour by",
      quantities.map((q) => [q, quantityNames[q] + (isOnNodes(q) ? "" : "")] as const),
      store.now.quantity,
      (value) => colourBy(value as Quantity),
    );
    const targets: [Follow, string][] = [
      ["nothing", "Nothing"],
      ["net", "Net"],
    ];
    if (hasBodies) targets.push(["target", "Target"]);
    const follow = choice("Follow", targets, store.now.follow, (value) =>
      store.set({ follow: value as Follow }),
    );
    const views = h(
      "div",
      { class: "group", role: "group", "aria-label": "Camera" },
      ...(Object.keys(presets) as Preset[]).map((preset, k) =>
        h("button", { title: `View: ${preset} (${k + 1})`, click: () => look(preset) }, preset),
      ),
    );
    const check = (label: string, key: "knots" | "bullets" | "grid"): HTMLElement => {
      const box = h("input", { type: "checkbox", change: () => store.set({ [key]: box.checked }) });
      box.checked = store.now[key];
      store.listen((state) => (box.checked = state[key]));
      return h("label", { class: "check" }, box, label);
    };
    this.element = h(
      "div",
      { class: "settings" },
      colour.element,
      follow.element,
      views,
      h(
        "div",
        { class: "checks" },
        check("Corner masses", "bullets"),
        check("Knots", "knots"),
        check("Grid", "grid"),
      ),
    );
    store.listen((state) => {
      colour.select.value = state.quantity;
      follow.select.value = state.follow;
    });
  }
}
