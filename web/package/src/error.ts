/** A failure: what luxel says of a file, a setting or a worker. */
export class LuxelError extends Error {
  override name = "LuxelError";
}
