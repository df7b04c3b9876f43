"""Polygons in the plane of a sole: their convex hull, its area, and the rectangle inside."""

from __future__ import annotations

import numpy as np

__all__ = ["area_of", "convex_hull", "inscribed_rectangle"]

LONG_ENOUGH = 0.75  # of the largest inscribed area: the sole is the longest rectangle that has it


def convex_hull(points: np.ndarray) -> np.ndarray:
    """Convex hull (n, 2) of points in the plane, counter-clockwise."""
    ordered = sorted(set(map(tuple, np.round(points, 9))))
    if len(ordered) < 3:
        return np.array(ordered, float).reshape(-1, 2)

    def half(line: list) -> list:
        chain: list = []
        for p in line:
            while len(chain) > 1 and np.linalg.det([np.subtract(chain[-1], chain[-2]), np.subtract(p, chain[-1])]) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]

    return np.array(half(ordered) + half(ordered[::-1]), float)


def area_of(hull: np.ndarray) -> float:
    """Area of a convex hull [m^2]; 0 for a line or a point."""
    if len(hull) < 3:
        return 0.0
    x, y = hull.T
    return 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def inscribed_rectangle(points: np.ndarray) -> tuple[float, float, float, float]:
    """The sole's rectangle inside the convex hull of its points.

    Of all rectangles with sides along x and y, the longest along x that has at least `LONG_ENOUGH` of the largest area:
    length is what walking ahead needs.

    Args:
        points: (n, 2) [m], x forward, y left.

    Returns:
        x from, x to, y from, y to [m]; all of no extent where the points span no area.

    Usage: `inscribed_rectangle(corners)`
    """
    hull = convex_hull(points)
    if area_of(hull) < 1e-9:
        x, y = points.mean(axis=0) if len(points) else (0.0, 0.0)
        return x, x, y, y
    x = np.unique(np.concatenate([hull[:, 0], np.linspace(hull[:, 0].min(), hull[:, 0].max(), 121)]))
    lower, upper = np.full(len(x), np.inf), np.full(len(x), -np.inf)
    for a, b in zip(hull, np.roll(hull, -1, axis=0)):
        inside = (x >= min(a[0], b[0]) - 1e-12) & (x <= max(a[0], b[0]) + 1e-12)
        ends = (a[1], b[1]) if abs(b[0] - a[0]) < 1e-12 else ()
        for y in ends or (a[1] + (b[1] - a[1]) * (x[inside] - a[0]) / (b[0] - a[0]),):
            lower[inside], upper[inside] = np.minimum(lower[inside], y), np.maximum(upper[inside], y)
    widths = np.minimum(upper[:, None], upper) - np.maximum(lower[:, None], lower)
    lengths = x[None, :] - x[:, None]
    areas = np.where((lengths > 0) & (widths > 0), lengths * widths, 0.0)
    enough = areas >= LONG_ENOUGH * areas.max()
    i, j = np.unravel_index(np.argmax(np.where(enough, lengths + 1e-6 * widths, -1.0)), areas.shape)
    return x[i], x[j], max(lower[i], lower[j]), min(upper[i], upper[j])
