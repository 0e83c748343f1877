/** What is wrong with data that the page was given; its text is shown to the reader. */
export class DataError extends Error {
  override name = "DataError";
}
