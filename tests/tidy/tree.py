"""Lists the files of the source tree."""

import os
import pathlib
import subprocess

SKIPPED = {".git", "build", "__pycache__"}


def names(top):
    """Returns paths relative to `top`: tracked files and new ones not ignored; without git, all files outside
    builds."""
    listing = ["git", "-C", str(top), "ls-files", "--cached", "--others", "--exclude-standard", "-z"]
    try:
        found = subprocess.run(listing, capture_output=True, text=True, check=True).stdout.split("\0")
    except (OSError, subprocess.CalledProcessError):
        found = [os.path.relpath(os.path.join(folder, file), top)
                 for folder, folders, files in os.walk(top)
                 if not set(pathlib.Path(folder).relative_to(top).parts) & SKIPPED
                 for file in files]
    return sorted(name for name in set(found) if name and os.path.isfile(os.path.join(top, name)))


def is_cpp(name):
    return name.endswith((".cpp", ".hpp"))
