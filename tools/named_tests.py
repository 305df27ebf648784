"""Where a number stands in a test: the test's name, found by the habits of each kind of file."""
import re

from requirements import ID

# Files that are a test as a whole, whatever stands above their first one.
WHOLE = (".scn", "_test.py", ".spec.mjs")
CHECKED = ("//=", "//!")  # in a program: what holds, what must be refused

GTEST = re.compile(r"\s*(?:TEST|TEST_F|TEST_P|TYPED_TEST|RC_GTEST_PROP)\(\s*(\w+)\s*,\s*(\w+)")
SCENARIO = re.compile(r'\s*scenario\s+"([^"]*)"')
COMMENT = {".scn": "#", ".cpp": "//"}


def named_tests(path, text):
    """(number, name of the test or "") for each number in a file; a comment counts for the test below it."""
    opening = {".cpp": GTEST, ".scn": SCENARIO}.get(path.suffix)
    if opening is None:
        return [(number, "") for number in dict.fromkeys(ID.findall(text))]
    found, waiting, current = [], [], ""
    for line in text.splitlines():
        begins = opening.match(line)
        if begins:
            current = ".".join(begins.groups())
            found += [(number, current) for number in waiting]
            waiting = []
        elif current and line.startswith("}"):
            current = ""
        elif waiting and line.strip() and not line.lstrip().startswith(COMMENT[path.suffix]):
            found += [(number, "") for number in waiting]
            waiting = []
        numbers = ID.findall(line)
        ahead = not begins and line.startswith(COMMENT[path.suffix])
        if numbers and (ahead or not current):
            waiting += numbers
        else:
            found += [(number, current) for number in numbers]
    found += [(number, "") for number in waiting]
    return list(dict.fromkeys(found))


def shown(path, text):
    """Of these only what can fail: a number beside a named test, in a file of tests, in a program that checks itself or has a
    scenario of its name beside it. A word in a README, a project file, a helper or a table shows nothing."""
    found = named_tests(path, text)
    if path.name.endswith(WHOLE) or (path.suffix in (".awl", ".s5") and is_checked(path, text)):
        return found
    return [(number, test) for number, test in found if test]


def is_checked(path, text):
    return any(mark in text for mark in CHECKED) or path.with_suffix(".scn").exists()
