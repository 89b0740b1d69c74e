"""Warnings that are given once."""

import warnings

_given: set[str] = set()


def warn(message: str) -> None:
    """Warns, unless it did so before."""
    if message not in _given:
        _given.add(message)
        warnings.warn(message, stacklevel=4)
