import type { Theme } from "../scene/colour";

const key = "retiarius-theme";

/** The reader's last choice, or what the system prefers. */
export function initialTheme(): Theme {
  const kept = storage()?.getItem(key);
  if (kept === "light" || kept === "dark") return kept;
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

export function applyTheme(theme: Theme): void {
  document.documentElement.dataset["theme"] = theme;
}

export function keepTheme(theme: Theme): void {
  storage()?.setItem(key, theme);
}

/** Some browsers refuse it to pages opened from a file. */
function storage(): Storage | undefined {
  try {
    return window.localStorage;
  } catch {
    return undefined;
  }
}
