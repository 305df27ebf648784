"""Calls the program under test (environment variable MERKER) in a folder of its own."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

GOOD, PROBLEMS, USAGE, FAULT, UNREADABLE = 0, 1, 2, 3, 4

# A 0.0 follows E 0.0, A 0.1 comes 2 s after it, MW 20 counts cycles, E 0.7 leads to a fault.
PROGRAM = """ORGANIZATION_BLOCK OB 1
TITLE = Main
VERSION : 1.2
BEGIN
NETWORK
      U     E 0.0
      =     A 0.0
      L     S5T#2S
      SE    T 1
      U     T 1
      =     A 0.1
      L     MW 20
      +     1
      T     MW 20
      UN    E 0.7
      SPB   good
      L     W#16#FFFF
      BTI
good: NOP   0
END_ORGANIZATION_BLOCK
"""

DATA = """DATA_BLOCK DB 1
STRUCT
  count : INT := 5;
  level : REAL := 1.5;
  pause : TIME := T#5S;
  list : ARRAY [1..3] OF WORD := W#16#1, W#16#2, W#16#3;
  on : BOOL := TRUE;
  start : DATE_AND_TIME := DT#1998-04-14-17:53:17.333;
  text : STRING [8] := 'ab$'c';
END_STRUCT
BEGIN
END_DATA_BLOCK
"""


def block(instructions, number=1):
    return f"ORGANIZATION_BLOCK OB {number}\nBEGIN\nNETWORK\n{instructions}\nEND_ORGANIZATION_BLOCK\n"


class Call:
    def __init__(self, done):
        self.code, self.out, self.err = done.returncode, done.stdout, done.stderr

    @property
    def lines(self):
        return self.out.splitlines()

    @property
    def json(self):
        return json.loads(self.out)


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="merker-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content, encoding="utf-8")
        return name

    def read(self, name):
        return (self.folder / name).read_text(encoding="utf-8")

    def merker(self, *arguments, text=None, timeout=300):
        return Call(subprocess.run([os.environ["MERKER"], *arguments], cwd=self.folder, input=text or "",
                                   capture_output=True, encoding="utf-8", errors="replace", timeout=timeout, check=False))

    def expect(self, code, *arguments, **options):
        """The call, which must end with this exit code."""
        call = self.merker(*arguments, **options)
        self.assertEqual(call.code, code, f"{arguments}\n{call.out}\n{call.err}")
        return call
