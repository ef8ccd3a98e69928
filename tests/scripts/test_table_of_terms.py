#!/usr/bin/python3
"""The table of doc/inside.md has every term of the lists of the equations, and the unit test of each goes through its list."""

import glob
import os
import re
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def text_of(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as stream:
        return stream.read()


class TableOfTerms(unittest.TestCase):
    def lists(self):
        """Name of each list -> its terms."""
        found = {}
        for path in glob.glob(os.path.join(ROOT, "include/continua/finite_element/terms/*.h")):
            for name, terms in re.findall(r"using (\w+) =\s*TermList<([^>]*)>;", text_of(path)):
                found[name] = re.findall(r"\w+", terms)
        return found

    def test_table(self):
        lists = self.lists()
        self.assertGreaterEqual(set(lists), {"FlowTerms", "SolidTerms", "BodyForceTerms", "FlowFaceTerms", "SolidFaceTerms"})
        rows = dict(re.findall(r"^\| `(\w+)` \| .* \| `(\w+\.cc)` \|$", text_of("doc", "inside.md"), re.MULTILINE))
        self.assertEqual(set(rows), {term for terms in lists.values() for term in terms})
        for terms in lists.values():
            for term in terms:
                test = text_of("tests", "finite_element", rows[term])
                self.assertTrue(any(term in terms_of and re.search(rf"\b{other}\b", test) for other, terms_of in lists.items()),
                                f"{rows[term]} names no list of {term}")


if __name__ == "__main__":
    unittest.main()
