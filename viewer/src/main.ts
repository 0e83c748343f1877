import { embeddedSources } from "./data/embedded";
import { HttpSource } from "./data/http";
import { Run } from "./data/run";
import { DataError } from "./format/errors";
import { exposeForScripts } from "./scripting";
import { App } from "./ui/app";
import { fail, showHeading } from "./ui/heading";
import { tables } from "./ui/tables";
import "./style.css";

const pollInterval = 700; // ms

async function start(): Promise<void> {
  const place = document.getElementById("app")!;
  const embedded = embeddedSources(document);
  const runs = (embedded.length > 0 ? embedded : [new HttpSource("run")]).map(
    (source) => new Run(source),
  );
  try {
    for (const run of runs) await run.update();
    while (runs.some((run) => run.live && run.recording.count === 0)) {
      showHeading(runs, "waiting for the run's first frame");
      await pause();
      for (const run of runs) await run.update();
    }
    for (const run of runs) check(run);
    const app = new App(runs, place, fail);
    await app.start();
    showHeading(runs);
    exposeForScripts(app);
    document.documentElement.dataset["ready"] = "yes";
    if (runs.some((run) => run.live)) await follow(runs, app);
  } catch (error) {
    if (runs.some((run) => run.summary) && place.childElementCount === 0)
      place.append(tables(runs));
    fail(error);
  }
}

function check(run: Run): void {
  const { recording } = run;
  if (!recording.header)
    throw new DataError(`the recording of ${run.label} is cut off before its header`);
  if (recording.count === 0) throw new DataError(`the recording of ${run.label} holds no frame`);
}

/** Asks for what is new until the runs have ended, or the server does not answer. */
async function follow(runs: Run[], app: App): Promise<void> {
  try {
    while (runs.some((run) => run.live)) {
      await pause();
      let any = false;
      for (const run of runs) if (run.live && (await run.update())) any = true;
      if (any) await app.grow();
      if (any) showHeading(runs);
    }
  } catch (error) {
    fail(error, "The run is no longer followed.");
  }
}

function pause(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, pollInterval));
}

void start();
