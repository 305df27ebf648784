#!/usr/bin/env python3
"""usage: check.py RULE   Checks one rule of rules.py over the repository; exit 1 and the findings if it is broken."""
import pathlib
import sys

from rules import RULES

root = pathlib.Path(__file__).resolve().parent.parent.parent
findings = list(RULES[sys.argv[1]](root))
print("\n".join(findings) if findings else f"{sys.argv[1]}: holds")
sys.exit(1 if findings else 0)
