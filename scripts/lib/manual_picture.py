"""A picture of the manual: fewer colours than one for a paper, so that the checkout stays small, and no steps where colours change slowly."""

import PIL.Image

COLOURS = 256


def save(path, to, most_pixels=None):
    """The picture of `path` as PNG; `most_pixels` of its longer side."""
    with PIL.Image.open(path) as picture:
        picture = picture.convert("RGB")
    if most_pixels:
        picture.thumbnail((most_pixels, most_pixels))
    # The colours that differ most; those between them are mixed of neighbouring pixels.
    colours = picture.quantize(COLOURS, method=PIL.Image.Quantize.MAXCOVERAGE, kmeans=3)
    picture.quantize(palette=colours, dither=PIL.Image.Dither.FLOYDSTEINBERG).save(to, optimize=True)
