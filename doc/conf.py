"""Sphinx configuration; scripts/build/manual calls it on a copy of this folder."""

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
exclude_patterns = ["Doxyfile", "*.dox", "*.in"]
language = "en"

# MathJax of Debian, which scripts/build/manual copies into _static: formulas need neither a network nor a package where the manual is
# read. Its SVG output needs no font, and browsers refuse fonts of other folders in pages that are read from the disk.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG"
mathjax2_config = {
    # The classes that MyST sets; it would write them for MathJax 3.
    "tex2jax": {"ignoreClass": "tex2jax_ignore|mathjax_ignore|document",
                "processClass": "tex2jax_process|mathjax_process|math|output_area"},
    "SVG": {"scale": 92, "useFontCache": True, "linebreaks": {"automatic": True}},
    "showMathMenu": False,
    "messageStyle": "none",
}
myst_update_mathjax = False

html_theme = "furo"
html_title = f"Continua {version}"
html_static_path = ["style"]
html_css_files = ["continua.css"]
html_theme_options = {"light_css_variables": {"font-stack--monospace": "'DejaVu Sans Mono', Menlo, Consolas, monospace"}}
html_sidebars = {"**": ["sidebar/brand.html", "sidebar/search.html", "sidebar/scroll-start.html", "sidebar/navigation.html",
                        "sidebar/scroll-end.html"]}
html_copy_source = False
html_show_sphinx = False
