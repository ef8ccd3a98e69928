"""The pages of the manual as any viewer of CommonMark shows them: each link has a text, and each link to a file leads to one."""

import glob
import os
import unittest

try:
    import markdown_it
except ImportError:
    markdown_it = None

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# Made by the program when the manual is built.
GENERATED = os.path.join(ROOT, "doc", "parameters")


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
                if not name.endswith(".md") or "://" in name or file.startswith(GENERATED):
                    continue
                with self.subTest(page=os.path.relpath(path, ROOT), target=target):
                    self.assertTrue(os.path.exists(file), "there is no such page")


if __name__ == "__main__":
    unittest.main()
