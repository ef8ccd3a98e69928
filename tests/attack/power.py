"""What a loss of power leaves of a folder, from the record of the operations on it.

Of a file the bytes are kept that were there when it was flushed last (fsync); of one that was never flushed nothing but
its name. With `names`, what was done to the names in a folder since the folder itself was flushed is undone, too: new
files and folders vanish, renames are taken back, removed files return. POSIX promises no more."""

import os
import shutil


def read_log(path):
    """[(operation, file, number, [details])]."""
    try:
        with open(path, encoding="utf-8", errors="surrogateescape") as stream:
            lines = stream.read().splitlines()
    except FileNotFoundError:
        return []
    return [(fields[0], fields[1], int(fields[2]), fields[3:]) for fields in (line.split("\t") for line in lines)]


def has_complete_checkpoint(log, flushed):
    """Whether a checkpoint had been named; `flushed`: and its name had reached the disk."""
    named = False
    for operation, file, _, details in log:
        if operation == "rename" and details and details[0] == "out/checkpoint/current":
            named = True
            if not flushed:
                return True
        if named and operation == "fsync" and file == "out/checkpoint":
            return True
    return False


class Disk:
    """What of a folder is on the disk."""

    def __init__(self, output):
        self.output = output
        self.flushed = {}     # file -> bytes of it that are on the disk
        self.changed = set()  # files that were written to since
        # The folder itself stays: the one that it stands in is not looked at.
        self.folders = {"out"}
        self.names = []       # what was done to names, in order, and is not on the disk
        for path, folders, files in os.walk(output):
            at = "out" if path == output else "out/" + os.path.relpath(path, output)
            self.folders.update(f"{at}/{name}" for name in folders)
            for name in files:
                self.flushed[f"{at}/{name}"] = os.path.getsize(os.path.join(path, name))

    def path(self, file):
        return os.path.join(self.output, os.path.relpath(file, "out"))

    def follow(self, log):
        for operation, file, _, details in log:
            if operation == "fault" or file != "out" and not file.startswith("out/"):
                continue
            if operation == "open" and details[0] != "read":
                self.open(file, details[0])
            elif operation == "write":
                self.changed.add(file)
            elif operation == "fsync":
                self.flush(file, int(details[0] or 0))
            elif operation == "rename":
                self.rename(file, details[0], int(details[1]))
            elif operation == "unlink":
                self.forget(file)
                self.names.append(("unlink", file, int(details[0])))
            elif operation == "mkdir" and file not in self.folders:
                self.folders.add(file)
                self.names.append(("mkdir", file))
            elif operation == "rmdir":
                self.folders.discard(file)
                self.names.append(("rmdir", file))
        return self

    def open(self, file, how):
        if file not in self.flushed:
            self.flushed[file] = 0
            self.names.append(("create", file))
        if how == "new":
            self.flushed[file] = 0
            self.changed.add(file)

    def flush(self, file, size):
        if file in self.folders:
            self.names = [entry for entry in self.names if os.path.dirname(self.place(entry)) != file]
        else:
            self.flushed[file] = size
            self.changed.discard(file)

    @staticmethod
    def place(entry):
        return entry[2] if entry[0] == "rename" else entry[1]

    def rename(self, old, new, shadow):
        self.flushed[new] = self.flushed.pop(old, 0)
        self.changed.discard(new)
        if old in self.changed:
            self.changed.discard(old)
            self.changed.add(new)
        self.names.append(("rename", old, new, shadow))

    def forget(self, file):
        self.flushed.pop(file, None)
        self.changed.discard(file)

    def lose_power(self, names, shadow):
        """Makes the folder what it would be; a list of what was changed."""
        done = []
        for file in sorted(self.changed):
            path = self.path(file)
            if os.path.isfile(path) and os.path.getsize(path) > self.flushed.get(file, 0):
                os.truncate(path, self.flushed.get(file, 0))
                done.append(f"{file} cut to {self.flushed.get(file, 0)} bytes")
        for entry in reversed(self.names if names else []):
            self.undo(entry, shadow)
            done.append("undone: " + " ".join(map(str, entry)))
        return done

    def undo(self, entry, shadow):
        path = self.path(entry[1])
        kept = os.path.join(shadow, str(entry[-1]))
        if entry[0] == "create" and os.path.isfile(path):
            os.remove(path)
        elif entry[0] == "mkdir":
            shutil.rmtree(path, ignore_errors=True)
        elif entry[0] == "rmdir":
            os.makedirs(path, exist_ok=True)
        elif entry[0] == "unlink" and entry[2] >= 0 and os.path.isdir(os.path.dirname(path)):
            shutil.copyfile(kept, path)
        elif entry[0] == "rename" and os.path.exists(self.path(entry[2])):
            os.rename(self.path(entry[2]), path)
            if entry[3] >= 0:
                shutil.copyfile(kept, self.path(entry[2]))
