import { initSync, link_answers } from "{drawing}";

let compiled;
let failure;

/** Links the module that answers to the one that draws, which has been started. */
export function linkAnswers(module) {
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
