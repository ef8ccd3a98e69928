#!/usr/bin/python3
"""scripts/build/release in a repository of its own: refusals, the source archive, the steps and what stops them, the changelog.

Clean roots are folders there, and scripts/quickstart and the scripts of scripts/build that compile are short ones that leave the
same files: the packages are real ones, the program is a script that prints its version."""

import hashlib
import os
import shutil
import subprocess
import tarfile
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

FILES = {
    "VERSION": "1.2.3\n",
    "CITATION.cff": "cff-version: 1.2.0\nversion: 1.2.3\n",
    "REVISION": "$Format:%H$\n",
    ".gitignore": "/build*/\n",
    "changelog/1.2.3.md": "# Continua 1.2.3\n",
    # Unpacks the archive once, and runs the commands there. Writes to the file $CALLS what is run.
    "scripts/build/clean-root": """#!/bin/bash
archive=''
while [[ $1 == --* ]]; do declare "${1#--}=$2"; shift 2; done
export DEBIAN=$1
shift
echo "$DEBIAN: $*" >>"$CALLS"
if [ -n "$archive" ] && [ ! -d "$folder/continua" ]; then
  mkdir -p "$folder/continua"
  tar -xf "$archive" -C "$folder/continua" --strip-components 1
fi
if [ -n "$archive" ]; then cd "$folder/continua"; fi
status=0
export PATH=$folder/usr/bin:$PATH
for command; do (eval "$command") || status=$?; done
exit $status
""",
    "scripts/quickstart": """#!/bin/bash
mkdir -p build/release
echo "echo 'Continua $(cat VERSION) (${WRONG_REVISION:-$(cat REVISION)})'" >build/release/continua
chmod +x build/release/continua
""",
    "scripts/test": "#!/bin/bash\necho tested\n",
    "scripts/build/report-assets": """#!/bin/bash
[ -z "${NO_NPM:-}" ] || { echo "npm is not installed" >&2; exit 1; }
cd "$(dirname "$0")/../.." && mkdir -p build/report-assets
echo chart >build/report-assets/library.js
""",
    "scripts/build/package": """#!/bin/bash
set -e
case $DEBIAN in bookworm) number=12 ;; trixie) number=13 ;; esac
mkdir -p build/package/DEBIAN build/package/usr/bin
cp build/release/continua build/report-assets/library.js build/package/usr/bin
architecture=$(dpkg --print-architecture)
version=$(cat VERSION)-deb$number
printf '%s\\n' 'Package: continua' "Version: ${WRONG_PACKAGE:-$version}" "Architecture: $architecture" 'Maintainer: A <a@localhost>' \\
  'Description: none' >build/package/DEBIAN/control
dpkg-deb --root-owner-group --build build/package "build/release/continua_${version}_$architecture.deb"
""",
    "scripts/build/package-test": """#!/bin/bash
set -e
[ "$1-$3" = --package---folder ]
echo "use: ${2##*/}" >>"$CALLS"
[ -z "${FAILS:-}" ] || { echo "no such library"; exit 7; }
case $2 in *-deb12_*) debian=bookworm ;; *-deb13_*) debian=trixie ;; esac
dpkg-deb --extract "$2" "$4/package-$debian"
""",
    "scripts/build/manual": """#!/bin/bash
set -e
mkdir -p build/manual/html/reference
echo "<title>Continua ${WRONG_MANUAL:-$(cat VERSION)}</title>" >build/manual/html/index.html
echo "<span id=\\"projectnumber\\">&#160;$(cat VERSION)</span>" >build/manual/html/reference/index.html
""",
}
COPIED = [".gitattributes", "scripts/build/release", "scripts/lib/common.sh", "scripts/packages.txt"]


