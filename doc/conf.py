"""Settings of Sphinx for the manual of USER-SPHSOLID: tools/docs runs it."""

import os
import re

from pygments.lexer import RegexLexer
from pygments.token import Comment, Keyword, Name, Number, String, Text

here = os.path.dirname(os.path.abspath(__file__))
with open(os.path.join(here, "..", "CMakeLists.txt"), encoding="utf-8") as file:
    release = re.search(r"VERSION\s+([0-9.]+)\s+DESCRIPTION", file.read()).group(1)

project = "USER-SPHSOLID"
author = "the USER-SPHSOLID developers"
copyright = author
version = release

extensions = ["sphinx.ext.mathjax"]
nitpicky = True
primary_domain = None
highlight_language = "LAMMPS"
pygments_style = "default"
numfig = False

html_theme = "alabaster"
html_title = "USER-SPHSOLID " + release
html_show_copyright = False
html_theme_options = {"description": "Impact on elastic-plastic solids with LAMMPS", "page_width": "1080px"}
html_sidebars = {"**": ["about.html", "navigation.html", "searchbox.html"]}

# Formulas are drawn in the browser by MathJax, from the net. To read the manual without the net, set
# SPHSOLID_MATHJAX to the address of a MathJax 3 of your own.
mathjax_path = os.environ.get("SPHSOLID_MATHJAX", "https://cdn.jsdelivr.net/npm/mathjax@3/es5/tex-mml-chtml.js")


class LammpsInput(RegexLexer):
    """Input scripts: the command is the first word of a line."""

    name = "LAMMPS"
    aliases = ["LAMMPS"]
    tokens = {
        "root": [
            (r"\s+", Text),
            (r"#.*?$", Comment),
            (r"[^\s#]+", Keyword, "arguments"),
        ],
        "arguments": [
            (r"&[ \t]*\n", Text),
            (r"\n", Text, "#pop"),
            (r"[ \t]+", Text),
            (r"#.*?$", Comment),
            (r'"[^"\n]*"', String),
            (r"\$\{[^}\n]*\}|\$\([^)\n]*\)|\$\w", Name.Variable),
            (r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?(?=\s|$)", Number),
            (r"[^\s#$]+|\$", Text),
        ],
    }


def setup(app):
    app.add_lexer("LAMMPS", LammpsInput)
