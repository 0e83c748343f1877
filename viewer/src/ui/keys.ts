import { h } from "./dom";

export interface Command {
  keys: string[];
  /** How the key is written in the list; empty: not listed. */
  shown: string;
  text: string;
  run: () => void;
}

/** Listens to the keyboard outside fields, and lists the keys under "?". */
export function listenToKeys(commands: Command[]): { help: HTMLDialogElement; open: () => void } {
  const rows = commands
    .filter((c) => c.shown)
    .map((c) => h("tr", {}, h("th", { scope: "row" }, h("kbd", {}, c.shown)), h("td", {}, c.text)));
  const pointer: [string, string][] = [
    ["drag", "turn the view"],
    ["right drag, two fingers", "move the view"],
    ["wheel, pinch", "nearer or farther"],
    ["click", "history of a segment or node"],
  ];
  rows.push(
    ...pointer.map(([key, text]) => h("tr", {}, h("th", { scope: "row" }, key), h("td", {}, text))),
  );
  const help = h(
    "dialog",
    { class: "help", "aria-label": "Keys" },
    h(
      "header",
      {},
      h("h3", {}, "Keys and pointer"),
      h("button", { "aria-label": "Close", click: () => help.close() }, "\u00d7"),
    ),
    h("table", {}, h("tbody", {}, ...rows)),
  );
  help.addEventListener("click", (event) => {
    if (event.target === help) help.close();
  });
  const open = (): void => (help.open ? help.close() : help.showModal());
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target as HTMLElement;
    const typing = target.matches("input:not([type=range]):not([type=checkbox]), select, textarea");
    if (typing) return;
    // The slider and buttons keep the keys that they answer themselves.
    if (
      target.matches("button, summary, input[type=checkbox]") &&
      (event.key === " " || event.key === "Enter")
    )
      return;
    if (event.key === "?") open();
    if (help.open) return;
    const command = commands.find((c) => c.keys.includes(event.key));
    if (!command) return;
    event.preventDefault();
    command.run();
  });
  return { help, open };
}
