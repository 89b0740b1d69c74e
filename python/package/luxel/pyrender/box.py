"""Things with a box along the axes."""

from abc import ABC, abstractmethod

import numpy as np
from numpy.typing import NDArray


class Boxed(ABC):
    """Something with `bounds`, and what follows from them."""

    @property
    @abstractmethod
    def bounds(self) -> NDArray[np.float64]:
        """(2, 3): the least and the greatest corner."""

    @property
    def centroid(self) -> NDArray[np.float64]:
        """(3,): the middle of the box."""
        low, high = self.bounds
        return np.asarray((low + high) / 2.0)

    @property
    def extents(self) -> NDArray[np.float64]:
        """(3,): the sides of the box."""
        low, high = self.bounds
        return np.asarray(high - low)

    @property
    def scale(self) -> float:
        """The diagonal of the box."""
        return float(np.linalg.norm(self.extents))
