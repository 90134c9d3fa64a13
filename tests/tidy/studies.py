"""Checks that each study of CTest which selects test cases by their names selects some."""

import fnmatch
import re

FILTER = re.compile(r"--test-case=([^\"\n)]+)")
TEST_CASE = re.compile(r"TEST_CASE(?:_TEMPLATE|_FIXTURE)?\([^\"]*\"((?:[^\"\\]|\\.)*)\"")


def case_names(folder, texts):
    """Returns the names, in small letters, of the test cases in the C++ files below the folder."""
    return [name.lower() for file, text in texts.items() if file.startswith(folder) and file.endswith(".cpp")
            for name in TEST_CASE.findall(text)]


def faults(texts):
    """Returns a sentence for each pattern that selects no test case: doctest would run nothing, and call it success."""
    for file, text in texts.items():
        if not file.endswith("/CMakeLists.txt"):
            continue
        names = case_names(file.removesuffix("CMakeLists.txt"), texts)
        for pattern in (each for filtered in FILTER.findall(text) for each in filtered.split(",")):
            if not fnmatch.filter(names, pattern.strip().lower()):
                yield f'{file}: no test case has a name like "{pattern.strip()}"'
