"""A model in a notebook that turns under the hand and explains its pixels."""

from ._widget import Widget

__all__ = ["Widget"]
