/** Numbers and names as people read them. */

/** Up to `digits` significant digits, a true minus sign, powers of ten where they are shorter. */
export function numberText(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "\u2013";
  if (value === 0) return "0";
  const size = Math.abs(value);
  let text: string;
  if (size >= 1e6 || size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e") as [string, string];
    const short = mantissa.includes(".") ? mantissa.replace(/\.?0+$/, "") : mantissa;
    text = `${short}\u00b7${"10"}${superscript(exponent)}`;
  } else {
    const rounded = Number(value.toPrecision(digits));
    text = String(rounded);
  }
  return text.replace("-", "\u2212");
}

function superscript(exponent: string): string {
  const raised = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";
  const sign = exponent.startsWith("-") ? "\u207b" : "";
  return sign + [...exponent.replace(/^[+-]/, "")].map((d) => raised[Number(d)]).join("");
}

/** "m2" as "m\u00b2"; the unit "1" is none. */
export function unitText(unit: string): string {
  if (unit === "1") return "";
  return unit.replace(/(?<=\S)2/g, "\u00b2").replace(/(?<=\S)3/g, "\u00b3");
}

export function withUnit(value: number, unit: string, digits = 4): string {
  const shown = unitText(unit);
  return numberText(value, digits) + (shown && Number.isFinite(value) ? `\u00a0${shown}` : "");
}

/** "mouth_area_max" as "Mouth area max". */
export function spaced(name: string): string {
  const words = name.replaceAll("_", " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}
