"""Sphinx configuration; scripts/build-manual calls it on a copy of this folder."""

import os

project = "Continua"
author = "The Continua authors"
copyright = "The Continua authors, LGPL-2.1-or-later"
with open(os.path.join(os.environ.get("CONTINUA_ROOT", ".."), "VERSION"), encoding="utf-8") as stream:
    version = release = stream.read().strip()

extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath", "amsmath", "deflist"]
myst_heading_anchors = 3
source_suffix = {".md": "markdown"}
exclude_patterns = ["Doxyfile"]
language = "en"

html_theme = "alabaster"
html_theme_options = {"description": "Single-solution fluid-structure interaction", "page_width": "1080px",
                      "fixed_sidebar": True}
html_sidebars = {"**": ["about.html", "navigation.html", "searchbox.html"]}
html_show_sphinx = False
