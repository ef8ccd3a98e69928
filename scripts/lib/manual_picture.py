"""Pictures of the manual and of reports: fewer colours than those for a paper, so that they are small, and no steps where colours change slowly."""

import PIL.Image

COLOURS = 256


def fewer_colours(picture, number=COLOURS):
    """The picture with the colours that differ most; those between them are mixed of neighbouring pixels."""
    colours = picture.quantize(number, method=PIL.Image.Quantize.MAXCOVERAGE, kmeans=3)
    return picture.quantize(palette=colours, dither=PIL.Image.Dither.FLOYDSTEINBERG)


def save(path, to, most_pixels=None):
    """The picture of `path` as PNG; `most_pixels` of its longer side."""
    with PIL.Image.open(path) as picture:
        picture = picture.convert("RGB")
    if most_pixels:
        picture.thumbnail((most_pixels, most_pixels))
    fewer_colours(picture).save(to, optimize=True)
