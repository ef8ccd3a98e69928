#!/usr/bin/python3
"""Prints the main numbers of a run: show_summary.py OUTPUT_DIR."""

import sys

import continua


def show(summary):
    """The lines that tell what came out: title, size, quantities and verdicts."""
    lines = []
    if summary.get("title"):
        lines.append(summary["title"])
    width = 0
    rows = []
    for quantity in summary.get("quantities", []):
        name = quantity["name"]
        if quantity.get("probe"):
            name += f" ({quantity['probe']})"
        unit = quantity.get("unit", "")
        value = quantity["value"]
        # null stands for a number that is not finite.
        number = "not a number" if value is None else f"{value:.5g}"
        rows.append((name, number + ("" if unit in ("", "1") else " " + unit)))
        width = max(width, len(name))
    lines += [f"  {name:<{width}}  {number}" for name, number in rows]
    for check in summary.get("checks", []):
        name = check["name"] + (f" ({check['probe']})" if check.get("probe") else "")
        verdict = "passed" if check["passed"] else "FAILED" if check["passed"] is False else "not compared"
        lines.append(f"  check {verdict}: {name}, expected {check['criterion']}")
    return lines


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: show_summary.py OUTPUT_DIR")
    try:
        print("\n".join(show(continua.open(sys.argv[1]).summary)))
    except continua.ResultsError as error:
        sys.exit(f"error: {error}")


if __name__ == "__main__":
    main()
