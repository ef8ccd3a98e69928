#!/usr/bin/python3
"""Prints the slips of the thesis as a page of the manual, from parameter_files/thesis/thesis.toml."""

import os
import sys
import tomllib

FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "parameter_files", "thesis", "thesis.toml")


def plain(text):
    """Without what Markdown would take for something else."""
    for letter in "\\|*_<>$[]":
        text = text.replace(letter, "\\" + letter)
    return text


def main():
    with open(FILE, "rb") as stream:
        data = tomllib.load(stream)
    entries = [entry for kind in ("figure", "number", "finding") for entry in data[kind] if "slip" in entry]
    entries.sort(key=lambda entry: (entry["chapter"] == "A", entry["chapter"]))
    print("# Slips of the thesis\n\nWhat the thesis prints in two ways, or otherwise than it follows from its own equations.\n")
    print("| chapter | place | what | slip |\n|---|---|---|---|")
    for entry in entries:
        print(f"| {entry['chapter']} | {plain(entry.get('place', entry['id']))} | {plain(entry.get('text', entry.get('caption', '')))} | "
              f"{plain(entry['slip'])} |")


if __name__ == "__main__":
    sys.exit(main())
