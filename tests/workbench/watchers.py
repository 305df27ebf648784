#!/usr/bin/env python3
"""usage: watchers.py MERKER PROJECT [BROWSERS [SECONDS]]

What watching browsers cost: the processor time of `merker run PROJECT` in one second, in percent of a core, without browsers and
with so many that each see the state and a list of 100 flags, inputs and outputs at 30 frames a second."""
import os
import re
import select
import subprocess
import sys
import time

from web_socket import Browser


def used(pid):
    fields = open(f"/proc/{pid}/stat", encoding="ascii").read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def measure(pid, sockets, seconds):
    begin, start, end = used(pid), time.monotonic(), time.monotonic() + seconds
    received = 0
    while (left := end - time.monotonic()) > 0:
        for one in select.select(sockets, [], [], min(left, 0.1))[0]:
            received += len(one.recv(1 << 16))
    passed = time.monotonic() - start
    return 100 * (used(pid) - begin) / passed, received / passed


def main():
    merker, project = sys.argv[1:3]
    browsers, seconds = int((sys.argv[3:4] or [20])[0]), float((sys.argv[4:5] or [10])[0])
    process = subprocess.Popen([merker, "run", project, "--port", "0"], stdout=subprocess.PIPE, text=True)
    port = int(re.search(r":(\d+)/", process.stdout.readline()).group(1))
    operands = [f"MB {i}" for i in range(80)] + [f"E {i}.{j}" for i in range(2) for j in range(8)] + ["A 1.0", "A 1.1", "A 1.2", "MW 0"]
    try:
        alone, _ = measure(process.pid, [], seconds)
        sockets = []
        for _ in range(browsers):
            browser = Browser(port)
            browser.call("watch.set", list=1, items=[{"operand": operand} for operand in operands])
            sockets.append(browser.socket)
        watched, rate = measure(process.pid, sockets, seconds)
        print(f"alone {alone:.1f} %, with {browsers} browsers {watched:.1f} %: they cost {watched - alone:.1f} % of a core; {rate / 1000:.0f} kB/s")
    finally:
        process.terminate()
        process.wait(20)


main()
