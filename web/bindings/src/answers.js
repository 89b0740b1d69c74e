import { initSync, link_answers } from "{drawing}";

let compiled;
let failure;

/** Links the module that answers to the one that draws, which has been started. */
export function linkAnswers(module) {
  const [build] = WebAssembly.Module.customSections(module, "luxel-build");
  if (build === undefined || new TextDecoder().decode(build) !== "{build}") {
    throw new Error("answers.wasm is of another build than the rest of luxel");
  }
  compiled = module;
  failure = undefined;
  try {
    link_answers();
  } catch (error) {
    throw failure ?? error;
  }
}

/** What `link_answers` calls: both modules share memory and functions. */
export function __wasm_split_load_answers(callback, data) {
  const drawing = initSync();
  try {
    new WebAssembly.Instance(compiled, { __wasm_split: drawing });
  } catch (error) {
    failure = error;
  }
  drawing.__indirect_function_table.get(callback)(data, failure === undefined);
}
