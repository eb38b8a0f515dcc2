"""Pictures as part of the page."""

import base64
from pathlib import Path
from typing import NamedTuple

from squat.errors import InputError

_LARGEST = 250_000
"""Bytes of an SVG above which the PNG is taken: a mesh of thousands of lines draws slowly."""
_PIXELS = slice(16, 24)  # width and height in a PNG's header, big-endian


class Picture(NamedTuple):
    """A picture as a data URI, its size [pixels], and its vector file beside the report."""

    source: str
    width: int
    height: int
    link: str


def picture(results: Path, name: str) -> Picture:
    """The figure `name` of a folder of results.

    Raises
    ------
    InputError
        It is not there.
    """
    svg, png = (results / "figures" / f"{name}{suffix}" for suffix in (".svg", ".png"))
    for path in (svg, png):
        if not path.is_file():
            raise InputError(f"{path}: no such figure; run snakemake all first")
    raster = png.read_bytes()
    size = raster[_PIXELS]
    small = svg.stat().st_size <= _LARGEST
    content, kind = (svg.read_bytes(), "svg+xml") if small else (raster, "png")
    return Picture(
        source=f"data:image/{kind};base64,{base64.b64encode(content).decode()}",
        width=int.from_bytes(size[:4], "big"),
        height=int.from_bytes(size[4:], "big"),
        link=f"figures/{name}.svg",
    )
