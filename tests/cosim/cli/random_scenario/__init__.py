"""Random scenarios that are valid: short, with every key, and values up to the edges of their ranges."""

from .robots import READY, Robot
from .scenario import draw

__all__ = ["READY", "Robot", "draw"]
