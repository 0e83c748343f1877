import { DataError } from "../format/errors";
import { type Source, textFiles, type Texts } from "./source";

/**
 * A run whose files a server hands out below the page's own address: the page asks for the new part
 * of replay.bin by byte range, and for the texts by relative address.
 */
export class HttpSource implements Source {
  live = true;

  constructor(
    readonly label: string,
    private readonly base = "",
  ) {}

  async replay(from: number): Promise<Uint8Array> {
    const answer = await this.ask("replay.bin", { Range: `bytes=${from}-` });
    // 416: nothing there yet beyond `from`; 404: the run has not begun to write.
    if (answer.status === 416 || answer.status === 404) return new Uint8Array(0);
    if (!answer.ok) throw new DataError(`the server answers ${answer.status} to replay.bin`);
    const bytes = new Uint8Array(await answer.arrayBuffer());
    return answer.status === 206 ? bytes : bytes.subarray(from);
  }

  async texts(): Promise<Texts> {
    const texts: Texts = {};
    await Promise.all(
      Object.entries(textFiles).map(async ([key, file]) => {
        const answer = await this.ask(file, {});
        if (answer.ok) texts[key as keyof Texts] = await answer.text();
      }),
    );
    if (texts.summary) this.live = false;
    return texts;
  }

  private async ask(file: string, headers: Record<string, string>): Promise<Response> {
    try {
      return await fetch(this.base + file, { headers, cache: "no-store" });
    } catch {
      throw new DataError("the server does not answer; is the program still running?");
    }
  }
}
