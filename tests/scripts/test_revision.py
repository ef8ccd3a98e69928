#!/usr/bin/python3
"""cmake/revision.cmake: the revision of a checkout, of a changed one, of an unpacked source archive, and of neither."""

import os
import shutil
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def run(*command, folder):
    environment = {**os.environ, "GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_NOSYSTEM": "1"}
    for role in ("AUTHOR", "COMMITTER"):
        environment.update({f"GIT_{role}_NAME": "A", f"GIT_{role}_EMAIL": "a@localhost"})
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, check=True).stdout


class Revision(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.checkout = os.path.join(self.temporary.name, "checkout")
        os.mkdir(self.checkout)
        for name in ("REVISION", ".gitattributes"):
            shutil.copy(os.path.join(ROOT, name), self.checkout)
        if os.path.exists(os.path.join(ROOT, ".git")): # of an unpacked archive REVISION is written already
            self.assertIn("$Format:%H$", self.text(os.path.join(self.checkout, "REVISION")))
        else:
            with open(os.path.join(self.checkout, "REVISION"), "w", encoding="utf-8") as stream:
                stream.write("$Format:%H$\n")
        run("git", "init", "--quiet", folder=self.checkout)
        run("git", "add", "--all", folder=self.checkout)
        run("git", "commit", "--quiet", "--message", "First", folder=self.checkout)
        self.commit = run("git", "rev-parse", "HEAD", folder=self.checkout).decode().strip()

    def text(self, path):
        with open(path, encoding="utf-8") as stream:
            return stream.read()

    def written(self, folder):
        """What the build of a source in FOLDER writes."""
        output = os.path.join(self.temporary.name, "revision.inc")
        run("cmake", f"-DSOURCE_DIR={folder}", "-DVERSION=1.2.3", f"-DOUTPUT={output}", "-P",
            os.path.join(ROOT, "cmake", "revision.cmake"), folder=self.temporary.name)
        return self.text(output)

    def expected(self, revision, dirty="false"):
        return ('#define CONTINUA_VERSION "1.2.3"\n'
                f'#define CONTINUA_REVISION "{revision}"\n#define CONTINUA_DIRTY {dirty}\n')

    def test_checkout(self):
        self.assertEqual(self.written(self.checkout), self.expected(self.commit))

    def test_changed_checkout(self):
        with open(os.path.join(self.checkout, ".gitattributes"), "a", encoding="utf-8") as stream:
            stream.write("# changed\n")
        self.assertEqual(self.written(self.checkout), self.expected(self.commit, "true"))

    def test_archive_inside_another_repository(self):
        run("git", "archive", "--prefix=archive/", "--output=../archive.tar", "HEAD", folder=self.checkout)
        run("git", "init", "--quiet", folder=self.temporary.name)
        run("git", "commit", "--quiet", "--allow-empty", "--message", "Another", folder=self.temporary.name)
        run("tar", "--extract", "--file=archive.tar", folder=self.temporary.name)
        self.assertEqual(self.written(os.path.join(self.temporary.name, "archive")), self.expected(self.commit))

    def test_copy_without_revision(self):
        shutil.rmtree(os.path.join(self.checkout, ".git"))
        self.assertEqual(self.written(self.checkout), self.expected("unknown"))
        os.remove(os.path.join(self.checkout, "REVISION"))
        self.assertEqual(self.written(self.checkout), self.expected("unknown"))


if __name__ == "__main__":
    unittest.main()
