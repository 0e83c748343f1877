import { DataError } from "../format/errors";
import { inflate } from "../format/inflate";
import { type Source, textFiles, type Texts } from "./source";

/** Bytes of base64 text; line breaks are allowed. Throws DataError. */
export function fromBase64(text: string): Uint8Array {
  const known = Uint8Array as unknown as { fromBase64?: (text: string) => Uint8Array };
  try {
    if (known.fromBase64) return known.fromBase64(text);
    const letters = atob(text);
    const bytes = new Uint8Array(letters.length);
    for (let k = 0; k < letters.length; ++k) bytes[k] = letters.charCodeAt(k);
    return bytes;
  } catch {
    throw new DataError("the page is damaged: one of its data blocks is no base64 text");
  }
}

/** A run whose files lie in the page itself, in elements <script type="application/octet-stream">. */
class EmbeddedSource implements Source {
  readonly live = false;

  constructor(
    readonly label: string,
    private readonly blocks: Map<string, HTMLElement>,
  ) {}

  async replay(from: number): Promise<Uint8Array> {
    const bytes = await this.bytes("replay.bin");
    if (!bytes) throw new DataError("the page has no recording of this run (replay.bin)");
    return bytes.subarray(from);
  }

  async texts(): Promise<Texts> {
    const texts: Texts = {};
    for (const [key, file] of Object.entries(textFiles)) {
      const bytes = await this.bytes(file);
      if (bytes) texts[key as keyof Texts] = new TextDecoder().decode(bytes);
    }
    return texts;
  }

  private async bytes(file: string): Promise<Uint8Array | undefined> {
    const block = this.blocks.get(file);
    if (!block) return undefined;
    const bytes = fromBase64(block.textContent ?? "");
    // The text is not needed again, and may be large.
    block.textContent = "";
    this.blocks.delete(file);
    return block.dataset["encoding"] === "deflate" ? inflate(bytes, "deflate") : bytes;
  }
}

/** The runs that the page carries, in the order of the page; none in a page that asks a server. */
export function embeddedSources(page: ParentNode): Source[] {
  const runs = new Map<string, Map<string, HTMLElement>>();
  for (const block of page.querySelectorAll<HTMLElement>("script[data-run][data-file]")) {
    const run = block.dataset["run"]!;
    if (!runs.has(run)) runs.set(run, new Map());
    runs.get(run)!.set(block.dataset["file"]!, block);
  }
  return [...runs].map(([label, blocks]) => new EmbeddedSource(label, blocks));
}
