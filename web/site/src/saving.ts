/** What leaves the page: files and copied texts. */

import { element } from "./dom.ts";

/** Saves data as a file of the reader's. */
export function download(data: Blob, name: string): void {
  const link = element("a", { href: URL.createObjectURL(data), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Copies a text, and says so on the button for a while. */
export async function copied(text: string, button: HTMLElement): Promise<void> {
  const label = button.textContent;
  await navigator.clipboard.writeText(text);
  button.textContent = "Copied";
  setTimeout(() => (button.textContent = label), 1500);
}
