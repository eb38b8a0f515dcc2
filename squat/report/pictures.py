"""Pictures as part of the page."""

import base64
import io
from pathlib import Path
from typing import NamedTuple

from PIL import Image

from squat.errors import InputError

_LARGEST = 250_000
"""Bytes of an SVG above which the PNG is taken: a mesh of thousands of lines draws slowly."""
_PER_INCH = 96
"""Pixels that a style sheet counts to the inch."""


class Picture(NamedTuple):
    """A picture as a data URI, its size as drawn [CSS pixels], and its vector file."""

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
    width, height = _size(raster)
    small = svg.stat().st_size <= _LARGEST
    content, kind = (svg.read_bytes(), "svg+xml") if small else (raster, "png")
    return Picture(
        source=f"data:image/{kind};base64,{base64.b64encode(content).decode()}",
        width=width,
        height=height,
        link=f"figures/{name}.svg",
    )


def _size(raster: bytes) -> tuple[int, int]:
    """Size that the figure was drawn for, from a PNG's pixels and their density."""
    with Image.open(io.BytesIO(raster)) as image:
        width, height = (
            round(_PER_INCH * pixels / density)
            for pixels, density in zip(image.size, image.info["dpi"], strict=True)
        )
    return width, height
