"""The lists of scripts/measure/mutants, and the tree in which all mutants of a list are compiled."""

import dataclasses
import glob
import json
import os
import random
import re
import shlex
import shutil
import subprocess
import tempfile

import mutant_sites

HEADER = "include/continua/base/mutants.h"
INCLUDE = "#include <continua/base/mutants.h>\n#line 1\n"


class MutantsError(Exception):
    """What the user can put right."""


def read_json(path):
    try:
        with open(path, encoding="utf-8") as stream:
            return json.load(stream)
    except FileNotFoundError:
        raise MutantsError(f"{path}: there is no such file") from None
    except (ValueError, UnicodeDecodeError) as error:
        raise MutantsError(f"{path}: this is no JSON file ({error})") from None


def write_json(path, value):
    """As a whole or not at all."""
    with open(path + ".new", "w", encoding="utf-8") as stream:
        json.dump(value, stream, indent=1)
        stream.write("\n")
    os.replace(path + ".new", path)


def read_list(path):
    contents = read_json(path)
    if not isinstance(contents, dict) or not {"seed", "count", "mutants", "refused"} <= set(contents):
        raise MutantsError(f"{path}: this is no list of mutants; 'mutants draw' writes one")
    return contents


def sequence_of_sites(root, seed):
    """All sites of the sources, in the order in which the seed draws them. A site's identifier is its place, from 1."""
    choose = random.Random(seed)
    sites = []
    paths = sorted(glob.glob(os.path.join(root, "source", "**", "*.cc"), recursive=True))
    for path in paths:
        file = os.path.relpath(path, root)
        if file == os.path.join("source", "main.cc"):
            continue
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        try:
            sites += mutant_sites.sites_of(file, text, choose.choice)
        except ValueError as error:
            raise MutantsError(f"{file}: {error}") from None
    if not sites:
        raise MutantsError(f"{root}: there is no place to change in source/**/*.cc")
    choose.shuffle(sites)
    return sites


def described(number, site):
    return {"id": number, "file": site.file, "line": site.line, "kind": site.kind, "before": site.before, "after": site.after}


def pick(sites, count, refused):
    """{identifier: site}: the first `count` of the sequence but those refused. Enters into `refused` what overlaps another one."""
    picked = {}
    for number, site in enumerate(sites, 1):
        if len(picked) == count:
            break
        if number in refused:
            continue
        other = next((n for n, s in picked.items() if s.file == site.file and s.start < site.end and site.start < s.end), None)
        if other is not None:
            refused[number] = f"overlaps mutant {other}"
        else:
            picked[number] = site
    if len(picked) < count:
        raise MutantsError(f"there are only {len(picked)} mutants that can be compiled, fewer than --count {count}")
    return picked


def draw(root, seed, count):
    sites = sequence_of_sites(root, seed)
    refused = {}
    picked = pick(sites, count, refused)
    return {"seed": seed, "count": count, "n_sites": len(sites), "mutants": [described(n, s) for n, s in picked.items()],
            "refused": entries(sites, refused)}


def entries(sites, refused):
    return [{**described(number, sites[number - 1]), "reason": refused[number]} for number in sorted(refused)]


def rewritten(text, mutants):
    """The text of a file with all its mutants, {identifier: site}."""
    for number, site in sorted(mutants.items(), key=lambda item: -item[1].start):
        text = text[:site.start] + site.replacement(text, number) + text[site.end:]
    return INCLUDE + text


@dataclasses.dataclass
class Compilation:
    """How a file is compiled: `group` is the file that the compiler is given, which may include several."""

    group: str
    folder: str
    command: list


def compilations(build, root):
    """{file relative to root: Compilation}, of compile_commands.json. Also the checkout that `build` was configured for."""
    cache = os.path.join(build, "CMakeCache.txt")
    home = root
    if os.path.exists(cache):
        with open(cache, encoding="utf-8") as stream:
            home = re.search(r"^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)$", stream.read(), re.MULTILINE)[1]
    found = {}
    for entry in read_json(os.path.join(build, "compile_commands.json")):
        group = os.path.join(entry["directory"], entry["file"])
        files = [group]
        if not group.startswith(os.path.join(home, "source", "")):
            if not os.path.exists(group):
                continue
            with open(group, encoding="utf-8", errors="replace") as stream:
                files = re.findall(r'^#include "(.*)"', stream.read(), re.MULTILINE)
        for file in files:
            if file.startswith(os.path.join(home, "source", "")):
                found.setdefault(os.path.relpath(file, home), Compilation(group, entry["directory"], shlex.split(entry["command"])))
    return found, home


