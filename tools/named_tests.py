"""Where a number stands in a test: the test's name, found by the habits of each kind of file."""
import re

from requirements import ID

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
