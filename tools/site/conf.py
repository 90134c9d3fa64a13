"""Sphinx's settings for the site: all pages of the documents, the files that the pages link, and the public interfaces.

build.py runs Sphinx with them.
"""

import os
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE))

project = "PlacedPar"
author = "the PlacedPar maintainers"
release = re.search(r"project\(PlacedPar VERSION (\S+)", (HERE.parent.parent / "CMakeLists.txt").read_text())[1]
root_doc = "README"
include_patterns = ["*.md", "docs/**.md", "examples/**.md", "interfaces/**.md", "*/README.md", "*/*/README.md"]
exclude_patterns = ["docs/occam-course/answers", "tools/skeleton"]

extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc", "contents", "languages", "linked_files", "run_pages"]
myst_heading_anchors = 4  # GitHub's anchors of headings, so that links to headings work on both sites
myst_enable_extensions = ["colon_fence"]
breathe_projects = {"placedpar": os.environ["PLACEDPAR_API_XML"]}  # set by build.py
breathe_default_project = "placedpar"
breathe_show_include = False

html_theme = "furo"
html_title = f"PlacedPar {release}"
html_copy_source = False
html_show_copyright = False
html_show_sphinx = False
html_static_path = ["static"]
html_css_files = ["site.css"]
highlight_language = "text"
