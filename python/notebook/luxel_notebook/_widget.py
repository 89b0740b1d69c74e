"""The widget: scene, view and program go to the page as bytes; the page draws."""

import functools
import gzip
import pathlib
from typing import Any

import anywidget
import numpy as np
import traitlets
from luxel import View
from numpy.typing import NDArray

_STATIC = pathlib.Path(__file__).parent / "static"


@functools.cache
def _module() -> bytes:
    """luxel in WebAssembly, compressed."""
    return gzip.compress((_STATIC / "luxel_bg.wasm").read_bytes(), 9, mtime=0)


@functools.cache
def _worker() -> str:
    """The program of the page's worker: the module's own JavaScript, and what uses it."""
    return "\n".join((_STATIC / name).read_text("utf-8") for name in ("luxel.js", "worker.js"))


class Widget(anywidget.AnyWidget):
    """A view that turns under the hand: drag to turn, shift and drag to pan, wheel to zoom, click to explain a
    pixel; arrows, `+`, `-` and Home by keyboard."""

    _esm = _STATIC / "widget.js"
    _css = _STATIC / "widget.css"
    _module = traitlets.Bytes().tag(sync=True)
    _worker = traitlets.Unicode().tag(sync=True)
    _scene = traitlets.Bytes().tag(sync=True)
    _view = traitlets.Bytes().tag(sync=True)
    _picture = traitlets.Bytes().tag(sync=True)
    _size = traitlets.List(traitlets.Int()).tag(sync=True)
    camera = traitlets.List(traitlets.Float(), help="From world to camera coordinates, column by column.").tag(
        sync=True
    )
    picked = traitlets.Dict(
        None, allow_none=True, help="The pixel clicked last: `pixel`, `object` (a name) and `ledger`."
    ).tag(sync=True)

    def __init__(self, view: View, **settings: Any) -> None:
        scene, packed = view._packed()
        super().__init__(
            _module=_module(),
            _worker=_worker(),
            _scene=gzip.compress(scene, 6, mtime=0),
            _view=gzip.compress(packed, 6, mtime=0),
            _picture=view._repr_png_(),
            _size=list(view.size),
            picked=None,
            **settings,
        )

    @property
    def pose(self) -> NDArray[np.float64] | None:
        """The camera's pose as the hand left it, 4x4, from camera to world coordinates (OpenGL's axes): a camera for
        `scene.render`. None before the page has drawn."""
        if len(self.camera) != 16:
            return None
        return np.linalg.inv(np.array(self.camera, dtype=np.float64).reshape(4, 4).T)

    def _repr_mimebundle_(self, **arguments: Any) -> Any:
        """With the picture beside, which is shown where no widgets are."""
        bundle = super()._repr_mimebundle_(**arguments)
        if bundle is None:
            return None
        data, metadata = bundle if isinstance(bundle, tuple) else (bundle, {})
        return {**data, "image/png": self._picture}, metadata
