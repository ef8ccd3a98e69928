#!/usr/bin/python3
"""Finds comments that begin with a word for something else ("That of the mesh", "Of whose gradient the stress is made"): a reader has to look for it
above. A comment names what it is about. Called by scripts/check/format.

    scripts/lib/comment_beginnings.py [FILE]...

FILE: by default every .h and .cc file of git. Prints a line for each such comment, and their number; exit status 1 if there are any.
"""

import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BEGINNING = re.compile(r"(that|those) (of|which|in|by|with|from|to|on|at)\b|of (which|whose|what|that|those)\b|in the place of\b", re.IGNORECASE)
ANYWHERE = re.compile(r"\bof whose\b", re.IGNORECASE)
COMMENT = re.compile(r"(?P<code>.*?)(?P<mark>///<|///|//|/\*\*|^\s*\*(?!/))\s*(?P<text>.*)")


def comments(lines):
    """(line number, text, whether the comment begins there) for each line with a comment."""
    in_comment = False
    for number, line in enumerate(lines, 1):
        match = COMMENT.match(line)
        if not match:
            in_comment = False
            continue
        is_alone = not match["code"].strip()
        # "///<" stands behind what it is about; a block begins with "/**".
        begins = match["mark"] == "///<" or match["mark"] == "/**" or not (in_comment and is_alone)
        if match["text"]:
            yield number, match["text"], begins
        in_comment = match["mark"] != "/**" or bool(match["text"])


def offences(path):
    with open(path, encoding="utf-8") as stream:
        return [(number, text) for number, text, begins in comments(stream)
                if (begins and BEGINNING.match(text)) or ANYWHERE.search(text)]


def main():
    files = sys.argv[1:]
    if not files:
        listed = subprocess.run(["git", "ls-files", "*.h", "*.cc"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\n")
        files = [os.path.join(ROOT, path) for path in listed if path and os.path.exists(os.path.join(ROOT, path))]
    n_offences = 0
    for path in files:
        for number, text in offences(path):
            n_offences += 1
            print(f"{os.path.relpath(path, ROOT)}:{number}: the comment does not name what it is about: {text}")
    print(f"{n_offences} comments begin with a word for something else")
    sys.exit(1 if n_offences else 0)


if __name__ == "__main__":
    main()
