"""The door to the widget, which is a package of its own."""

from typing import Any


def widget(view: Any) -> Any:
    """The view as a widget.

    Raises `ImportError` without luxel-notebook.
    """
    try:
        from luxel_notebook import Widget
    except ImportError as error:
        raise ImportError(f'widgets need luxel-notebook: pip install "luxel[notebook]" ({error})') from error
    return Widget(view)
