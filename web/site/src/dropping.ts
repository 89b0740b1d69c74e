/** Files that are dropped on the page, folders with all that is in them. */

/** The files of an entry by their paths. */
async function filesOf(entry: FileSystemEntry, files: Map<string, File>): Promise<void> {
  const path = entry.fullPath.replace(/^\//, "");
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
    files.set(path, file);
    return;
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  // It gives at most a hundred at a time.
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) return;
    for (const one of some) await filesOf(one, files);
  }
}

/** The files of a drop by their paths. */
async function dropped(transfer: DataTransfer): Promise<Map<string, File>> {
  const files = new Map<string, File>();
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.() ?? null);
  const plain = [...transfer.files];
  for (const entry of entries) {
    if (entry !== null) await filesOf(entry, files);
  }
  if (files.size === 0) {
    for (const file of plain) files.set(file.name, file);
  }
  return files;
}

/** Calls `open` with what is dropped anywhere on the page. */
export function listenToDrops(hint: HTMLElement, open: (files: Map<string, File>) => void): void {
  let depth = 0;
  const show = (isShown: boolean): void => {
    hint.hidden = !isShown;
  };
  addEventListener("dragenter", (event) => {
    event.preventDefault();
    depth += 1;
    show(true);
  });
  addEventListener("dragleave", () => {
    depth = Math.max(0, depth - 1);
    show(depth > 0);
  });
  addEventListener("dragover", (event) => {
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = "copy";
  });
  addEventListener("drop", (event) => {
    event.preventDefault();
    depth = 0;
    show(false);
    if (event.dataTransfer) {
      void dropped(event.dataTransfer).then((files) => {
        if (files.size > 0) open(files);
      });
    }
  });
}
