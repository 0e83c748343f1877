// The page as the library embeds it: the built page with the rule that lets it run its own script
// and nothing else.
import { createHash } from "node:crypto";

/** `html` is what Vite built. What follows "connect-src" is filled in when the page is made. */
export function templateOf(html) {
  const script = /<script type="module"[^>]*>([\s\S]*?)<\/script>/.exec(html);
  if (!script) throw new Error("the built page has no inline script");
  const hash = createHash("sha256").update(script[1]).digest("base64");
  const policy =
    `default-src 'none'; script-src 'sha256-${hash}'; style-src 'unsafe-inline'; ` +
    `img-src data: blob:; connect-src retiarius-connect; base-uri 'none'; form-action 'none'`;
  return html
    .replace(
      "<!--retiarius:policy-->",
      `<meta http-equiv="Content-Security-Policy" content="${policy}" />`,
    )
    .replace(/<meta charset="utf-8"\s*\/?>/, '<meta charset="utf-8" />');
}
