"""The door to the widget, which is a package of its own."""

import importlib
from typing import Any


def widget(view: Any) -> Any:
    """The view as a widget.

    Raises `ImportError` without luxel-notebook.
    """
    try:
        notebook: Any = importlib.import_module("luxel_notebook")
    except ImportError as error:
        raise ImportError(f'widgets need luxel-notebook: pip install "luxel[notebook]" ({error})') from error
    return notebook.Widget(view)
