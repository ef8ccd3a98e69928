"""The pages of the manual as any viewer of CommonMark shows them: each link has a text, and each link to a file leads to one."""

import glob
import os
import re
import unittest

try:
    import markdown_it
except ImportError:
    markdown_it = None

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# Made by the program when the manual is built.
GENERATED = os.path.join(ROOT, "doc", "parameters")
GENERATED_PAGES = ("thesis-slips", "what-goes-with-what")


def pages():
    return sorted(glob.glob(os.path.join(ROOT, "doc", "**", "*.md"), recursive=True)) + [os.path.join(ROOT, name) for name in ("README.md", "CONTRIBUTING.md")]


def links(path):
    """(target, text) of each link of a page."""
    with open(path, encoding="utf-8") as file:
        tokens = markdown_it.MarkdownIt("commonmark").enable("table").parse(file.read())
    found = []
    for token in tokens:
        target, text = None, ""
        for child in token.children or []:
            if child.type == "link_open":
                target, text = child.attrs["href"], ""
            elif child.type == "link_close":
                found.append((target, text.strip()))
                target = None
            elif target is not None:
                text += child.content
    return found


def anchors(path):
    """The headings of a page, as links name them: small letters, blanks as hyphens, no other signs."""
    with open(path, encoding="utf-8") as file:
        tokens = markdown_it.MarkdownIt("commonmark").parse(file.read())
    found = set()
    for token, inline in zip(tokens, tokens[1:]):
        if token.type == "heading_open":
            text = "".join(child.content for child in inline.children if child.type in ("text", "code_inline"))
            name = re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")
            found.add(name if name not in found else next(f"{name}-{i}" for i in range(1, 100) if f"{name}-{i}" not in found))
    return found


@unittest.skipIf(markdown_it is None, "python3-markdown-it is not there")
class Links(unittest.TestCase):
    def test_texts(self):
        for path in pages():
            for target, text in links(path):
                with self.subTest(page=os.path.relpath(path, ROOT), target=target):
                    self.assertTrue(text, "the link has no text: outside the built manual it is blank")

    def test_targets(self):
        for path in pages():
            for target, _ in links(path):
                name = target.partition("#")[0]
                file = os.path.normpath(os.path.join(os.path.dirname(path), name))
                if not name.endswith(".md") or "://" in name or file.startswith(GENERATED) or name[:-3].rpartition("/")[2] in GENERATED_PAGES:
                    continue
                with self.subTest(page=os.path.relpath(path, ROOT), target=target):
                    self.assertTrue(os.path.exists(file), "there is no such page")

    def test_places(self):
        """No viewer but Sphinx knows labels: a place of a page is its heading."""
        headings, n_checked = {}, 0
        for path in pages():
            for target, _ in links(path):
                name, sign, place = target.partition("#")
                if "://" in target or target.startswith("mailto:"):
                    continue
                file = os.path.normpath(os.path.join(os.path.dirname(path), name)) if name else path
                with self.subTest(page=os.path.relpath(path, ROOT), target=target):
                    self.assertTrue(sign or "." in name or name in GENERATED_PAGES or os.path.exists(file), "this is a label, not a page or a heading of one")
                    if place and file.endswith(".md") and os.path.exists(file) and not file.startswith(GENERATED):
                        n_checked += 1
                        if file not in headings:
                            headings[file] = anchors(file)
                        self.assertIn(place, headings[file], "the page has no such heading")
        self.assertGreater(n_checked, 50)


if __name__ == "__main__":
    unittest.main()
