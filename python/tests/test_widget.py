"""The widget in a browser, with pointer and keys; needs Chromium and playwright, else it is skipped aloud."""

import base64
import json
import pathlib
import shutil
from collections.abc import Iterator
from typing import Any

import luxel
import numpy as np
import pytest

luxel_notebook = pytest.importorskip("luxel_notebook")

SIZE = (240, 180)
BROWSERS = ("chromium", "chromium-browser", "google-chrome")

PAGE = """<!doctype html><meta charset="utf-8"><title>widget</title><div id="here"></div>
<script type="module">
const traits = TRAITS;
for (const [name, value] of Object.entries(traits)) {
  if (value?.base64 !== undefined) {
    traits[name] = new DataView(Uint8Array.from(atob(value.base64), (letter) => letter.charCodeAt(0)).buffer);
  }
}
window.traits = traits;
const model = {
  get: (name) => traits[name],
  set: (name, value) => { traits[name] = value; },
  save_changes: () => {},
};
const source = new Blob([SOURCE], { type: "text/javascript" });
const widget = await import(URL.createObjectURL(source));
window.cleanup = widget.default.render({ model, el: document.getElementById("here") });
</script>"""


def page_of(widget: Any) -> str:
    """A page with the widget, as a notebook saves it: without a kernel."""
    traits: dict[str, Any] = {}
    for name in ("_module", "_worker", "_scene", "_view", "_picture", "_size", "camera", "picked"):
        value = getattr(widget, name)
        traits[name] = {"base64": base64.b64encode(value).decode()} if isinstance(value, bytes) else value
    static = pathlib.Path(luxel_notebook.__file__).parent / "static"
    source = json.dumps((static / "widget.js").read_text("utf-8"))
    safe = [text.replace("</", "<\\/") for text in (json.dumps(traits), source)]
    return PAGE.replace("TRAITS", safe[0]).replace("SOURCE", safe[1])


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    sync_api = pytest.importorskip("playwright.sync_api")
    program = next(filter(None, map(shutil.which, BROWSERS)), None)
    if program is None:
        pytest.skip("no Chromium")
    with sync_api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield browser
        browser.close()


@pytest.fixture
def shown(browser: Any, tmp_path: pathlib.Path) -> Iterator[Any]:
    """A page with the widget of the view, drawn."""
    pages = []

    def shown(view: luxel.View) -> Any:
        path = tmp_path / "page.html"
        path.write_text(page_of(luxel_notebook.Widget(view)), "utf-8")
        page = browser.new_page()
        errors: list[str] = []
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.on("console", lambda line: errors.append(line.text) if line.type == "error" else None)
        page.goto(path.as_uri())
        wait(page)
        pages.append((page, errors))
        return page

    yield shown
    for page, errors in pages:
        page.close()
        assert errors == []


def wait(page: Any) -> None:
    """Until the worker has drawn in full and nothing moves."""
    page.wait_for_timeout(200)
    page.wait_for_selector('canvas[data-drawn="full"]', timeout=20_000)


def pixels(page: Any) -> np.ndarray:
    script = """() => {
        const canvas = document.querySelector("canvas");
        return Array.from(canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data);
    }"""
    return np.array(page.evaluate(script), dtype=np.uint8).reshape(SIZE[1], SIZE[0], 4)


@pytest.fixture(scope="module")
def scene() -> luxel.Scene:
    return luxel.load("demo:teapot")


def test_the_page_draws_other_bytes_than_the_kernel(scene, shown):
    view = scene.view(SIZE, background="white", shadows=True)
    page = shown(view)
    assert np.array_equal(pixels(page), view.render().rgba)


def test_a_drag_leaves_the_camera_where_the_kernel_can_not_follow(scene, shown):
    page = shown(scene.view(SIZE, background="white"))
    before = pixels(page)
    box = page.locator("canvas").bounding_box()
    page.mouse.move(box["x"] + 60, box["y"] + 90)
    page.mouse.down()
    for step in range(1, 9):
        page.mouse.move(box["x"] + 60 + 10 * step, box["y"] + 90 + 2 * step)
    page.mouse.up()
    wait(page)
    after = pixels(page)
    assert not np.array_equal(before, after)
    widget = luxel_notebook.Widget(scene.view(SIZE))
    widget.camera = page.evaluate("traits.camera")
    again = scene.render(SIZE, widget.pose, background="white").rgba
    # The pose is turned into a matrix and back.
    assert np.mean(np.any(again != after, axis=2)) < 0.01


def test_keys_and_wheel_do_nothing(scene, shown):
    page = shown(scene.view(SIZE, background="white"))
    seen = [pixels(page)]
    page.locator("canvas").focus()
    for key in ("ArrowLeft", "ArrowUp", "+"):
        page.keyboard.press(key)
        wait(page)
        assert not np.array_equal(pixels(page), seen[-1]), key
        seen.append(pixels(page))
    page.keyboard.press("Home")
    wait(page)
    assert np.array_equal(pixels(page), seen[0])
    box = page.locator("canvas").bounding_box()
    page.mouse.move(box["x"] + 120, box["y"] + 90)
    page.mouse.wheel(0, -300)
    wait(page)
    assert not np.array_equal(pixels(page), seen[0])


def test_a_click_explains_another_pixel_than_the_kernel(scene, shown):
    view = scene.view(SIZE, background="white")
    page = shown(view)
    box = page.locator("canvas").bounding_box()
    page.mouse.click(box["x"] + 110.5, box["y"] + 100.5)
    page.wait_for_selector(".luxel-ledger:not([hidden])")
    picked = page.evaluate("traits.picked")
    assert picked["pixel"] == [110, 100]
    assert picked["object"] == view.pick(110, 100).name
    assert picked["ledger"] == view.explain(110, 100).to_dict()
    assert page.locator(".luxel-ledger").text_content().strip() == str(view.explain(110, 100)).strip()


def test_a_saved_notebook_has_no_picture(scene):
    widget = scene.show(SIZE)
    bundle, _ = widget._repr_mimebundle_()
    assert bundle["image/png"] == scene.view(SIZE).render().to_png()


def test_other_bytes_than_a_scene_show_nothing_wrong(scene, browser, tmp_path):
    widget = luxel_notebook.Widget(scene.view(SIZE))
    widget._scene = b"not a scene"
    path = tmp_path / "page.html"
    path.write_text(page_of(widget), "utf-8")
    page = browser.new_page()
    page.goto(path.as_uri())
    page.wait_for_selector('[role="alert"]', timeout=20_000)
    page.close()
