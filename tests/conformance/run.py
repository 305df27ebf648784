#!/usr/bin/env python3
"""Runs the conformance programs: self-checking sources, scenarios and sources that must be rejected.

usage: run.py MERKER [--engine jit] [--filter TEXT] [--verbose]
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
MARK = re.compile(r"//!\s*(error|warning)(?:\s+(P\d{4})\s+(\d+)-(\d+))?")
TIMEOUT = 120  # seconds of this machine; a program runs at most 10 s of virtual time

def call(merker, *arguments):
    """Exit code and both outputs of one call."""
    try:
        done = subprocess.run([merker, *arguments], capture_output=True, text=True, errors="replace",
                              timeout=TIMEOUT, check=False)
    except subprocess.TimeoutExpired:
        return None, "", f"no end within {TIMEOUT} s"
    return done.returncode, done.stdout, done.stderr

def test(merker, path, engine):
    """Problems of a self-checking program or a scenario; none if it passed."""
    cpu = ["--cpu", "generic-4"] if "_generic4" in path.stem else []
    code, out, err = call(merker, "test", *cpu, "--engine", engine, str(path))
    if code == 0 and not re.search(r"\b0 passed", out):
        return []
    return [f"exit code {code}", *(out + err).strip().splitlines()]

def wanted(path):
    """(line, severity) of every marked line -> code, first and last column, as far as the mark says them."""
    marks = {}
    for number, text in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if mark := MARK.search(text):
            marks[number, mark[1]] = (mark[2], int(mark[3]), int(mark[4])) if mark[2] else None
    return marks

def reported(text):
    """(line, severity) -> message, code, first and last column of the first such problem in the JSON output."""
    data = json.loads(text)
    seen = {}
    for p in data["problems"] if isinstance(data, dict) else data:
        place = p["code"], p["column"], p["column"] + max(p["length"], 1) - 1
        seen.setdefault((p["line"], p["severity"]), (p["message"], place))
    return seen

def differences(marks, seen):
    """What is missing, what is too much, what has another code or place."""
    for line, severity in sorted(marks.keys() - seen.keys()):
        yield f"line {line}: no {severity}"
    for line, severity in sorted(seen.keys() - marks.keys()):
        yield f"line {line}: unexpected {severity}: {seen[line, severity][0]}"
    for line, severity in sorted(marks.keys() & seen.keys()):
        mark, place = marks[line, severity], seen[line, severity][1]
        if mark and mark != place:
            yield "line {}: {} {}-{} instead of {} {}-{}".format(line, *place, *mark)

def check(merker, path, _engine):
    """Problems of a source that must be rejected."""
    code, out, err = call(merker, "check", "--json", str(path))
    try:
        seen = reported(out)
    except (ValueError, KeyError, TypeError) as error:
        return [f"exit code {code}, output is not the expected JSON ({error})", *(out + err).splitlines()[:5]]
    marks = wanted(path)
    failures = list(differences(marks, seen))
    expected = 1 if any(severity == "error" for _, severity in marks) else 0
    if not failures and code != expected:
        failures.append(f"exit code {code} instead of {expected}")
    return failures

def cases():
    """Every file with the function that judges it."""
    for path in sorted(HERE.rglob("*")):
        if path.suffix == ".scn":
            yield path, test
        elif path.suffix in (".awl", ".s5") and "rejected" in path.parts:
            yield path, check
        elif path.suffix in (".awl", ".s5") and "//=" in path.read_text(encoding="utf-8"):
            yield path, test

def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("merker", help="the program under test")
    parser.add_argument("--engine", choices=["interpreter", "jit"], default="interpreter")
    parser.add_argument("--filter", default="", help="only files whose path contains this")
    parser.add_argument("--verbose", action="store_true", help="print every line of a failure")
    arguments = parser.parse_args()
    passed = failed = 0
    for path, judge in cases():
        name = path.relative_to(HERE).as_posix()
        if arguments.filter not in name or (arguments.engine == "jit" and judge is not test):
            continue
        failures = judge(arguments.merker, path, arguments.engine)
        if not failures:
            passed += 1
            continue
        failed += 1
        print(f"FAILED {name}")
        if os.environ.get("MERKER_FAIL_FAST"):  # tools/mutate wants to know nothing else
            break
        for line in failures if arguments.verbose else failures[:8]:
            print("    " + line)
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0

if __name__ == "__main__":
    sys.exit(main())
