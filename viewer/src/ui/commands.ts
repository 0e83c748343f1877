import { type Preset, presets } from "../scene/camera";
import { quantities, type Quantity } from "../scene/instant";
import type { Command } from "./keys";
import type { Store } from "./state";
import { fittingSpeed, type Transport } from "./transport";

export interface Deeds {
  look(preset: Preset): void;
  colourBy(quantity: Quantity): void;
  turnTheme(): void;
}

/** What the keyboard does. */
export function commands(store: Store, transport: Transport, deeds: Deeds): Command[] {
  const step = (n: number) => () => transport.step(n);
  const speed = (factor: number) => () =>
    store.set({ speed: fittingSpeed(12 * store.now.speed * factor) });
  return [
    { keys: [" "], shown: "space", text: "play or pause", run: () => transport.toggle() },
    { keys: [",", "ArrowLeft"], shown: ",  \u2190", text: "one frame back", run: step(-1) },
    { keys: [".", "ArrowRight"], shown: ".  \u2192", text: "one frame on", run: step(1) },
    {
      keys: ["Home"],
      shown: "Home",
      text: "to the start",
      run: () => store.set({ time: transport.start }),
    },
    {
      keys: ["End"],
      shown: "End",
      text: "to the end",
      run: () => store.set({ time: transport.end }),
    },
    { keys: ["["], shown: "[", text: "slower", run: speed(0.5) },
    { keys: ["]"], shown: "]", text: "faster", run: speed(2) },
    ...Object.keys(presets).map((preset, k) => ({
      keys: [String(k + 1)],
      shown: String(k + 1),
      text: `view: ${preset}`,
      run: () => deeds.look(preset as Preset),
    })),
    {
      keys: ["c"],
      shown: "c",
      text: "colour by the next quantity",
      run: () =>
        deeds.colourBy(
          quantities[(quantities.indexOf(store.now.quantity) + 1) % quantities.length]!,
        ),
    },
    {
      keys: ["f"],
      shown: "f",
      text: "follow the net, or nothing",
      run: () => store.set({ follow: store.now.follow === "net" ? "nothing" : "net" }),
    },
    {
      keys: ["k"],
      shown: "k",
      text: "knots on or off",
      run: () => store.set({ knots: !store.now.knots }),
    },
    {
      keys: ["g"],
      shown: "g",
      text: "grid on or off",
      run: () => store.set({ grid: !store.now.grid }),
    },
    { keys: ["t"], shown: "t", text: "light or dark", run: () => deeds.turnTheme() },
    {
      keys: ["Escape"],
      shown: "Esc",
      text: "close the history of what was clicked",
      run: () => store.set({ selection: undefined }),
    },
  ];
}
