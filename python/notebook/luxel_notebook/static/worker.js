// Draws a model in a worker, so that the page never waits. Stands behind the module's own JavaScript.
let view = null;

/** The bytes of a compressed buffer. */
async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const handlers = {
  async open({ module, scene, view: packed }) {
    const buffers = await Promise.all([module, scene, packed].map(inflated));
    wasm_bindgen.initSync({ module: buffers[0] });
    view = new wasm_bindgen.ModelView(buffers[1], buffers[2]);
    return {};
  },

  /** Moves the camera, then draws. */
  step({ events, full }) {
    for (const [name, ...values] of events) {
      view[name](...values);
    }
    const pixels = full ? view.draw(0) : view.draft();
    return { pixels, full, width: view.width, height: view.height, camera: Array.from(view.camera) };
  },

  explain({ x, y }) {
    return {
      pixel: [x, y],
      object: view.pick(x + 0.5, y + 0.5) ?? null,
      text: view.explain(x, y),
      ledger: JSON.parse(view.explain_json(x, y)),
    };
  },
};

onmessage = async ({ data }) => {
  try {
    const result = await handlers[data.type](data);
    postMessage({ type: data.type, ...result }, result.pixels ? [result.pixels.buffer] : []);
  } catch (error) {
    postMessage({ type: "failure", message: String(error.message ?? error) });
  }
};
