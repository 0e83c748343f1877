import { DataError } from "./errors";

/** Inflates a zlib ("deflate") or gzip stream with what the browser has built in. */
export async function inflate(bytes: Uint8Array, form: "deflate" | "gzip"): Promise<Uint8Array> {
  const stream = new Blob([bytes as Uint8Array<ArrayBuffer>])
    .stream()
    .pipeThrough(new DecompressionStream(form));
  try {
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new DataError("the recording is damaged: a part of it does not inflate");
  }
}
