import { DataError } from "../format/errors";
import { type Source, textFiles, type Texts } from "./source";

/**
 * A run whose files a server hands out below the page's own address: the page asks for the new part
 * of replay.bin and of history.csv by byte range, and for the other texts as they are.
 */
export class HttpSource implements Source {
  live = true;
  private readonly known: Texts = {};
  private readonly historyParts: Uint8Array[] = [];
  private historyBytes = 0;

  constructor(
    readonly label: string,
    private readonly base = "",
  ) {}

  replay(from: number): Promise<Uint8Array> {
    return this.part("replay.bin", from);
  }

  async texts(): Promise<Texts> {
    // The summary is written last: when it is there, the others are complete.
    this.known.summary = await this.text(textFiles.summary);
    if (this.known.summary) this.live = false;
    const part = await this.part(textFiles.history, this.historyBytes);
    if (part.length > 0) {
      this.historyParts.push(part);
      this.historyBytes += part.length;
      this.known.history = await new Blob(this.historyParts as BlobPart[]).text();
    }
    this.known.mission ??= await this.text(textFiles.mission);
    this.known.resolved ??= await this.text(textFiles.resolved);
    return this.known;
  }

  /** Bytes of a growing file; none where it is not there yet, or has nothing new. */
  private async part(file: string, from: number): Promise<Uint8Array> {
    const answer = await this.ask(file, { Range: `bytes=${from}-` });
    if (answer.status === 416 || answer.status === 404) return new Uint8Array(0);
    if (!answer.ok) throw new DataError(`the server answers ${answer.status} to ${file}`);
    const bytes = new Uint8Array(await answer.arrayBuffer());
    return answer.status === 206 ? bytes : bytes.subarray(from);
  }

  private async text(file: string): Promise<string | undefined> {
    const answer = await this.ask(file, {});
    return answer.status === 200 ? answer.text() : undefined;
  }

  private async ask(file: string, headers: Record<string, string>): Promise<Response> {
    try {
      return await fetch(this.base + file, { headers, cache: "no-store" });
    } catch {
      throw new DataError("the server does not answer; is the program still running?");
    }
  }
}
