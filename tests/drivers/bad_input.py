#!/usr/bin/python3
"""Checks what the program says to wrong input: bad_input.py PROGRAM CASE.prm WORKING_FOLDER.

Header comments of the case:

    # expect: status 2                  the exit status (2: the input is wrong, 1: the run failed)
    # expect: REGEX                     one or more; each must match what was printed (stdout and stderr together)
    # no line: REASON                   only with status 2: why no file and line can be to blame
    # refuse: REGEX                     none or more; must not match
    # arguments: --set "Mesh/Cells=0"   more arguments, quoted as in a shell; {folder} stands for the working folder
    # file: missing.prm                 run this file (beside the case) instead of the case; `none` for no file
    # existing: run/summary.json        make this file in the working folder first; it must still be there, unchanged
    # ranks: 2
    # left: probes.csv                  none or more; tables of a run that failed, which must have rows
    # failed: REGEX                     summary.json says that the run failed, for a reason that matches; where a run
                                        leaves tables, it has the largest values until then

The output folder is WORKING_FOLDER/run. With status 2 nothing may have been made there, and one of the patterns must
match the place of the error, `FILE:LINE: `, unless `no line` gives the reason why there is none. Where the program says
`FILE:LINE: 'SECTION/KEY'`, this line of the file must begin the section or set the key.

A pattern that the names of the files match already would show nothing: it is refused. So is one with alternatives
outside of brackets: `'Density'.*negative|positive` asks for 'positive' anywhere.
"""

import json
import os
import re
import shlex

import driver

CONTENT = "made by a test\n"
PLACE = re.compile(r"(?P<file>[^\s:]+\.(?:prm|csv|geo|msh)):(?P<line>\d+): (?:'(?P<key>[^:]*)': )?")


def has_open_alternatives(pattern):
    """Whether a `|` stands outside of all brackets."""
    depth, in_set, escaped = 0, False, False
    for character in pattern:
        if escaped:
            escaped = False
        elif character == "\\":
            escaped = True
        elif in_set:
            in_set = character != "]"
        elif character == "[":
            in_set = True
        elif character in "()":
            depth += 1 if character == "(" else -1
        elif character == "|" and depth == 0:
            return True
    return False


def check_patterns(patterns, names):
    """Each pattern must be able to fail."""
    for pattern in patterns:
        if has_open_alternatives(pattern):
            raise driver.TestFailure(f"'{pattern}' has alternatives outside of brackets: write (...|...)")
        for name in names:
            if re.search(pattern, name, re.MULTILINE):
                raise driver.TestFailure(f"'{pattern}' shows nothing: the name '{name}' matches it already")


def check_place(text, patterns, no_line):
    """The message names the line that is to blame, and the case asks for it."""
    if no_line is not None:
        found = PLACE.search(text)
        if found:
            raise driver.TestFailure(f"the header says 'no line', but the program printed '{found.group(0)}'")
        return
    matches = [re.search(pattern, text, re.MULTILINE).group(0) for pattern in patterns]
    if not any(re.search(r"\.(prm|csv|geo|msh):\d+: ", match) for match in matches):
        raise driver.TestFailure("no '# expect:' asks for the file and the line (NAME\\.prm:LINE: ); where there is "
                                 "none, '# no line: REASON' says why")
    for found in PLACE.finditer(text):
        key = (found["key"] or "").split("/")[-1].strip('"')
        if not found["file"].endswith(".prm") or not key:
            continue
        with open(found["file"], encoding="utf-8") as stream:
            line = stream.read().splitlines()[int(found["line"]) - 1]
        # An entry that is missing is to blame where its section begins.
        section = (found["key"] or "").split("/")[-2:-1]
        if not (re.match(r"\s*(set|subsection|include)\b", line) and key.lower() in line.lower()
                or section and re.fullmatch(rf"\s*subsection\s+{re.escape(section[0])}\s*(#.*)?", line)):
            raise driver.TestFailure(f"'{found.group(0)}' points to the line '{line.strip()}', which has no '{key}'")


def case(program, parameter_file, folder):
    entries = driver.header(parameter_file)
    status, patterns = None, []
    for text in entries.get("expect", []):
        match = re.fullmatch(r"status (\d+)", text)
        if match:
            status = int(match.group(1))
        else:
            patterns.append(text)
    if status is None or not patterns:
        raise driver.TestFailure("the header needs '# expect: status N' and at least one '# expect: REGEX'")

    existing = [os.path.join(folder, name) for name in entries.get("existing", [])]
    for path in existing:
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(CONTENT)

    file = driver.single(entries, "file", os.path.basename(parameter_file))
    arguments = [] if file == "none" else [os.path.join(os.path.dirname(parameter_file), file)]
    extra = driver.single(entries, "arguments", "").replace("{folder}", folder)
    arguments += shlex.split(extra)
    output = os.path.join(folder, "run")
    if "--output" not in arguments and file != "none":
        arguments += ["--output", output]

    no_line = driver.single(entries, "no line")
    if no_line is not None and (status != 2 or len(no_line) < 10):
        raise driver.TestFailure("'# no line: REASON' needs status 2 and a reason")
    check_patterns(patterns, [parameter_file, *arguments, output])

    done = driver.run(program, arguments, int(driver.single(entries, "ranks", "1")), folder, time_limit=180)
    text = done.stdout + done.stderr
    print(text)
    if done.returncode != status:
        raise driver.TestFailure(f"exit status {done.returncode}, expected {status}")
    for pattern in patterns:
        if not re.search(pattern, text, re.MULTILINE):
            raise driver.TestFailure(f"nothing printed matches '{pattern}'")
    for pattern in entries.get("refuse", []):
        if re.search(pattern, text, re.MULTILINE):
            raise driver.TestFailure(f"something printed matches '{pattern}'")

    if status == 2:
        check_place(text, patterns, no_line)

    for path in existing:
        with open(path, encoding="utf-8") as stream:
            if stream.read() != CONTENT:
                raise driver.TestFailure(f"{path} was changed")
    for name in entries.get("left", []):
        driver.read_table(os.path.join(output, name))
    for pattern in entries.get("failed", []):
        with open(os.path.join(output, "summary.json"), encoding="utf-8") as stream:
            summary = json.load(stream)
        if summary["status"] != "failed" or not re.search(pattern, summary["failure"]):
            raise driver.TestFailure(f"summary.json says '{summary['status']}', '{summary.get('failure', '')}'")
        # Networks have probes, too, but no such values.
        is_run = os.path.exists(os.path.join(output, "probes.csv")) and os.path.exists(os.path.join(output, "power.csv"))
        if entries.get("left") and is_run and not summary.get("largest values"):
            raise driver.TestFailure("summary.json does not say how far the run went ('largest values')")
    if status == 2:
        made = [os.path.join(at, name) for at, folders, files in os.walk(folder) for name in folders + files]
        kept = set(existing) | {os.path.dirname(path) for path in existing}
        left_over = sorted(set(made) - kept)
        if left_over:
            raise driver.TestFailure(f"made although the input is wrong: {', '.join(left_over)}")


if __name__ == "__main__":
    driver.main(case)
