/** Colours of values, and how numbers are written beside them. */

export type Theme = "light" | "dark";
export type Rgb = [number, number, number];

/** OKLCH (lightness 0 to 1, chroma, hue in degrees) to sRGB, 0 to 1 each. */
export function oklch(lightness: number, chroma: number, hue: number): Rgb {
  const h = (hue * Math.PI) / 180;
  const a = chroma * Math.cos(h);
  const b = chroma * Math.sin(h);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const linear: Rgb = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return linear.map((c) => {
    const x = Math.min(1, Math.max(0, c));
    return x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055;
  }) as Rgb;
}

/**
 * A scale from violet over blue and green to yellow. Lightness rises evenly, so that the order of
 * values is seen without hue, by colour-blind readers too. On a light ground it runs the other way,
 * from pale to dark: large values stand out on either ground.
 */
export function scaleColour(t: number, theme: Theme): Rgb {
  const u = Math.min(1, Math.max(0, t));
  // Less chroma in the middle, where blue-greens of the display end.
  const ends = (2 * u - 1) ** 2;
  return theme === "dark"
    ? oklch(0.52 + 0.41 * u, 0.11 + 0.035 * ends, 292 - 190 * u)
    : oklch(0.8 - 0.5 * u, 0.084 + 0.05 * ends, 112 + 186 * u);
}

/** Not in contact, slides, sticks: told apart by colour-blind readers, after Okabe and Ito. */
export function contactColour(state: number, theme: Theme): Rgb {
  if (state === 1) return theme === "dark" ? [1, 0.62, 0.1] : [0.84, 0.37, 0];
  if (state === 2) return theme === "dark" ? [0.42, 0.78, 1] : [0, 0.38, 0.68];
  return theme === "dark" ? [0.5, 0.54, 0.6] : [0.62, 0.66, 0.71];
}

export const scaleSteps = 256;

/** RGBA bytes of the scale, low to high, or of the three states of contact spread over it. */
export function scaleBytes(theme: Theme, contact: boolean): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(4 * scaleSteps);
  for (let k = 0; k < scaleSteps; ++k) {
    const t = k / (scaleSteps - 1);
    const rgb = contact ? contactColour(Math.round(2 * t), theme) : scaleColour(t, theme);
    rgb.forEach((c, i) => (bytes[4 * k + i] = Math.round(255 * c)));
    bytes[4 * k + 3] = 255;
  }
  return bytes;
}

export interface Range {
  low: number;
  high: number;
  logarithmic: boolean;
}

/** Where in the scale a value lies, 0 to 1. */
export function placeInRange(value: number, range: Range): number {
  const { low, high, logarithmic } = range;
  if (!(high > low)) return value > low ? 1 : 0;
  const t = logarithmic
    ? value <= 0
      ? 0
      : Math.log(value / low) / Math.log(high / low)
    : (value - low) / (high - low);
  return Math.min(1, Math.max(0, t));
}

/** The value at a place in the scale. */
export function valueAtPlace(t: number, { low, high, logarithmic }: Range): number {
  return logarithmic ? low * (high / low) ** t : low + t * (high - low);
}

export function css([r, g, b]: Rgb): string {
  return `rgb(${Math.round(255 * r)} ${Math.round(255 * g)} ${Math.round(255 * b)})`;
}