def syntax_errors(tree, home, compilation, files, launcher):
    """What the compiler says about these files of the tree, or "" if they compile."""
    with tempfile.TemporaryDirectory() as folder:
        together = os.path.join(folder, "together.cc")
        with open(together, "w", encoding="utf-8") as stream:
            stream.write("".join(f'#include "{os.path.join(tree, file)}"\n' for file in files))
        options = []
        skips = False
        for option in compilation.command:
            if skips or option in ("-o", "-c", "-MF", "-MT", "-MQ", "-MD", "-MMD"):
                skips = not skips and option in ("-o", "-c", "-MF", "-MT", "-MQ")
                continue
            for part in ("include", "source"):
                option = option.replace(os.path.join(home, part), os.path.join(tree, part))
            options.append(option)
        command = [*launcher, *options, "-w", "-fsyntax-only", f"-I{os.path.join(tree, 'include')}", "-x", "c++", together]
        done = subprocess.run(command, cwd=compilation.folder, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              errors="replace", env={**os.environ, "LC_ALL": "C.UTF-8"}, check=False)
    return "" if done.returncode == 0 else done.stderr or f"exit status {done.returncode}"


def blamed(errors, mutants, texts):
    """{identifier: reason} of the mutants at whose lines the compiler finds errors; if there is none, of all."""
    reasons = {}
    for pattern in (r":(\d+):\d+: (?:fatal )?error: (.*)", r":(\d+):\d+:   (required from.*)"):
        for number, site in mutants.items():
            text = texts[site.file]
            first, last = (text.count("\n", 0, place) + 1 for place in (site.start, site.end))
            for line, message in re.findall(re.escape(site.file) + pattern, errors):
                if first <= int(line) <= last:
                    reasons.setdefault(number, f"does not compile: {message}")
        if reasons:
            return reasons
    message = re.search(r"error: (.*)", errors)
    return {number: f"does not compile: {message[1] if message else errors.strip()[:200]}" for number in mutants}


def write_tree(root, tree):
    """A copy of the checkout without its builds."""
    if os.path.commonpath([root, tree]) == root:
        raise MutantsError(f"{tree} lies in the checkout; give --tree a place outside")
    if os.path.exists(tree):
        raise MutantsError(f"{tree} exists; remove it, or give --tree another place")
    shutil.copytree(root, tree, symlinks=True,
                    ignore=lambda folder, names: [name for name in names if name == "__pycache__" or name == "build" and folder == root])


def apply(root, contents, tree, build, launcher, save, say):
    """Makes the tree, and saves the list with the mutants that it has. Saves after each call of the compiler what came out."""
    sites = sequence_of_sites(root, contents["seed"])
    for entry in [*contents["mutants"], *contents["refused"]]:
        number = entry["id"]
        if number > len(sites) or described(number, sites[number - 1]).items() - entry.items():
            raise MutantsError(f"mutant {number} of the list is not in these sources: draw the list anew")
    how, home = compilations(build, root)
    write_tree(root, tree)
    os.makedirs(os.path.dirname(os.path.join(tree, HEADER)), exist_ok=True)
    shutil.copyfile(os.path.join(os.path.dirname(os.path.abspath(__file__)), "mutants.h"), os.path.join(tree, HEADER))
    refused = {entry["id"]: entry["reason"] for entry in contents["refused"]}
    compiled = set(contents.get("compiled", []))
    texts = {}
    while True:
        picked = pick(sites, contents["count"], refused)
        by_file = {}
        for number, site in picked.items():
            by_file.setdefault(site.file, {})[number] = site
        by_group = {}
        for file, mutants in by_file.items():
            if file not in texts:
                with open(os.path.join(root, file), encoding="utf-8") as stream:
                    texts[file] = stream.read()
            if file in how:
                by_group.setdefault(how[file].group, {})[file] = mutants
            else:
                refused.update(dict.fromkeys(mutants, f"{os.path.join(build, 'compile_commands.json')} does not name the file"))
        # A file whose mutants were all refused.
        for file in texts:
            with open(os.path.join(tree, file), "w", encoding="utf-8") as stream:
                stream.write(rewritten(texts[file], by_file[file]) if file in by_file else texts[file])
        for _, files in sorted(by_group.items()):
            mutants = {number: site for part in files.values() for number, site in part.items()}
            if set(mutants) <= compiled:
                continue
            errors = syntax_errors(tree, home, how[next(iter(files))], files, launcher)
            bad = blamed(errors, mutants, texts) if errors else {}
            refused.update(bad)
            say(f"{len(mutants)} mutants in {', '.join(sorted(files))}" +
                "".join(f"\n  refused {number}: {reason}" for number, reason in bad.items()))
            if not errors:
                compiled.update(mutants)
            save({**contents, "compiled": sorted(compiled), "refused": entries(sites, refused)})
        if not set(picked) & set(refused):
            break
    if max(picked) >= 10000:
        raise MutantsError("identifiers above 9999 need a larger n_ids in scripts/lib/mutants.h")
    contents = {**contents, "mutants": [described(n, s) for n, s in picked.items()], "compiled": sorted(compiled),
                "refused": entries(sites, refused), "tree": tree}
    save(contents)
    return contents