class Release(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = os.path.realpath(temporary.name)
        self.checkout = os.path.join(self.folder, "checkout")
        self.output = os.path.join(self.checkout, "build", "release-1.2.3")
        self.calls = os.path.join(self.folder, "calls")
        self.architecture = self.run_tool("dpkg", "--print-architecture", folder=self.folder).strip()
        for name in COPIED:
            os.makedirs(os.path.dirname(os.path.join(self.checkout, name)), exist_ok=True)
            shutil.copy(os.path.join(ROOT, name), os.path.join(self.checkout, name))
        for name, text in FILES.items():
            self.write(name, text)
            if text.startswith("#!"):
                os.chmod(os.path.join(self.checkout, name), 0o755)
        self.git("init", "--quiet")
        self.commit("First")

    def environment(self, **more):
        environment = {name: value for name, value in os.environ.items() if name != "CONTINUA_BUILD_ROOT"}
        environment.update(GIT_CONFIG_GLOBAL=os.devnull, GIT_CONFIG_NOSYSTEM="1", CALLS=self.calls, **more)
        for role in ("AUTHOR", "COMMITTER"):
            environment.update({f"GIT_{role}_NAME": "A", f"GIT_{role}_EMAIL": "a@localhost"})
        return environment

    def run_tool(self, *command, folder=None):
        return subprocess.run(command, cwd=folder or self.checkout, env=self.environment(), capture_output=True, text=True, check=True).stdout

    def git(self, *arguments):
        return self.run_tool("git", *arguments).strip()

    def commit(self, message):
        self.git("add", "--all")
        self.git("commit", "--quiet", "--message", message)

    def write(self, name, text):
        path = os.path.join(self.checkout, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)

    def text(self, path):
        with open(os.path.join(self.checkout, path), encoding="utf-8") as stream:
            return stream.read()

    def call(self, *arguments, checkout=None, **environment):
        script = os.path.join(checkout or self.checkout, "scripts", "build", "release")
        return subprocess.run([script, *arguments], cwd=self.folder, env=self.environment(**environment), capture_output=True,
                              text=True, check=False)

    def makes(self, *arguments, **environment):
        """The screen of a call that ends well."""
        done = self.call(*arguments, **environment)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def refuses(self, arguments, message, status=1, **environment):
        done = self.call(*arguments, **environment)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        self.assertIn(message, done.stderr)
        return done

    def package(self, number):
        return f"continua_1.2.3-deb{number}_{self.architecture}.deb"

    def listed(self):
        """The names in SHA256SUMS, whose checksums are right."""
        names = []
        for line in self.text(os.path.join(self.output, "SHA256SUMS")).splitlines():
            checksum, name = line.split("  ")
            with open(os.path.join(self.output, name), "rb") as stream:
                self.assertEqual(hashlib.sha256(stream.read()).hexdigest(), checksum, name)
            names.append(name)
        return sorted(names)

    def called(self):
        """What ran since the last question."""
        if not os.path.exists(self.calls):
            return []
        with open(self.calls, encoding="utf-8") as stream:
            lines = stream.read().splitlines()
        os.remove(self.calls)
        return lines

    def test_options(self):
        for arguments, message in ((["--upload"], "unknown option --upload (there are --output DIR"),
                                   (["--only", "book"], "unknown part book (there are source, packages, manual and checks)"),
                                   (["--debian", "sid"], "unknown release sid (there are bookworm and trixie)"),
                                   (["--output"], "--output needs a value"),
                                   (["--only", "manual", "--test"], "--test is a check")):
            done = self.refuses(arguments, message)
            self.assertEqual(done.stdout, "")
        self.assertIn("scripts/build/release [OPTION]...", self.makes("--help"))
        self.assertFalse(os.path.exists(self.output))

    def test_uncommitted_changes(self):
        self.write("forgotten.cc", "\n")
        self.refuses([], "these changes are not committed; commit them, or remove them:\n?? forgotten.cc")
        os.remove(os.path.join(self.checkout, "forgotten.cc"))
        self.write("scripts/test", "#!/bin/bash\nfalse\n")
        self.refuses([], " M scripts/test")
        self.assertFalse(os.path.exists(self.output))

    def test_versions(self):
        self.write("CITATION.cff", "version: 1.2.2\n")
        self.refuses([], "VERSION is 1.2.3, but CITATION.cff has version '1.2.2'")
        self.write("VERSION", "1.2\n")
        self.refuses([], "VERSION has '1.2', not three numbers")

    def test_no_checkout(self):
        shutil.rmtree(os.path.join(self.checkout, ".git"))
        self.refuses([], "is no git checkout")

    def test_tag(self):
        self.git("tag", "v1.2.3")
        self.makes("--only", "source")
        self.write("README.md", "Later.\n")
        self.commit("Second")
        self.refuses(["--only", "source"], "v1.2.3 is a tag of commit")

    def test_no_changelog(self):
        self.git("rm", "--quiet", "changelog/1.2.3.md")
        self.commit("Without the changelog")
        self.refuses([], "there is no changelog/1.2.3.md: scripts/build/release --notes collects its entries")

    def test_folders(self):
        self.refuses(["--output", os.path.join(self.checkout, "here")], "git would see")
        with open(os.path.join(self.folder, "precious"), "w", encoding="utf-8") as stream:
            stream.write("kept\n")
        self.refuses(["--output", self.folder], "is not empty and was not made by this script")
        other = os.path.join(self.folder, "other")
        self.makes("--only", "source", "--output", other)
        self.write("VERSION", "1.3.0\n")
        self.write("CITATION.cff", "version: 1.3.0\n")
        self.write("changelog/1.3.0.md", "# Continua 1.3.0\n")
        self.commit("Next")
        self.refuses(["--only", "source", "--output", other], f"{other} has release 1.2.3")
        self.assertTrue(os.path.exists(os.path.join(self.folder, "precious")))

    def test_source_archive(self):
        """The bytes depend on the commit alone, not on the place, the settings of git or the rights of new files."""
        self.makes("--only", "source")
        self.assertEqual(self.listed(), ["continua-1.2.3-changelog.md", "continua-1.2.3.tar.xz"])
        archive = os.path.join(self.output, "continua-1.2.3.tar.xz")
        with tarfile.open(archive) as stream:
            self.assertEqual(stream.extractfile("continua-1.2.3/REVISION").read().decode().strip(), self.git("rev-parse", "HEAD"))
            self.assertEqual({name for name in stream.getnames() if not name.startswith("continua-1.2.3/")}, {"continua-1.2.3"})
            self.assertEqual({member.mode & 0o022 for member in stream}, {0})
        clone = os.path.join(self.folder, "clone")
        self.run_tool("git", "clone", "--quiet", self.checkout, clone)
        for setting, value in (("core.autocrlf", "true"), ("tar.umask", "0002")):
            self.run_tool("git", "config", setting, value, folder=clone)
        second = os.path.join(self.folder, "second")
        done = self.call("--only", "source", "--output", second, checkout=clone)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(archive, "rb") as one, open(os.path.join(second, "continua-1.2.3.tar.xz"), "rb") as another:
            self.assertEqual(one.read(), another.read())

    def test_all(self):
        text = self.makes("--test")
        self.assertIn("The release is complete, and every check was made.", text)
        self.assertEqual(self.listed(), sorted([self.package(12), self.package(13), "continua-1.2.3-changelog.md",
                                                "continua-1.2.3-manual.tar.xz", "continua-1.2.3.tar.xz"]))
        line = f"Continua 1.2.3 ({self.git('rev-parse', 'HEAD')})"
        for name in ("quickstart-bookworm", "quickstart-trixie", "use-bookworm", "use-trixie"):
            self.assertIn(line, self.text(os.path.join(self.output, "logs", name + ".log")))
        # The library of the reports' curves, which a clean root cannot bring.
        for number in (12, 13):
            self.assertIn("./usr/bin/library.js", self.run_tool("dpkg-deb", "--contents", os.path.join(self.output, self.package(number))))
        with tarfile.open(os.path.join(self.output, "continua-1.2.3-manual.tar.xz")) as stream:
            self.assertIn("continua-1.2.3-manual/reference/index.html", stream.getnames())
        check = f"build/release/continua --version | grep -xF '{line}'"
        use = f"continua --version | grep -xF '{line}'"
        self.assertEqual(self.called(), [
            f"bookworm: scripts/quickstart {check}", "bookworm: scripts/build/package", f"trixie: scripts/quickstart {check}",
            "trixie: scripts/build/package", "bookworm: scripts/build/manual", f"use: {self.package(12)}", f"bookworm: {use}",
            f"use: {self.package(13)}", f"trixie: {use}", "bookworm: scripts/test", "trixie: scripts/test"])

        # Again: nothing. With a package less: it and its use.
        self.assertIn("every check was made", self.makes())
        self.assertEqual(self.called(), [])
        with open(os.path.join(self.output, self.package(13)), "ab") as stream:
            stream.write(b"damaged")
        self.makes()
        self.assertEqual(self.called()[0], "trixie: scripts/build/package")
        self.assertIn(self.package(13), self.listed())

        # Another commit: what is of the old one goes.
        self.write("README.md", "Later.\n")
        self.commit("Second")
        text = self.makes("--only", "source")
        self.assertIn("all of it is made again", text)
        self.assertIn(f"Not made yet: {self.package(12)} {self.package(13)} continua-1.2.3-manual.tar.xz", text)
        self.assertEqual(self.listed(), ["continua-1.2.3-changelog.md", "continua-1.2.3.tar.xz"])
        self.assertFalse(os.path.exists(os.path.join(self.output, self.package(12))))

    def test_goes_on_after_a_failure(self):
        done = self.refuses(["--debian", "trixie"], "the step use-trixie did not end well", 7, FAILS="yes")
        self.assertIn("no such library", done.stdout)
        self.assertIn("no such library", self.text(os.path.join(self.output, "logs", "use-trixie.log")))
        self.called()
        text = self.makes("--debian", "trixie")
        self.assertEqual(self.called()[0], f"use: {self.package(13)}")
        self.assertIn("Not made yet: " + self.package(12), text)
        self.assertIn("Not checked yet: quickstart-bookworm use-bookworm test-bookworm test-trixie", text)

    def test_report_assets_are_missing(self):
        self.refuses(["--only", "packages"], "npm is not installed", NO_NPM="yes")
        self.assertEqual(self.called(), [])

    def test_parts(self):
        self.makes("--only", "manual", "--debian", "bookworm")
        self.assertEqual([line.split()[:2] for line in self.called()],
                         [["bookworm:", "scripts/quickstart"], ["bookworm:", "scripts/build/manual"]])
        self.makes("--only", "packages", "--debian", "bookworm")
        self.assertEqual(self.called(), ["bookworm: scripts/build/package"])
        self.makes("--only", "checks", "--debian", "bookworm")
        self.assertEqual(self.called()[0], f"use: {self.package(12)}")

    def test_what_does_not_agree(self):
        self.refuses(["--only", "packages"], "the step quickstart-bookworm did not end well", WRONG_REVISION="0" * 40)
        shutil.rmtree(os.path.join(self.checkout, "build", "clean-root"))
        done = self.refuses(["--only", "packages"], "the step package-bookworm did not end well", WRONG_PACKAGE="1.2.2-deb12")
        self.assertIn("continua_1.2.3-deb12_amd64.deb has version 1.2.2-deb12".replace("amd64", self.architecture), done.stdout)
        done = self.refuses(["--only", "manual"], "the step manual did not end well", WRONG_MANUAL="1.2.2")
        self.assertIn("index.html of the manual does not name version 1.2.3", done.stdout)
        self.assertEqual(self.called()[-1], "bookworm: scripts/build/manual")

    def test_notes(self):
        self.git("rm", "--quiet", "changelog/1.2.3.md")
        self.write("changelog/README.md", "No entry.\n")
        self.write("changelog/2026-02-03-second.md", "Second,\nof two lines.\n")
        self.write("changelog/2026-10-01-newest.md", "Newest.\n")
        self.commit("Changes")
        self.write("changelog/2026-02-03-first.md", "First.\n")
        text = self.makes("--notes")
        self.assertIn("changelog/1.2.3.md: 3 entries, newest first: changelog/2026-10-01-newest.md to changelog/2026-02-03-second.md.", text)
        self.assertEqual(self.text("changelog/1.2.3.md"), "# Continua 1.2.3\n\n- Newest.\n- First.\n- Second,\n  of two lines.\n")
        self.assertEqual(sorted(os.listdir(os.path.join(self.checkout, "changelog"))), ["1.2.3.md", "README.md"])
        self.refuses(["--notes"], "there is nothing to collect")
        self.commit("Changelog of 1.2.3")
        self.makes("--only", "source")

        self.write("changelog/2026-10-02-late.md", "Late.\n")
        self.commit("Late")
        self.refuses(["--only", "source"], "these entries are not in changelog/1.2.3.md; scripts/build/release --notes puts them there:\n"
                     "changelog/2026-10-02-late.md")
        self.assertIn("1 entries, newest first, put before what was there", self.makes("--notes"))
        self.assertEqual(self.text("changelog/1.2.3.md"),
                         "# Continua 1.2.3\n\n- Late.\n- Newest.\n- First.\n- Second,\n  of two lines.\n")


if __name__ == "__main__":
    unittest.main()
