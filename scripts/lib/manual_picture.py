"""Pictures of the manual and of reports: fewer colours than those for a paper, so that they are small, and no steps where colours change slowly."""

import os

import numpy
import PIL.Image

COLOURS = 256
MOST_BYTES = 150e3  # of a picture of the manual; if it has more, its colours are not mixed


def fewer_colours(picture, number=COLOURS, mixed=True):
    """The picture with the colours that differ most; those between them are mixed of neighbouring pixels."""
    colours = picture.quantize(number, method=PIL.Image.Quantize.MAXCOVERAGE, kmeans=3)
    found = numpy.array(picture.quantize(palette=colours, dither=PIL.Image.Dither.FLOYDSTEINBERG if mixed else PIL.Image.Dither.NONE))
    # The background is white, not the mean of what is nearly white.
    palette = numpy.array(colours.getpalette()).reshape(-1, 3)
    is_white = (numpy.array(picture) == 255).all(axis=2)
    if is_white.any():
        brightest = numpy.argmax(palette.sum(axis=1))
        palette[brightest] = 255
        found[is_white] = brightest
    result = PIL.Image.fromarray(found, "P")
    result.putpalette(palette.ravel().tolist())
    return result


def save(path, to, most_pixels=None):
    """The picture of `path` as PNG; `most_pixels` of its longer side."""
    with PIL.Image.open(path) as picture:
        picture = picture.convert("RGB")
    if most_pixels:
        picture.thumbnail((most_pixels, most_pixels))
    for mixed in (True, False):
        fewer_colours(picture, mixed=mixed).save(to, optimize=True)
        if os.path.getsize(to) <= MOST_BYTES:
            return
