"""The window that pyrender opens, which luxel has elsewhere."""

from typing import Any, NoReturn


class Viewer:
    """Opens nothing: it says how a scene is viewed instead."""

    def __new__(cls, *arguments: Any, **settings: Any) -> NoReturn:
        raise NotImplementedError(
            "luxel.pyrender opens no window: draw with OffscreenRenderer(width, height).render(scene); in a notebook, "
            "luxel.Scene.from_trimesh(mesh).show() turns a model; `luxel view MODEL` is a window for files"
        )
