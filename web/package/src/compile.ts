import { LuxelError } from "./error.ts";

/** Compiles a module of WebAssembly while it arrives. */
export async function compile(url: string | URL): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) {
    throw new LuxelError(`${url}: ${response.status} ${response.statusText}`);
  }
  try {
    return await WebAssembly.compileStreaming(response.clone());
  } catch (error) {
    if (!(error instanceof TypeError)) {
      throw new LuxelError(
        "this browser can't run luxel: it needs WebAssembly with SIMD, as Chrome 91, Firefox 89 and Safari 16.4 have it",
      );
    }
    // A server that doesn't name the type of the file.
    return await WebAssembly.compile(await response.arrayBuffer());
  }
}
