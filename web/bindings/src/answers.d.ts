/** Links the module that answers to the one that draws, which has been started. */
export function linkAnswers(module: WebAssembly.Module): void;
