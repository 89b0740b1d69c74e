// A model that turns under the hand. Events are sent to the worker one batch at a time: while it draws, they
// gather here.

const HELP = "Drag to turn, shift and drag to pan, wheel to zoom, click to explain a pixel. Arrows, +, −, Home.";
const KEYS = {
  ArrowLeft: ["tap", "orbit-left", 1],
  ArrowRight: ["tap", "orbit-right", 1],
  ArrowUp: ["tap", "orbit-up", 1],
  ArrowDown: ["tap", "orbit-down", 1],
  Home: ["home"],
};
/** Milliseconds of rest after which the picture is drawn in full. */
const REST = 120;
/** Pixels that a click may move. */
const CLICK = 3;

/** The bytes of a trait, whatever kind of buffer the front end has made of them. */
function bytes(value) {
  return new Uint8Array(value.buffer ?? value, value.byteOffset ?? 0, value.byteLength);
}

function element(name, properties, parent) {
  const made = Object.assign(document.createElement(name), properties);
  parent.append(made);
  return made;
}

function render({ model, el }) {
  const [width, height] = model.get("_size");
  const root = element("div", { className: "luxel" }, el);
  const canvas = element("canvas", { width, height, tabIndex: 0 }, root);
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", `A 3D model. ${HELP}`);
  const help = element("p", { className: "luxel-help", textContent: HELP }, root);
  const ledger = element("pre", { className: "luxel-ledger", hidden: true }, root);
  ledger.setAttribute("aria-live", "polite");
  const context = canvas.getContext("2d");

  // The kernel's picture stands there until the worker has drawn.
  let drawn = false;
  createImageBitmap(new Blob([bytes(model.get("_picture"))], { type: "image/png" })).then((picture) => {
    if (!drawn) context.drawImage(picture, 0, 0);
  });

  const source = new Blob([model.get("_worker")], { type: "text/javascript" });
  const address = URL.createObjectURL(source);
  const worker = new Worker(address);
  let busy = true;
  let events = [];
  let moving = false;
  let wanted = "full";
  let asked = null;
  let timer = 0;

  function fail(message) {
    help.textContent = `The model can't be turned here: ${message}`;
    help.setAttribute("role", "alert");
  }

  function pump() {
    if (busy) return;
    if (events.length > 0 || wanted) {
      busy = true;
      worker.postMessage({ type: "step", events, full: !moving });
      events = [];
      wanted = null;
    } else if (asked) {
      busy = true;
      worker.postMessage({ type: "explain", ...asked });
      asked = null;
    }
  }

  function happen(...event) {
    const last = events.at(-1);
    if (event[0] === "drag" && last?.[0] === "drag") events.pop();
    events.push(event);
    moving = true;
    clearTimeout(timer);
    timer = setTimeout(() => {
      moving = false;
      wanted = "full";
      pump();
    }, REST);
    pump();
  }

  worker.onerror = (event) => fail(event.message || "the page forbids workers");
  worker.onmessage = ({ data }) => {
    busy = false;
    if (data.type === "failure") {
      fail(data.message);
      return;
    }
    if (data.type === "step") {
      drawn = true;
      const pixels = new Uint8ClampedArray(data.pixels.buffer);
      context.putImageData(new ImageData(pixels, data.width, data.height), 0, 0);
      canvas.dataset.drawn = data.full ? "full" : "draft";
      if (data.full) {
        model.set("camera", data.camera);
        model.save_changes();
      }
    } else if (data.type === "explain") {
      ledger.hidden = false;
      ledger.textContent = data.text;
      model.set("picked", { pixel: data.pixel, object: data.object, ledger: data.ledger });
      model.save_changes();
    }
    pump();
  };
  worker.postMessage({
    type: "open",
    module: bytes(model.get("_module")),
    scene: bytes(model.get("_scene")),
    view: bytes(model.get("_view")),
  });

  /** A pointer's place in the picture, which the page may show larger or smaller. */
  function place(event) {
    const box = canvas.getBoundingClientRect();
    const x = ((event.clientX - box.left) * width) / box.width;
    const y = ((event.clientY - box.top) * height) / box.height;
    return [x, y];
  }

  let pressed = null;
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    pressed = { at: place(event), moved: false, pan: event.shiftKey || event.button === 1 };
    event.preventDefault();
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!pressed) return;
    const at = place(event);
    const way = Math.hypot(at[0] - pressed.at[0], at[1] - pressed.at[1]);
    if (!pressed.moved && way <= CLICK) return;
    if (!pressed.moved) happen("grab", pressed.pan ? "pan" : "turn", ...pressed.at);
    pressed.moved = true;
    happen("drag", ...at);
  });
  canvas.addEventListener("pointerup", (event) => {
    if (pressed?.moved) happen("release");
    else if (pressed) {
      const [x, y] = place(event).map(Math.floor);
      if (x >= 0 && y >= 0 && x < width && y < height) {
        asked = { x, y };
        pump();
      }
    }
    pressed = null;
  });
  canvas.addEventListener("pointercancel", () => {
    if (pressed?.moved) happen("release");
    pressed = null;
  });
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      happen("wheel", -event.deltaY / (event.deltaMode === 0 ? 100 : 3), ...place(event));
    },
    { passive: false },
  );
  canvas.addEventListener("keydown", (event) => {
    const key = KEYS[event.key];
    if (key) happen(...key);
    else if (event.key === "+") happen("wheel", 1, width / 2, height / 2);
    else if (event.key === "-") happen("wheel", -1, width / 2, height / 2);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });

  return () => {
    clearTimeout(timer);
    worker.terminate();
    URL.revokeObjectURL(address);
  };
}

export default { render };
